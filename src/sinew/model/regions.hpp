#pragma once
/// Named particle sets.

#include <map>
#include <sinew/model/bodies.hpp>
#include <sinew/particles/particles.hpp>
#include <string>
#include <vector>

namespace sinew {

/// Slots of every region of the case, in the user's order of particles.
/// A region that selects nothing is a CaseError that says what there is.
template <int D>
std::map<std::string, std::vector<int>> select_regions(const Case& c, const std::vector<GeneratedBody>& bodies,
                                                       const Particles<D>& particles);

}  // namespace sinew
