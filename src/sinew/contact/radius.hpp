#pragma once

#include <sinew/particles/particle_size.hpp>
#include <sinew/particles/particles.hpp>

namespace sinew {

/// contact_radius per slot [length], of copies too; 0 for padding.
template <int D>
AlignedArray<double> contact_radii(const Particles<D>& particles) {
  AlignedArray<double> radius(particles.slots + particles.copies);
  for (int slot = 0; slot < particles.slots + particles.copies; ++slot) radius[slot] = contact_radius<D>(particles.volume[slot]);
  return radius;
}

}  // namespace sinew
