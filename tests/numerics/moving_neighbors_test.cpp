/// Neighbors of moving points against a search over all pairs.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <sinew/neighbors/moving_neighbors.hpp>

namespace sinew {
namespace {

template <int D>
struct Points {
  VectorField<D> x;
  std::vector<int> numbers;
  Vec<double, D> low, high;
};

/// Random, with a hole, a lonely point far away, and every fifth left out.
template <int D>
Points<D> random_points(int count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> place(-7.0, 5.0);
  Points<D> points{VectorField<D>(count), std::vector<int>(count), {}, {}};
  for (int c = 0; c < D; ++c) points.low[c] = -7.0, points.high[c] = 300.0;
  for (int k = 0; k < count; ++k) {
    points.numbers[k] = k % 5 == 3 ? -1 : (k * 7919) % 100003;
    for (int c = 0; c < D; ++c) points.x.at(c, k) = k == 0 ? 299.0 : place(random) + (k % 3 == 0 ? 4.0 : 0.0);
  }
  return points;
}

/// point -> numbers of its neighbors, in order.
template <int D>
std::vector<std::vector<int>> lists_of(const Points<D>& points, int own, double radius) {
  MovingNeighbors<D> neighbors;
  neighbors.build(points.x, points.numbers, own, radius,
                  MovingGrid<D>(radius, points.low, points.high, double(points.numbers.size())));
  std::vector<std::vector<int>> lists(points.numbers.size());
  for (int s = 0; s < neighbors.slices(); ++s) {
    const MovingSlice slice = neighbors.slice(s);
    for (int k = 0; k < lanes; ++k)
      for (int n = 0; n < slice.length && slice.own[k] != neighbors.nobody(); ++n)
        if (const int place = slice.places[lanes * n + k]; place != neighbors.nobody())
          lists[neighbors.point_at(slice.own[k] / lanes)].push_back(points.numbers[neighbors.point_at(place / lanes)]);
  }
  return lists;
}

template <int D>
void compare_with_all_pairs(double radius) {
  const Points<D> points = random_points<D>(700, 4);
  const auto count = static_cast<int>(points.numbers.size());
  const auto lists = lists_of(points, count, radius);
  for (int i = 0; i < count; ++i) {
    std::vector<int> expected, found = lists[i];
    for (int j = 0; j < count && points.numbers[i] >= 0; ++j)
      if (i != j && points.numbers[j] >= 0 && norm(points.x[j] - points.x[i]) < radius) expected.push_back(points.numbers[j]);
    std::sort(expected.begin(), expected.end());
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, expected) << i;
  }
}
TEST(MovingNeighbors, AreThoseOfASearchOverAllPairs) {
  for (const double radius : {0.3, 1.0, 4.0}) {
    compare_with_all_pairs<2>(radius);
    compare_with_all_pairs<3>(radius);
  }
}

/// The same order of neighbors when the same points come in another order, and for the first half of them alone.
template <int D>
void shuffle() {
  const Points<D> points = random_points<D>(600, 9);
  Points<D> mixed = points;
  std::vector<int> from(points.numbers.size());
  for (std::size_t k = 0; k < from.size(); ++k) from[k] = static_cast<int>((k * 37 + 11) % from.size());
  for (std::size_t k = 0; k < from.size(); ++k) {
    mixed.numbers[k] = points.numbers[from[k]];
    mixed.x.set(static_cast<int>(k), points.x[from[k]]);
  }
  const auto count = static_cast<int>(from.size());
  const auto lists = lists_of(points, count, 1.0), others = lists_of(mixed, count / 2, 1.0);
  for (int k = 0; k < count / 2; ++k) EXPECT_EQ(others[k], lists[from[k]]) << k;
  for (int k = count / 2; k < count; ++k) EXPECT_TRUE(others[k].empty());
}
TEST(MovingNeighbors, HaveOneOrderHoweverPointsCome) {
  shuffle<2>();
  shuffle<3>();
}

}  // namespace
}  // namespace sinew
