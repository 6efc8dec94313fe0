#pragma once
/// What materials remember of their particles: numbers that start at zero, as many as the material of a body lists. Block after block, number after
/// number, slot after slot, so that a block touches its own memory only.

#include <sinew/formulations/material_point.hpp>
#include <sinew/particles/particles.hpp>

namespace sinew {

class HistoryStore {
 public:
  HistoryStore() = default;
  /// `numbers`: of each body.
  HistoryStore(const std::vector<BlockRange>& blocks, const std::vector<int>& numbers) : blocks_(blocks), numbers_(numbers) {
    std::size_t size = 0;
    for (const BlockRange& block : blocks) {
      first_.push_back(size);
      size += static_cast<std::size_t>(numbers[block.body]) * (block.end - block.begin);
    }
    values_ = AlignedArray<double>(size);
    for (const int count : numbers) most_ = std::max(most_, count);
  }

  /// Most numbers of a particle.
  int width() const { return most_; }
  int numbers(int block) const { return numbers_[blocks_[block].body]; }
  HistorySlots of(int block) {
    const BlockRange& range = blocks_[block];
    return {values_.data() + first_[block], range.end - range.begin, range.begin};
  }
  std::size_t bytes() const { return values_.bytes(); }

 private:
  std::vector<BlockRange> blocks_;
  std::vector<int> numbers_;
  std::vector<std::size_t> first_;  ///< of each block
  AlignedArray<double> values_;
  int most_ = 0;
};

}  // namespace sinew
