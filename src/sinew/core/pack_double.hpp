#pragma once
/// The functions of Pack for one double, so that point-wise physics is written once.

#include <cmath>
#include <sinew/core/device.hpp>

namespace sinew {

SINEW_INLINE double select(bool mask, double yes, double no) { return mask ? yes : no; }
SINEW_INLINE double min(double a, double b) { return b < a ? b : a; }
SINEW_INLINE double max(double a, double b) { return a < b ? b : a; }
SINEW_INLINE bool any(bool m) { return m; }
SINEW_INLINE bool all(bool m) { return m; }
SINEW_INLINE double cbrt(double x) { return std::cbrt(x); }
SINEW_INLINE double inverse_sqrt(double x) { return 1.0 / std::sqrt(x); }

}  // namespace sinew
