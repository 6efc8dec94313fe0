#pragma once
/// Blocks as units of work. A block keeps its own particles and those of other blocks that its pairs reach, its ghosts, at places of its own: all
/// that the loops over its pairs touch is near. It adds its pair forces, in order, at these places; what its ghosts have received is
/// spilled into the blocks that own them, in the order of the blocks. So sums have one order, whoever computes a block: any number of threads
/// gives the same bits.

#include <atomic>
#include <cstdint>
#include <sinew/neighbors/threads.hpp>
#include <sinew/particles/particles.hpp>
#include <vector>

namespace sinew {

/// A place of a block. Two bytes a pair instead of four; a block and its ghosts, of some 30 000 particles in a usual support, are never so many that they
/// do not fit, unless supports are several times as large. Tests lower the limit.
using PlaceIndex = std::uint16_t;
inline std::size_t place_limit = std::size_t{1} << 16;

/// Slots [slot, slot + length) at places [place, place + length) of a block. Ghosts have room for their forces from `spill` on.
struct Run {
  int slot, place, length, spill;
};

struct Block {
  int body = 0;
  int begin = 0, end = 0;                            ///< slots of its own particles
  int places = 0;                                    ///< own particles, ghosts and padding: whole slices
  std::size_t first_place = 0;                       ///< in Blocks::slot_at
  int first_own = 0, first_ghost = 0, end_runs = 0;  ///< runs of own particles, then of ghosts
  int first_slice = 0, end_slice = 0;                ///< slices in which it has particles of its own
  bool has_lattice = false, has_list = false;        ///< slices with a pattern, without

  bool owns(int slot) const { return slot >= begin && slot < end; }
};

/// Runs of ghosts of block `from` that block `to` owns.
struct Spill {
  int from, to, first_run, end_run;
};

struct Blocks {
  static constexpr int nobody = -1;
  std::vector<Block> all;
  std::vector<Run> runs;
  std::vector<int> slot_at;         ///< place p of block b: slot_at[b.first_place + p]; `nobody`: padding
  std::vector<int> place_of_slice;  ///< slice -> place of its first lane in its block
  std::vector<Spill> out, in;       ///< the same, in the order of `from` and of `to`
  std::vector<int> first_out, first_in;
  int ghosts = 0;

  int slices() const { return static_cast<int>(place_of_slice.size()); }
  int count() const { return static_cast<int>(all.size()); }
  int most_places() const;
  const int* slots_of(const Block& block) const { return slot_at.data() + block.first_place; }
  std::size_t bytes() const;
};

/// Counts, for each block, how many of itself and those that spill into it are still to be done.
class BlockCountdown {
 public:
  explicit BlockCountdown(const Blocks& blocks) : blocks_(blocks), left_(blocks.all.size()) {}

  void start() {
    for (int b = 0; b < blocks_.count(); ++b)
      left_[b].store(1 + blocks_.first_in[b + 1] - blocks_.first_in[b], std::memory_order_relaxed);
  }
  /// To be called when block b is done: calls finish(number) for every block for which that was the last.
  template <class Finish>
  void done(int b, Finish&& finish) {
    count_down(b, finish);
    for (int s = blocks_.first_out[b]; s < blocks_.first_out[b + 1]; ++s) count_down(blocks_.out[s].to, finish);
  }

 private:
  template <class Finish>
  void count_down(int b, Finish&& finish) {
    if (left_[b].fetch_sub(1, std::memory_order_acq_rel) == 1) finish(b);
  }

  const Blocks& blocks_;
  std::vector<std::atomic<int>> left_;
};

/// Calls work(number) for every block and finish(number) for those to which no block will add any more, on all threads.
template <class Work, class Finish>
void for_each_block(const Blocks& blocks, BlockCountdown& countdown, Work&& work, Finish&& finish) {
  const int count = blocks.count();
  const bool many = count > 1 && blocks.all.back().end >= fewest_for_threads;
  countdown.start();
#pragma omp parallel for schedule(dynamic, 1) if (many)
  for (int b = 0; b < count; ++b) {
    work(b);
    countdown.done(b, finish);
  }
}

}  // namespace sinew
