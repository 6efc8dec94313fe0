#pragma once
/// Which rank computes which block: a partition of the graph of blocks, balanced by pairs, that cuts few ghosts.

#include <sinew/neighbors/pair_list.hpp>
#include <sinew/parallel/comm.hpp>
#include <vector>

namespace sinew {

/// The blocks of a case as a graph.
struct BlockGraph {
  struct Edge {
    int from, to;  ///< numbers of blocks
    int ghosts;    ///< particles of `to` that `from` sees
  };
  std::vector<long> pairs;  ///< of each block: directed pairs of its particles
  std::vector<Edge> edges;  ///< by `from`, then `to`

  int blocks() const { return static_cast<int>(pairs.size()); }
};

/// The graph, of which this rank knows the pairs of some blocks (the others have none in the list). Collective; the same on all ranks.
template <int D>
BlockGraph block_graph(const Comm& comm, const Arrangement<D>& all, const std::vector<int>& blocks, const PairList& list);

/// The blocks of one of `parts` equal shares of all in their order: a first, rough distribution.
std::vector<int> equal_share(int blocks, int part, int parts);

/// Part of each block. Parts differ little in pairs (where there are enough blocks) and few ghosts are cut. Equal for equal input. `parts` may be more than there are blocks: then some
/// have none.
std::vector<int> partition(const BlockGraph& graph, int parts);

}  // namespace sinew
