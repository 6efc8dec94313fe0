#include <sinew/parallel/decomposition.hpp>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <map>
#include <numeric>
#include <stdexcept>

#include <scotch.h>

namespace sinew {

namespace {

/// Ghosts of one block, by the block that owns them.
template <int D>
std::map<int, int> ghosts_of(const Arrangement<D>& all, const BlockRange& block, const PairList& list,
                             std::vector<int>& seen_by) {
  std::map<int, int> ghosts;
  for (int slot = block.begin; slot < block.end; ++slot) {
    const int* next = list.neighbor.data() + lanes * list.first_entry[slot / lanes] + slot % lanes;
    for (int n = 0; n < list.neighbor_count[slot]; ++n, next += lanes) {
      if (block.owns(*next) || seen_by[*next] == block.number) continue;
      seen_by[*next] = block.number;
      ++ghosts[all.block_of(*next)];
    }
  }
  return ghosts;
}

/// Weights as Scotch takes them: their sum has to fit an int.
std::vector<SCOTCH_Num> scaled(const std::vector<long>& weights) {
  const long total = std::accumulate(weights.begin(), weights.end(), 0L);
  const long unit = total / (1L << 29) + 1;
  std::vector<SCOTCH_Num> small;
  for (const long weight : weights) small.push_back(static_cast<SCOTCH_Num>(std::max(1L, weight / unit)));
  return small;
}

/// A graph in compressed form, both directions of each edge with the sum of both numbers of ghosts.
struct Adjacency {
  std::vector<SCOTCH_Num> first, neighbor, weight;

  explicit Adjacency(const BlockGraph& graph) {
    std::vector<std::map<int, long>> of(graph.blocks());
    for (const BlockGraph::Edge& edge : graph.edges) {
      of[edge.from][edge.to] += edge.ghosts;
      of[edge.to][edge.from] += edge.ghosts;
    }
    std::vector<long> ghosts;
    for (const auto& neighbors : of) {
      first.push_back(static_cast<SCOTCH_Num>(neighbor.size()));
      for (const auto& [block, count] : neighbors) neighbor.push_back(block), ghosts.push_back(count);
    }
    first.push_back(static_cast<SCOTCH_Num>(neighbor.size()));
    weight = scaled(ghosts);
  }
};

void check(int result, const char* what) {
  if (result != 0) throw std::runtime_error(std::string("Scotch cannot ") + what);
}

/// With one thread and a random number generator of its own, so that the same graph gives the same parts: with threads, Scotch does not.
class ScotchContext {
 public:
  ScotchContext() {
    check(SCOTCH_contextInit(&context_), "start");
    check(SCOTCH_contextOptionSetNum(&context_, SCOTCH_OPTIONNUMDETERMINISTIC, 1), "be deterministic");
    check(SCOTCH_contextThreadSpawn(&context_, 1, nullptr), "use one thread");
    check(SCOTCH_contextRandomClone(&context_), "make random numbers");
    SCOTCH_contextRandomSeed(&context_, 1);
    SCOTCH_contextRandomReset(&context_);
  }
  ~ScotchContext() { SCOTCH_contextExit(&context_); }
  ScotchContext(const ScotchContext&) = delete;
  ScotchContext& operator=(const ScotchContext&) = delete;

  /// The graph, to be partitioned in this context.
  void bind(const SCOTCH_Graph& graph, SCOTCH_Graph& bound) {
    check(SCOTCH_contextBindGraph(&context_, &graph, &bound), "take the graph");
  }

