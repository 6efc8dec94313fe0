#pragma once
/// Named particle sets.

#include <map>
#include <sinew/model/bodies.hpp>
#include <sinew/parallel/share.hpp>
#include <string>
#include <vector>

namespace sinew {

struct Region {
  std::vector<int> slots;  ///< of its particles on this rank, ascending
  long particles = 0;      ///< on all ranks
  double volume = 0.0;     ///< of all of them [length^D]
};
using Regions = std::map<std::string, Region>;

/// Every region of the case, all particles of it. A region that selects nothing is a CaseError that says what there is.
template <int D>
Regions select_regions(const Case& c, const std::vector<GeneratedBody>& bodies, const Arrangement<D>& all);

/// Leaves the own particles of a share, in its slots.
void keep_own(Regions& regions, const Share& share);

}  // namespace sinew
