#pragma once
/// The radius with which a particle touches others: half the edge of the cube (or square) of its volume.

#include <cmath>
#include <sinew/particles/particles.hpp>

namespace sinew {

/// Per slot [length], of copies too; 0 for padding.
template <int D>
AlignedArray<double> contact_radii(const Particles<D>& particles) {
  AlignedArray<double> radius(particles.slots + particles.copies);
  for (int slot = 0; slot < particles.slots + particles.copies; ++slot)
    radius[slot] = 0.5 * std::pow(particles.volume[slot], 1.0 / D);
  return radius;
}

}  // namespace sinew
