#pragma once

#include <cmath>

namespace sinew {

/// The radius with which a particle touches others: half the edge of the cube (or square) of its volume [length].
template <int D>
double contact_radius(double volume) {
  return 0.5 * std::pow(volume, 1.0 / D);
}

}  // namespace sinew
