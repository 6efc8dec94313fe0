#pragma once

#include <sinew/kernels/kernel.hpp>

namespace sinew {

/// W = a / R^D [(1 - q)_+^5 - 6 (2/3 - q)_+^5 + 15 (1/3 - q)_+^5], q = r / R; a = 3^5/40, 7 * 3^7/(478 pi), 3^7/(40 pi) in 1, 2,
/// 3 dimensions. Morris (1996), where R = 3 h; Ren et al. (2020), eq. 19, call R the smoothing length and leave out the factor
/// 1/R^D.
struct QuinticSpline {
  static constexpr std::string_view name = "quintic_spline";
  static constexpr std::string_view summary = "Quintic B-spline in three pieces";
  static constexpr std::string_view source = "Morris (1996); Ren et al. (2020), eq. 19";
  static constexpr double customary_h = 3.0;
  static void describe(auto&&, auto&) {}

  template <int D, class T, class Radius>
  static SINEW_INLINE T value(const T& r, const Radius& R) {
    const Radius inverse = 1.0 / R;
    return Radius(factor<D>) * power<D>(inverse) * pieces<5>(r * inverse);
  }
  template <int D, class T, class Radius>
  static SINEW_INLINE T slope(const T& r, const Radius& R) {
    const Radius inverse = 1.0 / R;
    return Radius(-5.0 * factor<D>) * power<D + 1>(inverse) * pieces<4>(r * inverse);
  }

 private:
  template <int D>
  static constexpr double factor = D == 1   ? 243.0 / 40.0
                                   : D == 2 ? 7.0 * 2187.0 / (478.0 * std::numbers::pi)
                                            : 2187.0 / (40.0 * std::numbers::pi);
  template <int n, class T>
  static SINEW_INLINE T pieces(const T& q) {
    return power<n>(positive_part(T(1.0) - q)) - T(6.0) * power<n>(positive_part(T(2.0 / 3.0) - q)) +
           T(15.0) * power<n>(positive_part(T(1.0 / 3.0) - q));
  }
};

}  // namespace sinew
