#include <sinew/parallel/plan.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace sinew {

namespace {

int places_of(const Blocks& blocks, const Spill& spill) {
  int places = 0;
  for (int r = spill.first_run; r < spill.end_run; ++r) places += blocks.runs[r].length;
  return places;
}

/// What each rank has and sends.
struct Loads {
  std::vector<long> particles, pairs, copies, sent;  ///< sent: places of displacements and forces
  std::vector<std::set<int>> neighbors;

  explicit Loads(int ranks) : particles(ranks, 0), pairs(ranks, 0), copies(ranks, 0), sent(ranks, 0), neighbors(ranks) {}

  /// Rank by rank, so that a mark per particle is enough to count a copy once.
  void add_spills(const Blocks& blocks, const std::vector<int>& owner, std::size_t slots) {
    std::vector<Spill> by_rank = blocks.out;
    std::stable_sort(by_rank.begin(), by_rank.end(),
                     [&](const Spill& a, const Spill& b) { return owner[a.from] < owner[b.from]; });
    std::vector<int> copied_to(slots, -1);
    for (const Spill& spill : by_rank) {
      const int from = owner[spill.from], to = owner[spill.to];
      if (from == to) continue;
      sent[from] += places_of(blocks, spill);  // forces go to `to`, displacements come from there
      neighbors[from].insert(to);
      neighbors[to].insert(from);
      for (int r = spill.first_run; r < spill.end_run; ++r)
        for (int slot = blocks.runs[r].slot; slot < blocks.runs[r].slot + blocks.runs[r].length; ++slot)
          if (copied_to[slot] != from) copied_to[slot] = from, ++copies[from], ++sent[to];
    }
  }
};

template <class T>
T largest(const std::vector<T>& values) {
  return *std::max_element(values.begin(), values.end());
}

}  // namespace

template <int D>
BlockGraph graph_of_blocks(const BlockPairs<D>& pairs) {
  BlockGraph graph;
  for (const Block& block : pairs.blocks.all) {
    graph.pairs.push_back(0);
    for (int slot = block.begin; slot < block.end; ++slot) graph.pairs.back() += pairs.neighbor_count[slot];
  }
  for (const Spill& spill : pairs.blocks.out) graph.edges.push_back({spill.from, spill.to, places_of(pairs.blocks, spill)});
  return graph;
}

template <int D>
RanksPlan plan_for(const BlockPairs<D>& pairs, int ranks) {
  const BlockGraph graph = graph_of_blocks(pairs);
  const std::vector<int> owner = partition(graph, ranks);
  const Blocks& blocks = pairs.blocks;
  Loads loads(ranks);
  long particles = 0, sent = 0, copies = 0;
  for (const Block& block : blocks.all) {
    loads.particles[owner[block.number]] += block.end - block.begin;
    loads.pairs[owner[block.number]] += graph.pairs[block.number];
    particles += block.end - block.begin;
  }
  loads.add_spills(blocks, owner, pairs.neighbor_count.size());

  RanksPlan plan;
  for (int r = 0; r < ranks; ++r) {
    sent += loads.sent[r];
    copies += loads.copies[r];
    plan.messages_most = std::max(plan.messages_most, 2 * static_cast<int>(loads.neighbors[r].size()));
  }
  constexpr double place = D * sizeof(double);
  plan.ranks = ranks;
  plan.particles_most = largest(loads.particles);
  plan.pairs_most = largest(loads.pairs);
  plan.pairs_imbalance = static_cast<double>(plan.pairs_most) * ranks / static_cast<double>(pairs.pairs) - 1.0;
  plan.copies_share = static_cast<double>(copies) / static_cast<double>(particles);
  plan.bytes = place * static_cast<double>(sent);
  plan.bytes_most = place * static_cast<double>(largest(loads.sent));
  return plan;
}

double Network::step(const RanksPlan& plan, double seconds_a_pair) const {
  const double reduction = 2.0 * latency * std::ceil(std::log2(static_cast<double>(plan.ranks)));
  return static_cast<double>(plan.pairs_most) * seconds_a_pair + plan.messages_most * latency + plan.bytes_most / bandwidth +
         reduction;
}

template BlockGraph graph_of_blocks<2>(const BlockPairs<2>&);
template BlockGraph graph_of_blocks<3>(const BlockPairs<3>&);
template RanksPlan plan_for<2>(const BlockPairs<2>&, int);
template RanksPlan plan_for<3>(const BlockPairs<3>&, int);

}  // namespace sinew
