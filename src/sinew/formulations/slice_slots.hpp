#pragma once
/// Where the lanes of a slice go in arrays by slot: the block's own particles.

#include <sinew/neighbors/block_pairs.hpp>

namespace sinew {

template <int D>
class SliceSlots {
 public:
  SliceSlots(const BlockPairs<D>& pairs, const Block& block, int slice)
      : slots_(pairs.blocks.slots_of(block) + pairs.blocks.place_of_slice[slice]),
        block_(block),
        in_a_row_(block_.owns(slots_[0]) && block_.owns(slots_[lanes - 1]) && slots_[lanes - 1] - slots_[0] == lanes - 1) {}

  /// 0 in the lanes of others. `first`: the slot of by_slot[0].
  Pack load(const double* by_slot, int first = 0) const {
    if (in_a_row_) return Pack::load_unaligned(by_slot + slots_[0] - first);
    Pack values(0.0);
    for (int k = 0; k < lanes; ++k)
      if (block_.owns(slots_[k])) values.set(k, by_slot[slots_[k] - first]);
    return values;
  }
  void store(const Pack& values, double* by_slot, int first = 0) const {
    if (in_a_row_) return values.store_unaligned(by_slot + slots_[0] - first);
    for (int k = 0; k < lanes; ++k)
      if (block_.owns(slots_[k])) by_slot[slots_[k] - first] = values[k];
  }

  Mat<Pack, D> load_matrix(const VectorField<D * D>& by_slot) const {
    Mat<Pack, D> m;
    for (int r = 0; r < D; ++r)
      for (int c = 0; c < D; ++c) m[r][c] = load(by_slot.component(D * r + c));
    return m;
  }
  void store_matrix(const Mat<Pack, D>& m, VectorField<D * D>& by_slot) const {
    for (int r = 0; r < D; ++r)
      for (int c = 0; c < D; ++c) store(m[r][c], by_slot.component(D * r + c));
  }

 private:
  const int* slots_;
  const Block& block_;
  bool in_a_row_;
};

}  // namespace sinew
