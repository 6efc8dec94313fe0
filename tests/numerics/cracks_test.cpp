/// Failed particles as obstacles between others, and bodies from which some have separated.

#include <gtest/gtest.h>

#include <algorithm>

#include "clouds.hpp"
#include "scattered_points.hpp"
#include <sinew/formulations/damage_point.hpp>
#include <sinew/formulations/separation.hpp>

namespace sinew {
namespace {

using namespace sinew::testing;

template <int D>
Vec<double, D> lattice_place(int number) {
  Vec<double, D> X;
  for (int c = 0; c < D; ++c, number /= 9) X[c] = number % 9 - 4;
  return X;
}

/// A full line (plane) of failed particles lets no pair through and leaves the sides of it alone, also for supports that are larger than usual.
template <int D>
void check_plane() {
  Cracks<D> cracks(3.5);
  const int count = D == 2 ? 81 : 729;
  std::vector<FailedParticle<D>> failed;
  for (int n = 0; n < count; ++n)
    if (lattice_place<D>(n)[0] == 0.0) failed.push_back({lattice_place<D>(n), 0.6, 0.5, 0, n});
  cracks.add(failed);
  for (int i = 0; i < count; ++i)
    for (int j = 0; j < count; ++j) {
      const Vec<double, D> a = lattice_place<D>(i), b = lattice_place<D>(j);
      if (i == j || norm(b - a) > 3.5) continue;
      EXPECT_EQ(cracks.cuts(a, b, 0), a[0] * b[0] <= 0.0) << "from " << i << " to " << j;
      EXPECT_FALSE(cracks.cuts(a, b, 1)) << "of another body";
    }
}
TEST(Cracks, AFullPlaneLetsNothingThrough) {
  check_plane<2>();
  check_plane<3>();
}

/// Against all failed particles, and the same from both ends.
TEST(Cracks, AreFoundByTheirCells) {
  Random random(7);
  std::uniform_real_distribution<double> place(-4.0, 4.0), reach(0.05, 0.6);
  const auto anywhere = [&] { return Vec<double, 3>{{place(random), place(random), place(random)}}; };
  Cracks<3> cracks(2.4);
  for (int n = 0; n < 60; ++n) {
    const FailedParticle<3> one{anywhere(), reach(random), 0.1, n % 2, n};
    cracks.add(std::span(&one, 1));
  }
  int cut = 0;
  for (int k = 0; k < 3000; ++k) {
    const Vec<double, 3> a = anywhere(), way = anywhere(), b = a + (2.4 / norm(way)) * (0.25 * std::abs(place(random))) * way;
    const bool expected = std::any_of(cracks.all().begin(), cracks.all().end(),
                                      [&](const auto& p) { return p.body == 0 && p.stands_between(a, b); });
    EXPECT_EQ(cracks.cuts(a, b, 0), expected);
    EXPECT_EQ(cracks.cuts(b, a, 0), expected);
    if (expected) {
      ++cut;
      EXPECT_TRUE(cracks.near(a, 0));
    }
  }
  EXPECT_GT(cut, 50);
  ASSERT_NE(cracks.find(17), nullptr);
  EXPECT_EQ(cracks.find(17)->number, 17);
  EXPECT_EQ(cracks.find(60), nullptr);
}

template <int D>
TotalLagrangianOptions breakable(AnyCorrection correction = GradientCorrection{}) {
  TotalLagrangianOptions o = options<D>(material_with<NeoHookean>(1.3, 2.0, 0.4), 1, WendlandC2{}, correction);
  PrincipalStrainDamage damage;
  damage.threshold = 100.0;
  damage.growth.separate = true;
  o.damages.emplace_back(damage);
  return o;
}

/// Numbers of all particles on one side of a tilted plane and of those in a layer of it, {number, radius}.
template <int D>
std::vector<double> layer(const Particles<D>& particles) {
  std::vector<double> rows;
  for (int slot : particles.slot_of)
    if (std::abs(particles.position[slot][0] - 0.3 * particles.position[slot][1] - 3.0) < 0.6)
      rows.insert(rows.end(), {static_cast<double>(particles.user_index[slot]), 0.4});
  return rows;
}

/// Gradients of what is left are exact for linear fields, failed particles have none, and no force is made from nothing.
template <int D>
void check_patch() {
  const BlockSize small(40);
  const Mat<double, D> A = Mat<double, D>::identity() + 0.1 * outer(Vec<double, D>{{1.0, 0.5}}, Vec<double, D>{{0.3, -1.0}});
  Cloud<D> cloud = make_cloud<D>(D == 3 ? 6 : 9, 0.3, 2.41, true, 1, 1);
  displace<D>(cloud.particles, A, 0.0);
  TotalLagrangian<D> solid(cloud.particles, cloud.radius, breakable<D>());
  const std::vector<double> gone = layer(cloud.particles);
  solid.restore_cracks(cloud.particles, gone, solid.most_stiffness());
  RecordedState state(cloud.particles.slots);
  state.inelastic = VectorField<4>(cloud.particles.slots);
  const ForceSummary summary = solid.record(cloud.particles, state);
  for (int slot : cloud.particles.slot_of) {
    const bool failed = solid.cracks().find(cloud.particles.user_index[slot]) != nullptr;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
        EXPECT_NEAR(state.deformation_gradient.at(3 * i + j, slot), failed ? double(i == j) : A[i][j], 1e-12);
    for (const int j : solid.pairs().neighbors(slot, cloud.particles))
      EXPECT_TRUE(j == slot || !failed) << "a failed particle sees somebody";
  }
  EXPECT_EQ(2 * solid.cracks().all().size(), gone.size());
  EXPECT_GT(gone.size(), 10U);
  EXPECT_NEAR(summary.hourglass_energy, 0.0, 1e-12 * summary.strain_energy);
}
TEST(Separation, PatchTestOnBothSidesOfACrack) {
  check_patch<2>();
  check_patch<3>();
}

/// Two halves that have come apart do not feel each other: one moves as a whole, and no force is anywhere. With every correction, which have weights of their own.
TEST(Separation, HalvesMoveFreely) {
  for (const AnyCorrection& correction :
       {AnyCorrection(GradientCorrection{}), AnyCorrection(NoCorrection{}), AnyCorrection(ShepardCorrection{})})
    for (const WeightStorage storage : {WeightStorage::stored, WeightStorage::computed}) {
      Cloud<2> cloud = make_cloud<2>(9, 0.2, 2.41, false, 1, 4);
      TotalLagrangianOptions o = breakable<2>(correction);
      o.weights = storage;
      TotalLagrangian<2> solid(cloud.particles, cloud.radius, o);
      solid.restore_cracks(cloud.particles, layer(cloud.particles), solid.most_stiffness());
      for (int slot : cloud.particles.slot_of)
        if (cloud.particles.position[slot][0] - 0.3 * cloud.particles.position[slot][1] > 3.0)
          cloud.particles.displacement.set(slot, {{0.7, -0.4}});
      VectorField<2> forces(cloud.particles.slots);
      const ForceSummary summary = solid.internal_forces(cloud.particles, forces);
      EXPECT_NEAR(summary.strain_energy + summary.hourglass_energy, 0.0, 1e-24);
      for (int slot : cloud.particles.slot_of) EXPECT_LT(norm(forces[slot]), 1e-13);
    }
}

/// A particle that would keep only neighbors in one line fails as well.
TEST(Separation, WhatIsLeftAloneFailsToo) {
  Cloud<2> cloud = make_cloud<2>(7, 0.0, 1.6, false, 1, 5);  // 9 x 7 particles, eight neighbors each
  const Particles<2>& particles = cloud.particles;
  const TotalLagrangianOptions o = breakable<2>();
  BlockPairs<2> pairs = make_block_pairs(particles, build_pair_list(particles, cloud.radius), cloud.radius, false);
  const WeightOptions weight_options{o.kernel, o.correction, HourglassWeight::conservative, WeightStorage::stored};
  PairWeights<2> weights = make_pair_weights<2>({particles, pairs}, cloud.radius, weight_options);
  HistoryStore history(particles.blocks, {numbers_of(*o.damages[0])});
  Cracks<2> cracks(1.6);
  const int lonely = particles.slot_of[4];  // on the lower edge, at X = 4
  for (int slot : particles.slot_of) {
    const Vec<double, 2> X = particles.position[slot];
    const bool fails = X[1] == 1.0 && std::abs(X[0] - 4.0) < 1.5;  // the three above it
    if (fails) history.of(0).values[slot - history.of(0).first] = 1.0;
  }
  std::vector<ForceSummary> summaries(1);
  const Comm alone;
  Separation<2> separation({alone, o, weight_options, particles, pairs, weights, history, cracks});
  EXPECT_TRUE(separation.cut_off_failed(summaries).empty()) << "nobody said that something fails";
  summaries[0].fails = true;
  EXPECT_EQ(separation.cut_off_failed(summaries), std::vector<char>{1});
  EXPECT_EQ(cracks.all().size(), 4U);
  EXPECT_NE(cracks.find(particles.user_index[lonely]), nullptr);
  EXPECT_EQ(history.of(0).values[lonely - history.of(0).first], 1.0);
  EXPECT_TRUE(separation.cut_off_failed(summaries).empty()) << "once is enough";
}

}  // namespace
}  // namespace sinew
