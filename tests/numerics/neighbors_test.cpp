/// Neighbor lists against the search of all pairs, radii by number of neighbors, computing order.

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "clouds.hpp"
#include <sinew/neighbors/cell_list.hpp>
#include <sinew/particles/order.hpp>

namespace sinew {
namespace {

using namespace sinew::testing;

template <int D>
void check_list(const Cloud<D>& cloud) {
  const PairList list = build_pair_list(cloud.particles, cloud.radius);
  std::size_t pairs = 0;
  for (const BodyRange& body : cloud.particles.bodies)
    for (int i = body.begin; i < body.begin + body.count; ++i) {
      std::set<int> expected, found;
      for (int j = body.begin; j < body.begin + body.count; ++j)
        if (j != i && norm(cloud.particles.reference(j) - cloud.particles.reference(i)) < cloud.radius[i]) expected.insert(j);
      for (int n = 0; n < list.neighbor_count[i]; ++n)
        found.insert(list.neighbor[lanes * (list.first_entry[i / lanes] + n) + i % lanes]);
      EXPECT_EQ(found, expected) << "particle in slot " << i;
      pairs += expected.size();
    }
  EXPECT_EQ(list.pairs, pairs);
}

TEST(PairList, IsThatOfAllPairs) {
  check_list(make_cloud<2>(9, 0.4, 2.41, true, 2, 21));
  check_list(make_cloud<3>(5, 0.4, 2.0, true, 2, 22));
}

TEST(PairList, FillPointsToTheParticleItself) {
  const Cloud<3> cloud = make_cloud<3>(3, 0.2, 2.0, false, 1, 23);
  const PairList list = build_pair_list(cloud.particles, cloud.radius);
  for (int s = 0; s < list.slices(); ++s)
    for (std::size_t e = list.first_entry[s]; e < list.first_entry[s + 1]; ++e)
      for (int k = 0; k < lanes; ++k)
        if (static_cast<int>(e - list.first_entry[s]) >= list.neighbor_count[lanes * s + k]) {
          EXPECT_EQ(list.entry(e)[k], lanes * s + k);
        }
}

TEST(PairList, RadiusOfNeighborsHoldsThatMany) {
  const Cloud<2> cloud = make_cloud<2>(12, 0.3, 1.0, false, 1, 24);
  const std::vector<double> radius = radius_of_neighbors(cloud.particles, 12.0);
  const PairList list = build_pair_list(cloud.particles, radius);
  for (int slot : cloud.particles.slot_of) EXPECT_EQ(list.neighbor_count[slot], 12);
}

TEST(CellList, CoarseGridOfFarPoints) {
  const std::vector<Point> points{{{0, 0, 0}}, {{1e9, 0, 0}}, {{1e9, 1, 0}}};
  const CellList cells(points, 1.0);
  int found = 0;
  cells.for_each_within({{1e9, 0, 0}}, 1.5, [&](int, double) { ++found; });
  EXPECT_EQ(found, 2);
}

TEST(Order, IsAPermutationAndShortensTheReach) {
  std::mt19937_64 random(25);
  const PointSet points = cloud_points<3>(12, 0.2, 0.0, random);
  std::vector<int> order = computing_order(points.position, 1.0, 3);
  const Particles<3> particles = make_particles<3>({{"body", &points, 1.0, 1.0}}, 1.0);
  const PairList list = build_pair_list(particles, std::vector<double>(particles.slots, 2.41));
  EXPECT_LE(reach(list, 0, particles.slots), 4 * 12 * 12);
  std::sort(order.begin(), order.end());
  for (std::size_t i = 0; i < order.size(); ++i) EXPECT_EQ(order[i], static_cast<int>(i));
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
