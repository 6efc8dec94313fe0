#pragma once
/// From the bodies of a case to points with volumes, and the checks that need no neighbors.

#include <sinew/model/case.hpp>
#include <sinew/parallel/comm.hpp>
#include <sinew/particles/generate/point_set.hpp>
#include <string>
#include <vector>

namespace sinew {

struct GeneratedBody {
  PointSet points;
  double spacing;  ///< nominal particle spacing [length]
};

/// Makes the points of all bodies. CaseError: empty bodies, bodies that overlap, more memory than the machine has.
/// Several ranks share the memory of a machine.
std::vector<GeneratedBody> generate_bodies(const Case& c, const Comm& comm = Comm());

/// Memory of this machine, or of the container that we are in [bytes].
double machine_memory();

}  // namespace sinew
