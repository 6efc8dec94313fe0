#pragma once

#include <sinew/kernels/kernel.hpp>

namespace sinew {

/// W = s / h^D [(2 - q)_+^3 / 4 - (1 - q)_+^3], q = r / h, h = R / 2; s = 2/3, 10/(7 pi), 1/pi in 1, 2, 3 dimensions.
/// Monaghan & Lattanzio (1985).
struct CubicSpline {
  static constexpr std::string_view name = "cubic_spline";
  static constexpr std::string_view summary = "Cubic B-spline in two pieces";
  static constexpr std::string_view source = "Monaghan & Lattanzio (1985)";
  static constexpr double customary_h = 2.0;
  static void describe(auto&&, auto&) {}

  template <int D, class T, class Radius>
  static SINEW_INLINE T value(const T& r, const Radius& R) {
    const Radius inverse = 2.0 / R;
    const T q = r * inverse;
    const T shape = T(0.25) * power<3>(positive_part(T(2.0) - q)) - power<3>(positive_part(T(1.0) - q));
    return Radius(factor<D>) * power<D>(inverse) * shape;
  }
  template <int D, class T, class Radius>
  static SINEW_INLINE T slope(const T& r, const Radius& R) {
    const Radius inverse = 2.0 / R;
    const T q = r * inverse;
    const T shape = T(0.25) * power<2>(positive_part(T(2.0) - q)) - power<2>(positive_part(T(1.0) - q));
    return Radius(-3.0 * factor<D>) * power<D + 1>(inverse) * shape;
  }

 private:
  template <int D>
  static constexpr double factor = D == 1 ? 2.0 / 3.0 : (D == 2 ? 10.0 / 7.0 : 1.0) / std::numbers::pi;
};

}  // namespace sinew
