#pragma once
/// What a distribution over ranks would cost, counted from the blocks of a case that one process has.

#include <sinew/neighbors/block_pairs.hpp>
#include <sinew/parallel/decomposition.hpp>
#include <vector>

namespace sinew {

/// Counts for one step; "most": of the rank that has most.
struct RanksPlan {
  int ranks = 1;
  long particles_most = 0;
  long pairs_most = 0;
  double pairs_imbalance = 0.0;  ///< pairs_most over the mean, less 1
  double copies_share = 0.0;     ///< copies of particles of other ranks, for each particle
  double bytes = 0.0;            ///< that all ranks send: displacements of copies and forces on ghosts
  double bytes_most = 0.0;
  int messages_most = 0;
};

/// The graph of blocks that are all here.
template <int D>
BlockGraph graph_of_blocks(const BlockPairs<D>& pairs);

/// Partitions the blocks as a run on so many ranks would, and counts.
template <int D>
RanksPlan plan_for(const BlockPairs<D>& pairs, int ranks);

/// How long a message takes: latency + bytes / bandwidth.
struct Network {
  double latency = 2e-6;    ///< [s]
  double bandwidth = 10e9;  ///< of one rank [bytes/s]

  /// A step of the busiest rank [s]: its pairs, its messages one after the other, and a reduction over all ranks as a tree there and back. Nothing
  /// overlaps: a pessimistic model.
  double step(const RanksPlan& plan, double seconds_a_pair) const;
};

}  // namespace sinew
