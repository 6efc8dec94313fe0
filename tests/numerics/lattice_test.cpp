/// Slices that go without a pair list, and weights that are not stored in double precision, against the list with stored weights; that one is
/// compared with the slow reference in oracle_test.cpp.

#include <gtest/gtest.h>

#include "clouds.hpp"

namespace sinew {
namespace {

using namespace sinew::testing;

/// Lattice points 0 <= X < n + 5, 0 <= Y < n + 2, 0 <= Z < n of which `keep` is true.
template <int D, class Keep>
PointSet lattice_points(int n, double shift, Keep&& keep) {
  PointSet points;
  points.spacing = 1.0;
  for (int k = 0; k < (D == 3 ? n : 1); ++k)
    for (int j = 0; j < n + 2; ++j)
      for (int i = 0; i < n + 5; ++i) {
        const Point p{{i + shift, j + 0.0, k + 0.0}};
        if (!keep(i, j, k)) continue;
        points.position.push_back(p);
        points.volume.push_back(1.0);
      }
  return points;
}

template <int D>
Particles<D> particles_of(const std::vector<PointSet>& bodies) {
  std::vector<BodyPoints> parts;
  for (const PointSet& points : bodies) parts.push_back({"body", &points, 1.3, 1.0});
  Particles<D> particles = make_particles<D>(parts, 1.0);
  Mat<double, D> A = Mat<double, D>::identity();
  A[0][0] = 1.1, A[0][1] = 0.2, A[1][0] = -0.1;
  displace<D>(particles, A, 0.05);
  return particles;
}

template <int D>
std::vector<Vec<double, D>> forces_of(Particles<D> particles, TotalLagrangian<D>& solid, ForceSummary* summary = nullptr) {
  VectorField<D> total(particles.slots);
  const ForceSummary s = solid.internal_forces(particles, total);
  if (summary) *summary = s;
  std::vector<Vec<double, D>> forces;
  for (int slot : particles.slot_of) forces.push_back(total[slot]);
  return forces;
}

template <int D>
double difference(const std::vector<Vec<double, D>>& a, const std::vector<Vec<double, D>>& b) {
  double worst = 0.0, largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    worst = std::max(worst, norm(a[i] - b[i]));
    largest = std::max(largest, norm(a[i]));
  }
  return worst / largest;
}

enum class Share { all, most };

std::vector<int> sorted(std::vector<int> slots) {
  std::sort(slots.begin(), slots.end());
  return slots;
}

/// Compares with the list; `share`: of the slices that have to have a pattern.
template <int D>
void compare_in_blocks(const std::vector<PointSet>& bodies, Share share, double support, int block) {
  const BlockSize size(block);
  Particles<D> particles = particles_of<D>(bodies);
  const std::vector<double> radius(particles.slots, support);
  const int count = static_cast<int>(bodies.size());
  for (const char* form : {"conservative", "half"}) {
    TotalLagrangianOptions o = options<D>(material_with<NeoHookean>(1.3, 2.0, 0.4), count);
    o.hourglass->normalization.value = form;
    TotalLagrangian<D> lattice(particles, radius, o);
    o.lattice = false;
    TotalLagrangian<D> listed(particles, radius, o);
    const int slices = lattice.pairs().blocks.slices();
    EXPECT_GT(lattice.lattice().slices(), share == Share::all ? slices - 1 : slices / 2);
    EXPECT_LT(lattice.lattice().slices(), share == Share::all ? slices + 1 : slices);
    EXPECT_EQ(listed.lattice().slices(), 0);
    for (int slot : particles.slot_of)
      ASSERT_EQ(sorted(lattice.pairs().neighbors(slot, particles)), sorted(listed.pairs().neighbors(slot, particles))) << slot;

    ForceSummary a, b;
    EXPECT_LT(difference(forces_of(particles, lattice, &a), forces_of(particles, listed, &b)), 1e-12) << form;
    EXPECT_NEAR(a.strain_energy, b.strain_energy, 1e-12 * b.strain_energy);
    EXPECT_NEAR(a.hourglass_energy, b.hourglass_energy, 1e-11 * b.strain_energy);
    EXPECT_NEAR(a.smallest_jacobian, b.smallest_jacobian, 1e-12);
    EXPECT_NEAR(a.largest_rate2, b.largest_rate2, 1e-12 * b.largest_rate2);
    EXPECT_NEAR(lattice.hourglass_time_step(), listed.hourglass_time_step(), 1e-12 * listed.hourglass_time_step());

    RecordedState with(particles.slots), without(particles.slots);
    with.hourglass_error = without.hourglass_error = AlignedArray<double>(particles.slots);
    lattice.record(particles, with);
    listed.record(particles, without);
    for (int slot : particles.slot_of) {
      EXPECT_NEAR(with.hourglass_error[slot], without.hourglass_error[slot], 1e-12);
      for (int c = 0; c < 9; ++c) EXPECT_NEAR(with.stress.at(c, slot), without.stress.at(c, slot), 1e-11);
    }
  }
}

template <int D>
void compare_with_list(const std::vector<PointSet>& bodies, Share share, double support = 2.41) {
  for (const int block : {largest_block, 200}) compare_in_blocks<D>(bodies, share, support, block);
}

const auto everything = [](int, int, int) { return true; };

TEST(Lattice, BoxesNeedNoList) {
  compare_with_list<2>({lattice_points<2>(14, 0.0, everything)}, Share::all);
  compare_with_list<3>({lattice_points<3>(6, 0.0, everything)}, Share::all);
  compare_with_list<3>({lattice_points<3>(6, 0.0, everything)}, Share::all, 3.3);
}

TEST(Lattice, HolesAndCorners) {
  const auto hole = [](int i, int j, int) { return !(i > 4 && i < 9 && j > 5 && j < 9); };
  const auto corner = [](int i, int j, int k) { return i < 6 || j < 8 || k > 3; };
  compare_with_list<2>({lattice_points<2>(24, 0.0, hole)}, Share::all);
  compare_with_list<3>({lattice_points<3>(7, 0.0, hole)}, Share::all);
  compare_with_list<3>({lattice_points<3>(8, 0.0, corner)}, Share::all);
}

TEST(Lattice, BodiesSideBySideStayApart) {
  compare_with_list<2>(
      {lattice_points<2>(9, 0.0, everything), lattice_points<2>(11, 30.0, everything), lattice_points<2>(8, 60.0, everything)},
      Share::all);
}

/// One point is out of its place, another has its own volume: the slices that see them have a list, the others do not.
TEST(Lattice, IrregularSlicesOfARegularBody) {
  for (bool moved : {true, false}) {
    PointSet points = lattice_points<2>(30, 0.0, everything);
    if (moved)
      points.position[500][0] += 0.1;
    else
      points.volume[500] = 1.2;
    compare_with_list<2>({points}, Share::most);
  }
}

TEST(Lattice, RegularAndDisturbedBodies) {
  std::mt19937_64 random(3);
  compare_with_list<3>({lattice_points<3>(6, 0.0, everything), cloud_points<3>(5, 0.2, 40.0, random)}, Share::most);
}

TEST(Lattice, DisturbedBodiesHaveNone) {
  const Cloud<3> cloud = make_cloud<3>(6, 0.2, 2.41, false, 1, 4);
  TotalLagrangian<3> solid(cloud.particles, cloud.radius, options<3>(material_with<NeoHookean>(1.3, 2.0, 0.4)));
  EXPECT_EQ(solid.lattice().slices(), 0);
}

template <int D>
std::vector<Vec<double, D>> forces_with(const Cloud<D>& cloud, WeightStorage weights, const char* form) {
  TotalLagrangianOptions o = options<D>(material_with<StVenantKirchhoff>(1.3, 2.0, 0.3));
  o.hourglass->normalization.value = form;
  o.weights = weights;
  TotalLagrangian<D> solid(cloud.particles, cloud.radius, o);
  return forces_of(cloud.particles, solid);
}

template <int D>
void check_weights() {
  const BlockSize small(100);
  Cloud<D> cloud = make_cloud<D>(D == 3 ? 6 : 14, 0.2, 2.41, true, 1, 8);
  Mat<double, D> A = Mat<double, D>::identity();
  A[0][1] = 0.2, A[1][1] = 1.1;
  displace<D>(cloud.particles, A, 0.05);
  for (const char* form : {"conservative", "half"}) {
    const auto stored = forces_with(cloud, WeightStorage::stored, form);
    EXPECT_LT(difference(forces_with(cloud, WeightStorage::computed, form), stored), 1e-12);
    const double single = difference(forces_with(cloud, WeightStorage::single, form), stored);
    EXPECT_LT(single, 1e-6);
    EXPECT_GT(single, 1e-10);
  }
}

TEST(Weights, ComputedAreTheStoredOnesAndSingleOnesAreNear) {
  check_weights<2>();
  check_weights<3>();
}

/// Rounded weights keep linear fields exact: no force inside and no hourglass energy.
TEST(Weights, SingleOnesPassThePatchTest) {
  Cloud<3> cloud = make_cloud<3>(6, 0.2, 2.41, false, 1, 9);
  Mat<double, 3> A = Mat<double, 3>::identity();
  A[0][1] = 0.2, A[2][2] = 1.1;
  displace<3>(cloud.particles, A, 0.0);
  TotalLagrangianOptions o = options<3>(material_with<StVenantKirchhoff>(1.3, 2.0, 0.3));
  o.weights = WeightStorage::single;
  TotalLagrangian<3> solid(cloud.particles, cloud.radius, o);
  RecordedState state(cloud.particles.slots);
  const ForceSummary summary = solid.record(cloud.particles, state);
  for (int slot : cloud.particles.slot_of)
    for (int c = 0; c < 9; ++c) EXPECT_NEAR(state.deformation_gradient.at(c, slot), A[c / 3][c % 3], 1e-13);
  EXPECT_LT(std::abs(summary.hourglass_energy), 1e-13 * summary.strain_energy);
}

}  // namespace
}  // namespace sinew