 private:
  SCOTCH_Context context_;
};

std::vector<int> scotch_parts(const BlockGraph& graph, int parts) {
  Adjacency adjacency(graph);
  std::vector<SCOTCH_Num> pairs = scaled(graph.pairs), result(graph.blocks());
  ScotchContext context;
  SCOTCH_Graph scotch, bound;
  SCOTCH_Strat strategy;
  check(SCOTCH_graphInit(&scotch), "make a graph");
  check(SCOTCH_graphInit(&bound), "make a graph");
  check(SCOTCH_stratInit(&strategy), "make a strategy");
  check(SCOTCH_graphBuild(&scotch, 0, graph.blocks(), adjacency.first.data(), nullptr, pairs.data(), nullptr,
                          static_cast<SCOTCH_Num>(adjacency.neighbor.size()), adjacency.neighbor.data(), adjacency.weight.data()),
        "read the graph of blocks");
  context.bind(scotch, bound);
  check(SCOTCH_stratGraphMapBuild(&strategy, SCOTCH_STRATQUALITY, parts, 0.01), "choose a strategy");
  check(SCOTCH_graphPart(&bound, parts, &strategy, result.data()), "partition the graph of blocks");
  SCOTCH_stratExit(&strategy);
  SCOTCH_graphExit(&bound);
  SCOTCH_graphExit(&scotch);
  return {result.begin(), result.end()};
}

/// Moves single blocks from the heaviest part to the lightest one as long as that makes the heaviest lighter: the partitioner leaves a few percent.
void even_out(const BlockGraph& graph, int parts, std::vector<int>& part) {
  std::vector<long> load(parts, 0);
  for (int b = 0; b < graph.blocks(); ++b) load[part[b]] += graph.pairs[b];
  for (int round = 0; round < graph.blocks(); ++round) {
    const auto heavy = static_cast<int>(std::max_element(load.begin(), load.end()) - load.begin());
    const auto light = static_cast<int>(std::min_element(load.begin(), load.end()) - load.begin());
    int best = -1;
    for (int b = 0; b < graph.blocks(); ++b) {
      const bool fits = part[b] == heavy && load[light] + graph.pairs[b] < load[heavy];
      if (fits && (best < 0 || graph.pairs[b] < graph.pairs[best])) best = b;
    }
    if (best < 0) return;
    part[best] = light;
    load[heavy] -= graph.pairs[best];
    load[light] += graph.pairs[best];
  }
}

}  // namespace

template <int D>
BlockGraph block_graph(const Comm& comm, const Arrangement<D>& all, const std::vector<int>& blocks, const PairList& list) {
  BlockGraph graph;
  graph.pairs.assign(all.blocks.size(), 0);
  std::vector<int> edges, seen_by(all.slots, -1);
  for (const int number : blocks) {
    const BlockRange& block = all.blocks[number];
    for (int slot = block.begin; slot < block.end; ++slot) graph.pairs[number] += list.neighbor_count[slot];
    for (const auto& [to, ghosts] : ghosts_of(all, block, list, seen_by)) edges.insert(edges.end(), {number, to, ghosts});
  }
  comm.sum(graph.pairs);
  edges = comm.gather_all(edges);
  for (std::size_t e = 0; e < edges.size(); e += 3) graph.edges.push_back({edges[e], edges[e + 1], edges[e + 2]});
  return graph;
}

std::vector<int> equal_share(int blocks, int part, int parts) {
  const auto begin = [&](int p) { return static_cast<int>(static_cast<std::int64_t>(blocks) * p / parts); };
  std::vector<int> share(begin(part + 1) - begin(part));
  std::iota(share.begin(), share.end(), begin(part));
  return share;
}

std::vector<int> partition(const BlockGraph& graph, int parts) {
  std::vector<int> part(graph.blocks(), 0);
  if (parts == 1) return part;
  if (parts >= graph.blocks()) {
    std::iota(part.begin(), part.end(), 0);
    return part;
  }
  part = scotch_parts(graph, parts);
  even_out(graph, parts, part);
  return part;
}

template BlockGraph block_graph<2>(const Comm&, const Arrangement<2>&, const std::vector<int>&, const PairList&);
template BlockGraph block_graph<3>(const Comm&, const Arrangement<3>&, const std::vector<int>&, const PairList&);

}  // namespace sinew
