/// Neighbor lists against the search of all pairs, radii by number of neighbors, computing order.

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <tuple>

#include "clouds.hpp"
#include "scattered_points.hpp"
#include <sinew/neighbors/cell_list.hpp>
#include <sinew/particles/order.hpp>

namespace sinew {
namespace {

using namespace sinew::testing;

std::vector<int> row_of(const PairList& list, int slot) {
  std::vector<int> row;
  for (int n = 0; n < list.neighbor_count[slot]; ++n) row.push_back(list.entry(list.first_entry[slot / lanes] + n)[slot % lanes]);
  return row;
}

/// Rows: all others within the radius, ascending. Fill: the particle itself. Padding: nothing.
template <int D>
void check_list(const Particles<D>& particles, const std::vector<double>& radius) {
  const PairList list = build_pair_list(particles, radius);
  std::vector<std::vector<int>> expected(particles.slots);
  std::size_t pairs = 0;
  for (const BodyRange& body : particles.bodies)
    for (int i = body.begin; i < body.begin + body.count; ++i) {
      for (int j = body.begin; j < body.begin + body.count; ++j)
        if (j != i && norm(particles.reference(j) - particles.reference(i)) < radius[i]) expected[i].push_back(j);
      pairs += expected[i].size();
    }
  EXPECT_EQ(list.pairs, pairs);
  ASSERT_EQ(list.slices() * lanes, particles.slots);
  for (int slot = 0; slot < particles.slots; ++slot) {
    ASSERT_EQ(row_of(list, slot), expected[slot]) << "particle in slot " << slot;
    const std::size_t first = list.first_entry[slot / lanes], end = list.first_entry[slot / lanes + 1];
    for (std::size_t e = first + expected[slot].size(); e < end; ++e) ASSERT_EQ(list.entry(e)[slot % lanes], slot) << "fill";
  }
  for (int s = 0; s < list.slices(); ++s) {
    const auto* counts = list.neighbor_count.data() + lanes * s;
    EXPECT_EQ(list.first_entry[s + 1] - list.first_entry[s], std::size_t(*std::max_element(counts, counts + lanes)));
  }
}

/// Radii from `shortest` to four times that.
std::vector<double> uneven_radii(int slots, double shortest, Random& random) {
  std::uniform_real_distribution<double> factor(1.0, 4.0);
  std::vector<double> radius(slots);
  for (double& r : radius) r = shortest * factor(random);
  return radius;
}

template <int D>
void check_clouds(double spacing, double shortest_radius) {
  for_each_cloud<D>([&](const std::string& name, const std::vector<Point>& positions) {
    SCOPED_TRACE(name + " in " + std::to_string(D) + "D, spacing " + std::to_string(spacing));
    Random random(32);
    const PointSet points = points_at(positions), other = points_at(in_box<D>(50, {{5, 5, 5}}, random));
    const Particles<D> particles = make_particles<D>({{"a", &points, 1.0, spacing}, {"b", &other, 1.0, spacing}}, 1.0);
    check_list(particles, uneven_radii(particles.slots, shortest_radius, random));
    check_list(particles, std::vector<double>(particles.slots, 2.0 * shortest_radius));
  });
}

TEST(PairList, IsThatOfAllPairs) {
  const Cloud<2> plane = make_cloud<2>(9, 0.4, 2.41, true, 2, 21);
  check_list(plane.particles, plane.radius);
  const Cloud<3> space = make_cloud<3>(5, 0.4, 2.0, true, 2, 22);
  check_list(space.particles, space.radius);
}

TEST(PairList, AnyCloudWithUnevenRadii) {
  check_clouds<2>(1.0, 1.21);
  check_clouds<3>(1.0, 1.21);
}

TEST(PairList, SpacingThatDoesNotFitThePoints) {
  check_clouds<2>(6.0, 1.3);
  check_clouds<3>(6.0, 1.3);
  check_clouds<2>(0.2, 1.3);
  check_clouds<3>(0.2, 1.3);
}

TEST(PairList, RadiiFarAboveAndBelowTheSpacing) {
  check_clouds<2>(1.0, 9.0);
  check_clouds<3>(1.0, 4.0);
  check_clouds<3>(1.0, 0.1);
  check_clouds<3>(1.0, 1e10);
}

/// Points on the limits of bins whose numbers are large and rounded, just within the radius of one another.
TEST(PairList, RoundingLosesNobody) {
  constexpr double spacing = 0.1, far = 1.5e8;
  std::vector<Point> positions{{{0, 0, 0}}};
  for (int k = 0; k < 8; ++k)
    for (int j = 0; j < 8; ++j)
      for (int i = 0; i < 8; ++i)
        positions.push_back({{far + 0.5 * spacing * i, far + 0.5 * spacing * j, far + 0.5 * spacing * k}});
  const PointSet points = points_at(positions);
  const Particles<3> particles = make_particles<3>({{"body", &points, 1.0, spacing}}, 1.0);
  for (int first = 1; first < 512; first += 37) {
    std::vector<double> radius(particles.slots, spacing);
    for (int i = 1; i < particles.count; ++i)
      radius[i] = (1.0 + 1e-12) * norm(particles.reference(1 + (first * i) % 512) - particles.reference(i));
    check_list(particles, radius);
  }
}

TEST(PairList, ParticlesInAnyOrder) {
  Random random(33);
  Cloud<3> cloud = make_cloud<3>(6, 0.3, 2.1, true, 1, 34);
  std::vector<int> other(cloud.particles.slot_of);
  std::shuffle(other.begin(), other.end(), random);
  const VectorField<3> position = cloud.particles.position;
  for (std::size_t i = 0; i < other.size(); ++i) cloud.particles.position.set(cloud.particles.slot_of[i], position[other[i]]);
  check_list(cloud.particles, cloud.radius);
}

TEST(PairList, SameForAnyNumberOfThreads) {
  const Cloud<3> cloud = make_cloud<3>(21, 0.3, 2.41, true, 2, 35);
  ASSERT_GE(cloud.particles.slots, fewest_for_threads);
  const int threads = omp_get_max_threads();
  std::vector<PairList> lists;
  std::vector<std::vector<double>> radii;
  for (const int n : {1, 2, 5}) {
    omp_set_num_threads(n);
    lists.push_back(build_pair_list(cloud.particles, cloud.radius));
    radii.push_back(radius_of_neighbors(cloud.particles, 30.0, cloud.particles.block_numbers()));
  }
  omp_set_num_threads(threads);
  for (std::size_t k = 1; k < lists.size(); ++k) {
    EXPECT_EQ(lists[k].first_entry, lists[0].first_entry);
    EXPECT_EQ(lists[k].neighbor_count, lists[0].neighbor_count);
    EXPECT_EQ(lists[k].pairs, lists[0].pairs);
    EXPECT_TRUE(
        std::equal(lists[k].neighbor.begin(), lists[k].neighbor.end(), lists[0].neighbor.begin(), lists[0].neighbor.end()));
    EXPECT_EQ(radii[k], radii[0]);
  }
}

TEST(RadiusOfNeighbors, HoldsThatMany) {
  const Cloud<2> cloud = make_cloud<2>(12, 0.3, 1.0, false, 1, 24);
  const std::vector<double> radius = radius_of_neighbors(cloud.particles, 12.0, cloud.particles.block_numbers());
  const PairList list = build_pair_list(cloud.particles, radius);
  for (int slot : cloud.particles.slot_of) EXPECT_EQ(list.neighbor_count[slot], 12);
}

/// Halfway in volume between the farthest that is in and the nearest that is out, wherever the points are.
template <int D>
void check_radii(const std::vector<Point>& positions, int wanted) {
  const PointSet points = points_at(positions);
  const Particles<D> particles = make_particles<D>({{"body", &points, 1.0, 1.0}}, 1.0);
  const std::vector<double> radius = radius_of_neighbors(particles, wanted, particles.block_numbers());
  for (int i = 0; i < particles.count; ++i) {
    std::vector<double> distances;
    for (int j = 0; j < particles.count; ++j)
      if (j != i) distances.push_back(norm(particles.reference(j) - particles.reference(i)));
    std::sort(distances.begin(), distances.end());
    const double expected = std::pow(0.5 * (std::pow(distances[wanted - 1], D) + std::pow(distances[wanted], D)), 1.0 / D);
    ASSERT_NEAR(radius[i], expected, 1e-12 * expected) << "particle in slot " << i;
  }
  for (int slot = particles.count; slot < particles.slots; ++slot) EXPECT_EQ(radius[slot], 0.0);
}

TEST(RadiusOfNeighbors, AnyCloud) {
  for (const int wanted : {1, 13, 40}) {
    for_each_cloud<2>([&](const std::string& name, const std::vector<Point>& points) {
      SCOPED_TRACE(name);
      if (points.size() > 42) check_radii<2>(points, wanted);
    });
    for_each_cloud<3>([&](const std::string& name, const std::vector<Point>& points) {
      SCOPED_TRACE(name);
      if (points.size() > 42) check_radii<3>(points, wanted);
    });
  }
}

TEST(CellList, FarPointsAndCentersAnywhere) {
  Random random(37);
  std::vector<Point> points = clusters<3>(random);
  const CellList cells(points, 1.0);
  for (Point center : clusters<3>(random)) {
    std::vector<int> found, expected;
    cells.for_each_within(center, 2.5, [&](int number, double r2) {
      found.push_back(number);
      EXPECT_DOUBLE_EQ(r2, dot(points[number] - center, points[number] - center));
    });
    for (std::size_t i = 0; i < points.size(); ++i)
      if (norm(points[i] - center) < 2.5) expected.push_back(static_cast<int>(i));
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, expected);
  }
}

TEST(CellList, NoPoints) {
  const CellList cells(std::vector<Point>{}, 1.0);
  cells.for_each_within({{0, 0, 0}}, 10.0, [](int, double) { FAIL(); });
}

/// Slabs along the longest axis, in them layers along the shortest, in these by the coordinate along the row.
template <int D>
std::vector<int> sorted_by_definition(const std::vector<Point>& points, double spacing, int slowest, int fastest) {
  Point low = points.front();
  for (const Point& p : points)
    for (int c = 0; c < 3; ++c) low[c] = std::min(low[c], p[c]);
  std::vector<std::tuple<long, long, double, int>> keys;
  auto bin = [&](const Point& p, int axis) { return std::lround((p[axis] - low[axis]) / spacing); };
  for (const Point& p : points)
    keys.emplace_back(bin(p, slowest), D == 3 ? bin(p, 3 - slowest - fastest) : 0, p[fastest], static_cast<int>(keys.size()));
  std::sort(keys.begin(), keys.end());
  std::vector<int> order;
  for (const auto& key : keys) order.push_back(std::get<3>(key));
  return order;
}

TEST(Order, IsThatOfItsDefinition) {
  Random random(38);
  for (const double spacing : {0.05, 0.5, 1.0, 7.0}) {
    const std::vector<Point> space = in_box<3>(900, {{8, 12, 10}}, random), plane = in_box<2>(900, {{20, 31, 0}}, random);
    EXPECT_EQ(row_order(space, spacing, 3), sorted_by_definition<3>(space, spacing, 1, 2));
    EXPECT_EQ(row_order(plane, spacing, 2), sorted_by_definition<2>(plane, spacing, 1, 0));
    std::vector<Point> halves = space;  // on the limits of the bins, and many at one place
    for (Point& p : halves)
      for (int c = 0; c < 3; ++c) p[c] = std::round(2.0 * p[c] / spacing) * 0.5 * spacing;
    EXPECT_EQ(row_order(halves, spacing, 3), sorted_by_definition<3>(halves, spacing, 1, 2));
    std::vector<Point> far = clusters<3>(random);
    for (Point& p : far) p = spacing * p;
    EXPECT_EQ(row_order(far, spacing, 3), sorted_by_definition<3>(far, spacing, 0, 1));
  }
  EXPECT_TRUE(row_order(std::vector<Point>{}, 1.0, 3).empty());
}

/// Blocks of one body cover it, none is too large, and each is a box of whole slabs, layers and places of a lattice, in order of rows.
TEST(Order, BlocksAreCompact) {
  Random random(25);
  for (const double jitter : {0.0, 0.2}) {
    const PointSet points = cloud_points<3>(16, jitter, 0.0, random);  // 18 along x
    const BlockOrder order = block_order(points.position, 1.0, 3, 300);
    ASSERT_GE(order.block_end.size(), 14u);
    EXPECT_EQ(order.block_end.back(), 18 * 16 * 16);
    std::vector<int> row_place(points.position.size());
    for (int place = 0; const int number : row_order(points.position, 1.0, 3)) row_place[number] = place++;
    int begin = 0;
    for (const int end : order.block_end) {
      EXPECT_LE(end - begin, 300);
      EXPECT_GE(end - begin, 100);
      Point low = points.position[order.number[begin]], high = low;
      for (int k = begin; k < end; ++k) {
        EXPECT_TRUE(k == begin || row_place[order.number[k - 1]] < row_place[order.number[k]]);
        for (int c = 0; c < 3; ++c) {
          low[c] = std::min(low[c], points.position[order.number[k]][c]);
          high[c] = std::max(high[c], points.position[order.number[k]][c]);
        }
      }
      double volume = 1.0;
      for (int c = 0; c < 3; ++c) volume *= high[c] - low[c] + 1.0;
      EXPECT_TRUE(jitter > 0.0 || std::abs(volume - (end - begin)) < 1e-9);
      begin = end;
    }
  }
}

/// Points that cannot be cut apart in space are cut anyway.
TEST(Order, BlocksOfPointsInOneBin) {
  const std::vector<Point> points(100, Point{{0.1, 0.1, 0.1}});
  const BlockOrder order = block_order(points, 1.0, 3, 16);
  EXPECT_EQ(order.block_end.back(), 100);
  EXPECT_GE(order.block_end.size(), 7u);
}

TEST(Particles, MassAndVolumeAreThoseOfThePoints) {
  const Cloud<3> cloud = make_cloud<3>(4, 0.2, 2.0, false, 2, 26);
  double mass = 0.0, volume = 0.0;
  for (int slot = 0; slot < cloud.particles.slots; ++slot) mass += cloud.particles.mass[slot];
  for (const PointSet& points : cloud.bodies)
    for (double v : points.volume) volume += v;
  EXPECT_NEAR(mass, 1.3 * volume, 1e-12 * mass);
  for (int user = 0; user < cloud.particles.count; ++user)
    EXPECT_EQ(cloud.particles.user_index[cloud.particles.slot_of[user]], user);
}

}  // namespace
}  // namespace sinew
