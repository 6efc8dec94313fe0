#pragma once
/// Loops over the particles of a block, eight at a time, and over blocks, for work in which particles do not meet.

#include <algorithm>
#include <array>
#include <sinew/core/pack.hpp>
#include <sinew/neighbors/threads.hpp>
#include <sinew/particles/particles.hpp>

namespace sinew {

/// Up to eight particles in a row.
struct EightOfBlock {
  int slot, count;

  /// Their values; 0 where there are fewer than eight.
  Pack operator()(const double* by_slot) const {
    return count == lanes ? Pack::load_unaligned(by_slot + slot) : Pack::load_some(by_slot + slot, count);
  }
  template <int D>
  Vec<Pack, D> operator()(const VectorField<D>& field) const {
    Vec<Pack, D> v;
    for (int c = 0; c < D; ++c) v[c] = (*this)(field.component(c));
    return v;
  }
  void add(const Pack& values, double* by_slot) const {
    if (count == lanes)
      (Pack::load_unaligned(by_slot + slot) + values).store_unaligned(by_slot + slot);
    else
      for (int k = 0; k < count; ++k) by_slot[slot + k] += values[k];
  }
  template <int D>
  void add(const Vec<Pack, D>& values, VectorField<D>& field) const {
    for (int c = 0; c < D; ++c) add(values[c], field.component(c));
  }
};

/// Calls use(eight) for all particles of a block.
template <class Use>
void for_each_eight(const BlockRange& block, Use&& use) {
  for (int slot = block.begin; slot < block.end; slot += lanes) use(EightOfBlock{slot, std::min(lanes, block.end - slot)});
}

/// sums(block) gives an array of numbers for each block; all of them go to `all`, block after block.
template <std::size_t width, int D, class Sums>
void of_each_block(const Particles<D>& particles, Sums&& sums, std::vector<double>& all) {
  all.resize(particles.blocks.size() * width);
  const auto count = static_cast<int>(particles.blocks.size());
#pragma omp parallel for schedule(static) if (particles.slots >= fewest_for_threads)
  for (int b = 0; b < count; ++b) {
    const std::array<double, width> of_block = sums(particles.blocks[b]);
    std::copy(of_block.begin(), of_block.end(), all.begin() + b * width);
  }
}

/// Square of the farthest way that a particle of this rank has moved since its displacement was `before` [length^2]. `scratch`: keeps its memory.
template <int D>
double farthest_move2(const Particles<D>& particles, const VectorField<D>& before, std::vector<double>& scratch) {
  of_each_block<1>(
      particles,
      [&](const BlockRange& block) -> std::array<double, 1> {
        Pack most(0.0);
        for_each_eight(block, [&](const EightOfBlock& eight) {
          const Vec<Pack, D> moved = eight(particles.displacement) - eight(before);
          most = max(most, dot(moved, moved));
        });
        return {largest(most)};
      },
      scratch);
  double most = 0.0;
  for (const double of_block : scratch) most = std::max(most, of_block);
  return most;
}

}  // namespace sinew
