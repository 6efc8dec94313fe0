#pragma once
/// The pairs of all blocks. A slice, eight particles at consecutive places of a block, has a lattice pattern or a list (sliced ELLPACK): entry (s, k) holds
/// the place of the k-th neighbor of each of its particles. Rows that end early are filled with the particle itself.

#include <sinew/neighbors/blocks.hpp>
#include <sinew/neighbors/lattice_patterns.hpp>
#include <sinew/neighbors/pair_list.hpp>
#include <vector>

namespace sinew {

template <int D>
struct BlockPairs {
  Blocks blocks;
  LatticePatterns<D> lattice;            ///< pattern of each slice
  std::vector<std::size_t> first_entry;  ///< slices + 1; slices with a pattern have none
  AlignedArray<PlaceIndex> places;       ///< entry e, lane k: places[8 e + k]
  std::vector<int> neighbor_count;       ///< per slot
  std::size_t pairs = 0;                 ///< directed pairs, fill not counted

  std::size_t entries() const { return first_entry.back(); }
  const PlaceIndex* entry(std::size_t e) const { return places.data() + lanes * e; }
  bool listed(int slice) const { return lattice.of_slice[slice] == LatticePatterns<D>::none; }
  /// The slots of the neighbors of a particle, in the order of their places, which does not depend on who has the block.
  std::vector<int> neighbors(int slot, const Arrangement<D>& particles) const;
  /// Calls use(slot, slot of a neighbor) for all pairs of a block; fast, in the order of the lists.
  template <class Use>
  void for_each_pair(const Block& block, Use&& use) const;
  std::size_t bytes() const;
};

template <int D>
template <class Use>
void BlockPairs<D>::for_each_pair(const Block& block, Use&& use) const {
  const int* slots = blocks.slots_of(block);
  std::vector<std::vector<int>> offsets(lattice.patterns.size() * lanes);  // of each pattern and lane, once they are needed
  for (int slice = block.first_slice; slice < block.end_slice; ++slice)
    for (int lane = 0; lane < lanes; ++lane) {
      const int place = blocks.place_of_slice[slice] + lane;
      if (!block.owns(slots[place])) continue;
      if (listed(slice)) {
        for (std::size_t e = first_entry[slice]; e < first_entry[slice + 1]; ++e)
          if (const int neighbor = entry(e)[lane]; neighbor != place) use(slots[place], slots[neighbor]);
      } else {
        std::vector<int>& of_lane = offsets[lattice.of_slice[slice] * lanes + lane];
        if (of_lane.empty()) of_lane = lattice.offsets(lattice.of_slice[slice], lane);
        for (const int offset : of_lane) use(slots[place], slots[place + offset]);
      }
    }
}

/// Lays out pairs block by block. A block of which less than half of the slices have a lattice pattern has none.
template <int D>
BlockPairs<D> make_block_pairs(const Arrangement<D>& particles, PairList list, const std::vector<double>& support_radius,
                               bool look_for_lattice);
/// Only those of some blocks, given by their numbers in ascending order.
template <int D>
BlockPairs<D> make_block_pairs(const Arrangement<D>& particles, const std::vector<int>& blocks, PairList list,
                               const std::vector<double>& support_radius, bool look_for_lattice);

extern template struct BlockPairs<2>;
extern template struct BlockPairs<3>;

}  // namespace sinew
