#pragma once

#include <sinew/kernels/kernel.hpp>

namespace sinew {

/// In 2 and 3 dimensions W = a / R^D (1 - q)^4 (1 + 4 q), a = 7/pi and 21/(2 pi); in one W = 5/(4 R) (1 - q)^3 (1 + 3 q); q = r /
/// R. Wendland (1995); scaled as in Dehnen & Aly (2012), table 1.
struct WendlandC2 {
  static constexpr std::string_view name = "wendland_c2";
  static constexpr std::string_view summary = "Wendland's function with two continuous derivatives";
  static constexpr std::string_view source = "Wendland (1995)";
  static constexpr double customary_h = 2.0;
  static void describe(auto&&, auto&) {}

  template <int D, class T, class Radius>
  static SINEW_INLINE T value(const T& r, const Radius& R) {
    const Radius inverse = 1.0 / R;
    const T q = r * inverse;
    return Radius(factor<D>) * power<D>(inverse) * power<order<D>>(positive_part(T(1.0) - q)) * (T(1.0) + T(order<D>) * q);
  }
  template <int D, class T, class Radius>
  static SINEW_INLINE T slope(const T& r, const Radius& R) {
    const Radius inverse = 1.0 / R;
    const T q = r * inverse;
    constexpr double steepness = order<D> * (order<D> + 1.0);
    return Radius(-steepness * factor<D>) * power<D + 1>(inverse) * q * power<order<D> - 1>(positive_part(T(1.0) - q));
  }

 private:
  template <int D>
  static constexpr int order = D == 1 ? 3 : 4;
  template <int D>
  static constexpr double factor = D == 1 ? 1.25 : (D == 2 ? 7.0 : 10.5) / std::numbers::pi;
};

}  // namespace sinew
