#pragma once
/// Blocks as units of work. A block keeps its own particles and those of other blocks that its pairs reach, its ghosts, at places of its own: all
/// that the loops over its pairs touch is near. It adds its pair forces, in order, at these places; what its ghosts have received is
/// spilled into the blocks that own them, in the order of the blocks. So sums have one order, whoever computes a block: any number of threads
/// and of ranks gives the same bits.

#include <atomic>
#include <cstdint>
#include <sinew/neighbors/threads.hpp>
#include <sinew/particles/particles.hpp>
#include <span>
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
  int number = 0;  ///< in the order of all blocks of the case
  int body = 0;
  int begin = 0, end = 0;                            ///< slots of its own particles
  int places = 0;                                    ///< own particles, ghosts and padding: whole slices
  std::size_t first_place = 0;                       ///< in Blocks::slot_at
  int first_own = 0, first_ghost = 0, end_runs = 0;  ///< runs of own particles, then of ghosts
  int first_slice = 0, end_slice = 0;                ///< slices in which it has particles of its own
  bool has_lattice = false, has_list = false;        ///< slices with a pattern, without

  bool owns(int slot) const { return slot >= begin && slot < end; }
};

/// Runs of ghosts of the block with the number `from`, which the one with the number `to` owns.
struct Spill {
  int from, to, first_run, end_run;
};

/// The blocks of this rank, in the order of their numbers.
struct Blocks {
  static constexpr int nobody = -1;
  std::vector<Block> all;
  std::vector<Run> runs;
  std::vector<int> slot_at;         ///< place p of block b: slot_at[b.first_place + p]; `nobody`: padding
  std::vector<int> place_of_slice;  ///< slice -> place of its first lane in its block
  std::vector<Spill> out;           ///< of the blocks here, block after block
  std::vector<int> first_out;
  std::vector<Spill> received;  ///< from blocks of other ranks
  int ghosts = 0;               ///< places for forces that are spilled or received

  // made by connect() from what is above
  std::vector<Spill> in;  ///< what comes into each block here, in the order of `from`
  std::vector<int> first_in;
  std::vector<int> told;      ///< of each of `out`: which of `all` it goes to; `nobody`: one of another rank
  std::vector<int> awaiting;  ///< those of `all` that receive something

  void connect();
  int slices() const { return static_cast<int>(place_of_slice.size()); }
  int count() const { return static_cast<int>(all.size()); }
  int most_places() const;
  const int* slots_of(const Block& block) const { return slot_at.data() + block.first_place; }
  std::size_t bytes() const;
};

/// Counts, for each block, how many of itself and those that spill into it are still to be done; all that other ranks spill counts as one.
class BlockCountdown {
 public:
  explicit BlockCountdown(const Blocks& blocks) : blocks_(blocks), left_(blocks.all.size()), start_(blocks.all.size(), 1) {
    for (int to : blocks.told)
      if (to != Blocks::nobody) ++start_[to];
    for (int to : blocks.awaiting) ++start_[to];
  }

  void start() {
    for (std::size_t b = 0; b < start_.size(); ++b) left_[b].store(start_[b], std::memory_order_relaxed);
  }
  /// To be called when block b is done: calls finish(b) for every block for which that was the last.
  template <class Finish>
  void done(int b, Finish&& finish) {
    count_down(b, finish);
    for (int s = blocks_.first_out[b]; s < blocks_.first_out[b + 1]; ++s)
      if (const int to = blocks_.told[s]; to != Blocks::nobody) count_down(to, finish);
  }
  /// To be called for each of blocks.awaiting when everything has been received.
  template <class Finish>
  void received(int b, Finish&& finish) {
    count_down(b, finish);
  }

 private:
  template <class Finish>
  void count_down(int b, Finish&& finish) {
    if (left_[b].fetch_sub(1, std::memory_order_acq_rel) == 1) finish(b);
  }

  const Blocks& blocks_;
  std::vector<std::atomic<int>> left_;
  std::vector<int> start_;
};

/// Calls work(b) for some blocks on all threads (if `many`), and meanwhile() on the main thread after each that it has done itself.
template <class Work, class Meanwhile>
void for_each_block(std::span<const int> some, bool many, Work&& work, Meanwhile&& meanwhile) {
  const int count = static_cast<int>(some.size());
#pragma omp parallel for schedule(dynamic, 1) if (many && count > 1)
  for (int k = 0; k < count; ++k) {
    work(some[k]);
    if (this_thread() == 0) meanwhile();
  }
}

}  // namespace sinew
