#pragma once
/// Who sees whom in the reference configuration, in slices of eight particles (sliced ELLPACK): entry (s, k) holds the k-th neighbor
/// of each of the eight particles of slice s. A row i holds every j with |X_j - X_i| < R_i, R_i the support radius of i alone: where
/// radii differ j may stand in the row of i and not the other way round. Rows that end early are filled with the particle itself.

#include <sinew/particles/particles.hpp>
#include <vector>

namespace sinew {

struct PairList {
  std::vector<std::size_t> first_entry;  ///< slices + 1: entries [first_entry[s], first_entry[s + 1]) belong to slice s
  std::vector<int> neighbor_count;       ///< per slot
  AlignedArray<int> neighbor;            ///< entry e, lane k: neighbor[8 e + k], a slot
  std::size_t pairs = 0;                 ///< directed pairs, fill not counted

  int slices() const { return static_cast<int>(first_entry.size()) - 1; }
  std::size_t entries() const { return first_entry.back(); }
  const int* entry(std::size_t e) const { return neighbor.data() + lanes * e; }
  std::size_t bytes() const { return neighbor.bytes() + neighbor_count.size() * 4 + first_entry.size() * 8; }
};

/// Builds the list; only particles of the same body see each other. `support_radius`: R_i per slot [length]; 0: sees nobody.
template <int D>
PairList build_pair_list(const Arrangement<D>& particles, const std::vector<double>& support_radius);

/// Per particle (in slots) the radius inside which about `neighbors` others lie: halfway (in the d-th power) between the farthest one that is
/// in and the nearest that is out. A body of fewer particles than that is an error of the case. Only particles of the blocks with the
/// given numbers, ascending, are sure to have theirs.
template <int D>
std::vector<double> radius_of_neighbors(const Arrangement<D>& particles, double neighbors, const std::vector<int>& blocks);

}  // namespace sinew
