#pragma once
/// From the bodies of a case to the particles and pairs of one rank.

#include <sinew/formulations/formulation.hpp>
#include <sinew/model/regions.hpp>

namespace sinew {

/// What a rank computes with. Of a process alone it is everything.
template <int D>
struct SolidSetup {
  Particles<D> particles;
  Regions regions;
  std::vector<double> support_radius;  ///< per slot [length]
  std::unique_ptr<Formulation<D>> solid;
};

/// Every rank generates all points and their order, since these are cheap; then pairs are counted, blocks are given to ranks, and each keeps
/// its share. Collective.
template <int D>
SolidSetup<D> set_up(const Case& c, const std::vector<GeneratedBody>& bodies, const Comm& comm);

}  // namespace sinew
