/// Which rank computes which block, and what that costs.

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <sinew/neighbors/pair_list.hpp>
#include <sinew/parallel/plan.hpp>

namespace sinew {
namespace {

/// Blocks in a cube, each next to six others.
BlockGraph cube_of_blocks(int n) {
  BlockGraph graph;
  const auto number = [n](int i, int j, int k) { return (i * n + j) * n + k; };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k) {
        graph.pairs.push_back(1000 + 10 * ((i + 2 * j + k) % 3));
        for (int axis = 0; axis < 3; ++axis)
          for (int step : {-1, 1}) {
            int at[] = {i, j, k};
            at[axis] += step;
            if (at[axis] >= 0 && at[axis] < n) graph.edges.push_back({number(i, j, k), number(at[0], at[1], at[2]), 100});
          }
      }
  return graph;
}

std::vector<long> loads(const BlockGraph& graph, const std::vector<int>& part, int parts) {
  std::vector<long> load(parts, 0);
  for (int b = 0; b < graph.blocks(); ++b) load[part[b]] += graph.pairs[b];
  return load;
}

TEST(Partition, BalancesPairsAndCutsFewGhosts) {
  const BlockGraph graph = cube_of_blocks(6);
  const long total = std::accumulate(graph.pairs.begin(), graph.pairs.end(), 0L);
  for (const int parts : {1, 2, 3, 4, 7, 8, 27}) {
    const std::vector<int> part = partition(graph, parts);
    EXPECT_EQ(part, partition(graph, parts)) << "the same again";
    const std::vector<long> load = loads(graph, part, parts);
    EXPECT_LT(*std::max_element(load.begin(), load.end()), total / parts + 1100) << parts << " parts";
    EXPECT_GT(*std::min_element(load.begin(), load.end()), 0) << parts << " parts";
    const auto cut = [&](const BlockGraph::Edge& edge) { return part[edge.from] != part[edge.to]; };
    const auto edges = std::count_if(graph.edges.begin(), graph.edges.end(), cut);
    EXPECT_LT(edges, parts <= 8 ? 2 * 36 * 5 : 2 * 36 * 15) << parts << " parts";  // so many planes through the cube
  }
}

TEST(Partition, ByPairsNotByBlocks) {
  BlockGraph graph = cube_of_blocks(3);
  std::fill(graph.pairs.begin(), graph.pairs.end(), 1000L);
  graph.pairs[0] = 8000;
  const std::vector<long> load = loads(graph, partition(graph, 2), 2);
  EXPECT_LE(std::abs(load[0] - load[1]), 1000);
}

TEST(Partition, MorePartsThanBlocks) {
  const std::vector<int> part = partition(cube_of_blocks(1), 4);
  EXPECT_EQ(part, std::vector<int>{0});
}

TEST(EqualShare, CoversAllOnce) {
  for (const int parts : {1, 2, 3, 7}) {
    std::vector<int> all;
    for (int p = 0; p < parts; ++p)
      for (int block : equal_share(10, p, parts)) all.push_back(block);
    std::vector<int> expected(10);
    std::iota(expected.begin(), expected.end(), 0);
    EXPECT_EQ(all, expected);
  }
}

/// A row of points 1 apart that see 2 to each side, in 4 blocks: every number can be counted by hand.
TEST(Plan, CountsARowOfPoints) {
  PointSet points;
  for (int i = 0; i < 64; ++i) {
    points.position.push_back({{1.0 * i, 0.0, 0.0}});
    points.volume.push_back(1.0);
  }
  const Particles<2> particles(arrange<2>({{"row", &points, 1.0, 1.0}}, 16), 1.0);
  const std::vector<double> radius(particles.slots, 2.5);
  const BlockPairs<2> pairs = make_block_pairs<2>(particles, build_pair_list<2>(particles, radius), radius, false);
  ASSERT_EQ(pairs.blocks.count(), 4);
  const RanksPlan one = plan_for(pairs, 1), four = plan_for(pairs, 4);
  EXPECT_EQ(one.bytes, 0.0);
  EXPECT_EQ(one.messages_most, 0);
  EXPECT_EQ(one.pairs_most, 64 * 4 - 6);
  EXPECT_EQ(four.particles_most, 16);
  EXPECT_EQ(four.pairs_most, 16 * 4);
  EXPECT_DOUBLE_EQ(four.copies_share, 3 * 4 / 64.0);             // two on each side of three cuts
  EXPECT_DOUBLE_EQ(four.bytes, 2 * 3 * 4 * 2 * sizeof(double));  // there as displacements, back as forces
  EXPECT_DOUBLE_EQ(four.bytes_most, 2 * 4 * 2 * sizeof(double));
  EXPECT_EQ(four.messages_most, 4);  // two neighbors, there and back
}

TEST(Network, AddsPairsMessagesBytesAndTheReduction) {
  RanksPlan plan;
  plan.ranks = 8;
  plan.pairs_most = 1000;
  plan.messages_most = 4;
  plan.bytes_most = 5e6;
  const Network network{1e-6, 1e9};
  EXPECT_DOUBLE_EQ(network.step(plan, 1e-8), 1e-5 + 4e-6 + 5e-3 + 6e-6);
}

}  // namespace
}  // namespace sinew
