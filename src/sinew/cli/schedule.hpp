#pragma once
/// When something is due that happens every so often.

#include <cmath>

namespace sinew {

/// Whether a multiple of `every` lies in (before, after]; never for every = 0. A multiple that is missed by rounding counts as reached.
inline bool multiple_reached(double before, double after, double every) {
  constexpr double rounding = 1e-9;
  return every > 0.0 && std::floor(after / every + rounding) > std::floor(before / every + rounding);
}

}  // namespace sinew
