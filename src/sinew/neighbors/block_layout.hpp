#pragma once
/// Gives places to the particles of a block and to its ghosts, while pairs are laid out. One for each thread; it keeps its memory.

#include <array>
#include <cstdint>
#include <sinew/neighbors/blocks.hpp>
#include <sinew/neighbors/pair_list.hpp>
#include <sinew/particles/order.hpp>
#include <vector>

namespace sinew {

template <int D>
class BlockLayout {
 public:
  /// `grids`: of each body, when places on a grid are asked for.
  BlockLayout(const Arrangement<D>& particles, const PairList& list, const std::vector<SlabGrid>& grids)
      : particles_(particles),
        list_(list),
        grids_(grids) {}

  /// Own particles from place 0 on, ghosts after them.
  void own_first(const BlockRange& block);
  /// Own particles and ghosts where they stand in the grid of their body, with empty places where nobody is: neighbors at one distance in space are at one
  /// distance in places, if they stand on a lattice. False if two want one place, or there would be
  /// too many places or too many empty ones.
  bool on_grid(const BlockRange& block);
  /// As it was before.
  void restore(const BlockRange& block, const std::vector<int>& slot_at);

  const BlockRange& block() const { return block_; }
  /// Place -> slot; `nobody`: padding. Whole slices.
  const std::vector<int>& slot_at() const { return slot_at_; }
  bool own(int place) const { return block_.owns(slot_at_[place]); }
  /// Places of the neighbors of an own particle, ascending.
  void neighbors(int place, std::vector<int>& places) const;
  /// Places at which slices with own particles begin.
  std::vector<int> slices() const;
  /// Appends the runs of own particles or of ghosts.
  void add_runs(bool own_ones, std::vector<Run>& runs) const;

 private:
  void find_ghosts(const BlockRange& block);
  std::array<std::int64_t, 3> bins_of(int slot) const;
  void give_places();

  const Arrangement<D>& particles_;
  const PairList& list_;
  const std::vector<SlabGrid>& grids_;
  BlockRange block_;
  std::vector<int> ghosts_, members_, slot_at_;
  std::vector<std::array<std::int64_t, 3>> bins_;
  std::vector<int> place_of_;  ///< slot -> place
};

extern template class BlockLayout<2>;
extern template class BlockLayout<3>;

}  // namespace sinew
