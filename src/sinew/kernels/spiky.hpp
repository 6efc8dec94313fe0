#pragma once

#include <sinew/kernels/kernel.hpp>

namespace sinew {

/// W = a (1 - q)^3 / R^D, q = r / R; a = 2, 10/pi, 15/pi in 1, 2, 3 dimensions. The slope does not vanish at r = 0.
/// Desbrun & Gascuel (1996); used by Ganzenmueller (2015).
struct Spiky {
  static constexpr std::string_view name = "spiky";
  static constexpr std::string_view summary = "Cubic kernel with a cusp at its center";
  static constexpr std::string_view source = "Desbrun & Gascuel (1996)";
  static constexpr double customary_h = 1.0;
  static void describe(auto&&, auto&) {}

  template <int D, class T, class Radius>
  static SINEW_INLINE T value(const T& r, const Radius& R) {
    const Radius inverse = 1.0 / R;
    return Radius(factor<D>) * power<D>(inverse) * power<3>(positive_part(T(1.0) - r * inverse));
  }
  template <int D, class T, class Radius>
  static SINEW_INLINE T slope(const T& r, const Radius& R) {
    const Radius inverse = 1.0 / R;
    return Radius(-3.0 * factor<D>) * power<D + 1>(inverse) * power<2>(positive_part(T(1.0) - r * inverse));
  }

 private:
  template <int D>
  static constexpr double factor = D == 1 ? 2.0 : (D == 2 ? 10.0 : 15.0) / std::numbers::pi;
};

}  // namespace sinew
