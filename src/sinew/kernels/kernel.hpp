#pragma once
/// What every kernel offers: W(r) and dW/dr for a SUPPORT RADIUS R (W = 0 for r >= R), normalized so that the integral of W over
/// the D-dimensional space is 1. Customary smoothing lengths are converted where a case is read, never here.
///
///     struct Name {
///       static constexpr std::string_view name, summary, source;
///       static constexpr double customary_h;         // R / h in the literature of this kernel
///       static void describe(auto&& field, auto& m);
///       template <int D, class T, class Radius> static T value(const T& r, const Radius& R);   // [1/length^D], r >= 0
///       template <int D, class T, class Radius> static T slope(const T& r, const Radius& R);   // [1/length^(D+1)], <= 0
///     };
///
/// `value` and `slope` carry SINEW_INLINE, so that a device has them too (tools/check_device.py).
/// `T` is double, Pack or Dual; `Radius` is double, or Pack for one radius a lane. No kernel branches: pieces are positive parts.

#include <numbers>
#include <sinew/core/pack.hpp>
#include <string_view>

namespace sinew {

/// x^n for a whole n >= 0.
template <int n, class T>
SINEW_INLINE T power(const T& x) {
  if constexpr (n == 0)
    return T(1.0);
  else if constexpr (n == 1)
    return x;
  else if constexpr (n % 2 == 0)
    return power<n / 2>(x * x);
  else
    return x * power<n - 1>(x);
}

/// The larger of x and 0.
template <class T>
SINEW_INLINE T positive_part(const T& x) {
  return max(x, T(0.0));
}

}  // namespace sinew
