/// A reference configuration that is renewed (configuration update).

#include <gtest/gtest.h>

#include <cmath>

#include "clouds.hpp"
#include <sinew/formulations/later_reference.hpp>

namespace sinew {
namespace {

using namespace sinew::testing;

/// A solid of which the reference is renewed when a pair has changed by `threshold`.
template <int D>
std::unique_ptr<TotalLagrangian<D>> renewed_solid(const Cloud<D>& cloud, TotalLagrangianOptions o, double threshold) {
  auto solid = std::make_unique<TotalLagrangian<D>>(cloud.particles, cloud.radius, std::move(o));
  solid->renew_by(std::make_unique<LaterReference<D>>(cloud.particles, std::vector<int>(cloud.particles.blocks.size(), 0),
                                                      cloud.particles, threshold, 1.0));
  return solid;
}

template <int D>
Mat<double, D> some_deformation(double size) {
  Mat<double, D> A = Mat<double, D>::identity();
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) A[i][j] += size * std::sin(1.0 + 2.0 * i + 3.7 * j);
  return A;
}

template <int D>
RecordedState record_of(TotalLagrangian<D>& solid, Cloud<D>& cloud) {
  RecordedState state(cloud.particles.slots);
  if (solid.history().width() > 0) state.inelastic = VectorField<4>(cloud.particles.slots);
  solid.record(cloud.particles, state);
  return state;
}

template <int D>
ForceSummary forces_of(TotalLagrangian<D>& solid, Cloud<D>& cloud, VectorField<D>& forces) {
  forces.clear();
  return solid.internal_forces(cloud.particles, forces);
}

/// Through uniform deformations of which the second is large enough for an update, materials see the same as without one: F, P and energy.
template <int D>
void check_patch(const AnyMaterial& material, bool shape_is_kept) {
  const BlockSize small(60);
  Cloud<D> cloud = make_cloud<D>(D == 3 ? 4 : 7, 0.3, 2.41, true, 1, 1);
  TotalLagrangian<D> plain(cloud.particles, cloud.radius, options<D>(material));
  const auto renewed = renewed_solid<D>(cloud, options<D>(material), 0.12);
  VectorField<D> forces(cloud.particles.slots);
  for (const double size : {0.05, 0.15, 0.22}) {
    displace<D>(cloud.particles, some_deformation<D>(size), 0.0);
    const ForceSummary expected = forces_of<D>(plain, cloud, forces), found = forces_of<D>(*renewed, cloud, forces);
    EXPECT_NEAR(found.strain_energy, expected.strain_energy, 1e-11 * expected.strain_energy);
    EXPECT_NEAR(found.plastic_work, expected.plastic_work, 1e-10 * (expected.plastic_work + expected.strain_energy));
    EXPECT_NEAR(found.smallest_jacobian, expected.smallest_jacobian, 1e-12);
    renewed->rearrange(cloud.particles);
  }
  EXPECT_GE(renewed->reference_updates(), 1);
  const RecordedState a = record_of<D>(plain, cloud), b = record_of<D>(*renewed, cloud);
  double scale = 0.0;
  for (int slot : cloud.particles.slot_of)
    for (int k = 0; k < 9; ++k) scale = std::max(scale, std::abs(a.stress.at(k, slot)));
  for (int slot : cloud.particles.slot_of) {
    Mat3<double> F[2], P[2];
    for (int k = 0; k < 9; ++k) {
      F[0][k / 3][k % 3] = a.deformation_gradient.at(k, slot), F[1][k / 3][k % 3] = b.deformation_gradient.at(k, slot);
      P[0][k / 3][k % 3] = a.stress.at(k, slot), P[1][k / 3][k % 3] = b.stress.at(k, slot);
    }
    const Mat3<double> difference = P[0] * transpose(F[0]) - P[1] * transpose(F[1]);  // of Kirchhoff stresses
    EXPECT_LT(std::sqrt(double_dot(difference, difference)), 1e-10 * scale + 1e-200);
    EXPECT_NEAR(determinant(F[0]), determinant(F[1]), 1e-12);
    for (int k = 0; shape_is_kept && k < 9; ++k) EXPECT_NEAR(F[0][k / 3][k % 3], F[1][k / 3][k % 3], 1e-12);
  }
}

TEST(LaterReference, MaterialsSeeAllOfTheDeformation) {
  Materials::for_each([]<class M>() {
    if constexpr (!std::is_same_v<M, Rigid>) {
      bool shape = true;
      if constexpr (requires { M::in_rates; }) shape = false;
      SCOPED_TRACE(std::string(M::name));
      check_patch<2>(material_with<M>(1.3, 2.0, 0.3), shape);
      check_patch<3>(material_with<M>(1.3, 2.0, 0.3), shape);
    }
  });
}

/// A cloud that has been deformed unevenly, has taken that as its reference, and has gone on.
template <int D>
std::unique_ptr<TotalLagrangian<D>> after_update(Cloud<D>& cloud, const TotalLagrangianOptions& o) {
  auto solid = renewed_solid<D>(cloud, o, 0.05);
  VectorField<D> unused(cloud.particles.slots);
  displace<D>(cloud.particles, some_deformation<D>(0.1), 0.1);
  forces_of<D>(*solid, cloud, unused);
  EXPECT_TRUE(solid->rearrange(cloud.particles));
  displace<D>(cloud.particles, some_deformation<D>(0.14), 0.17);
  return solid;
}

template <int D>
void check_energy_gradient(const AnyMaterial& material, const AnyCorrection& correction, bool conservative) {
  const BlockSize small(30);
  Cloud<D> cloud = make_cloud<D>(D == 3 ? 3 : 6, 0.3, 2.2, true, 1, 4);
  TotalLagrangianOptions o = options<D>(material, 1, CubicSpline{}, correction);
  if (!conservative) o.hourglass.reset();
  const auto solid = after_update<D>(cloud, o);
  VectorField<D> forces(cloud.particles.slots), scratch(cloud.particles.slots);
  forces_of<D>(*solid, cloud, forces);
  const double step = 1e-5;
  double scale = 0.0;
  for (int slot : cloud.particles.slot_of) scale = std::max(scale, norm(forces[slot]));
  for (int user = 0; user < cloud.particles.count; user += 5)
    for (int c = 0; c < D; ++c) {
      const int slot = cloud.particles.slot_of[user];
      double& u = cloud.particles.displacement.at(c, slot);
      const double kept = u;
      double energy[2];
      for (const int side : {0, 1}) {
        u = kept + (side == 1 ? step : -step);
        const ForceSummary summary = forces_of<D>(*solid, cloud, scratch);
        energy[side] = summary.strain_energy + summary.hourglass_energy;
      }
      u = kept;
      EXPECT_NEAR(forces[slot][c], -(energy[1] - energy[0]) / (2.0 * step), 1e-7 * scale);
    }
}

TEST(LaterReference, ForceIsMinusTheGradientOfTheEnergy) {
  ElasticMaterials::for_each([]<class M>() {
    for (const bool conservative : {false, true}) {
      check_energy_gradient<2>(material_with<M>(1.0, 2.0, 0.35), GradientCorrection{}, conservative);
      check_energy_gradient<3>(material_with<M>(1.0, 2.0, 0.35), GradientCorrection{}, conservative);
    }
  });
  for (const AnyCorrection& correction : {AnyCorrection(NoCorrection{}), AnyCorrection(MixedCorrection{})})
    check_energy_gradient<2>(material_with<NeoHookean>(1.0, 2.0, 0.35), correction, false);
}

template <int D>
void check_momenta(const AnyMaterial& material) {
  const BlockSize small(40);
  Cloud<D> cloud = make_cloud<D>(D == 3 ? 5 : 9, 0.3, 2.41, true, 1, 3);
  TotalLagrangianOptions o = options<D>(material);
  o.viscosity = ArtificialViscosity{};
  const auto solid = after_update<D>(cloud, o);
  for (int slot : cloud.particles.slot_of)
    for (int c = 0; c < D; ++c) cloud.particles.velocity.at(c, slot) = std::sin(slot + 2.0 * c);
  VectorField<D> forces(cloud.particles.slots);
  const ForceSummary summary = forces_of<D>(*solid, cloud, forces);
  EXPECT_GT(summary.viscous_power, 0.0);
  Point sum, moment;
  double scale = 0.0;
  for (int slot : cloud.particles.slot_of) {
    Point f;
    for (int c = 0; c < D; ++c) f[c] = forces[slot][c];
    sum += f;
    moment += cross(cloud.particles.current(slot), f);
    scale += norm(f);
  }
  EXPECT_LT(norm(sum), 1e-13 * scale);
  if (!std::holds_alternative<LinearElastic>(material)) {
    o.viscosity.reset();
    const auto still = after_update<D>(cloud, o);
    forces_of<D>(*still, cloud, forces);
    moment = Point();
    for (int slot : cloud.particles.slot_of) {
      Point f;
      for (int c = 0; c < D; ++c) f[c] = forces[slot][c];
      moment += cross(cloud.particles.current(slot), f);
    }
    EXPECT_LT(norm(moment), 1e-11 * scale);
  }
}

TEST(LaterReference, LinearAndAngularMomentum) {
  Materials::for_each([]<class M>() {
    if constexpr (!std::is_same_v<M, Rigid>) {
      SCOPED_TRACE(std::string(M::name));
      check_momenta<2>(material_with<M>(1.3, 2.0, 0.3));
      check_momenta<3>(material_with<M>(1.3, 2.0, 0.3));
    }
  });
}

/// By brute force: the largest change of the length of a pair decides, and whole bodies may move and turn.
TEST(LaterReference, TheLongestPairDecides) {
  Cloud<2> cloud = make_cloud<2>(9, 0.3, 2.41, false, 1, 6);
  const auto solid = renewed_solid<2>(cloud, options<2>(material_with<NeoHookean>(1.3, 2.0, 0.3)), 0.3);
  VectorField<2> forces(cloud.particles.slots);
  const auto moved = [&](double stretch, double shift, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    displace<2>(cloud.particles, Mat<double, 2>{{{c * stretch, -s}, {s * stretch, c}}}, 0.0);
    for (int slot = 0; slot < cloud.particles.slots; ++slot) cloud.particles.displacement.at(0, slot) += shift;
    forces_of<2>(*solid, cloud, forces);
    return solid->rearrange(cloud.particles);
  };
  const auto longest = [&](double stretch) {
    double most = 0.0;
    for (const int i : cloud.particles.slot_of)
      for (const int j : cloud.particles.slot_of) {
        const Vec<double, 2> X = cloud.particles.position[j] - cloud.particles.position[i];
        if (i == j || norm(X) >= 2.41) continue;
        most = std::max(most, std::abs(std::hypot(stretch * X[0], X[1]) / norm(X) - 1.0));
      }
    return most;
  };
  EXPECT_FALSE(moved(1.0, 50.0, 2.0));
  EXPECT_FALSE(moved(1.25, 60.0, -1.0));
  double below = 1.25, above = 1.4;
  ASSERT_LT(longest(below), 0.3);
  ASSERT_GT(longest(above), 0.3);
  for (int k = 0; k < 40; ++k) (longest(0.5 * (below + above)) < 0.3 ? below : above) = 0.5 * (below + above);
  EXPECT_FALSE(moved(below - 1e-9, 60.0, 1.0));
  EXPECT_FALSE(moved(2.0 - above + 0.05, -3.0, 0.3));
  EXPECT_TRUE(moved(above + 1e-9, 10.0, 0.5));
  EXPECT_FALSE(moved(above + 1e-9, 12.0, 0.1));
}

/// The measure of the energy in the hourglass stiffness is what an update takes.
TEST(LaterReference, TheHourglassEnergyIsReleased) {
  Cloud<3> cloud = make_cloud<3>(5, 0.3, 2.41, true, 1, 7);
  const auto solid = renewed_solid<3>(cloud, options<3>(material_with<NeoHookean>(1.3, 2.0, 0.3)), 0.05);
  VectorField<3> forces(cloud.particles.slots);
  displace<3>(cloud.particles, some_deformation<3>(0.1), 0.2);
  const ForceSummary before = forces_of<3>(*solid, cloud, forces);
  ASSERT_GT(before.hourglass_energy, 1e-4);
  ASSERT_TRUE(solid->rearrange(cloud.particles));
  EXPECT_NEAR(total_of(solid->block_summaries()).released, before.hourglass_energy, 1e-14);
  EXPECT_EQ(solid->stored_energy().hourglass, 0.0);
  const ForceSummary after = forces_of<3>(*solid, cloud, forces);
  EXPECT_LT(after.hourglass_energy, 1e-25);
  EXPECT_NEAR(after.strain_energy, before.strain_energy, 1e-12 * before.strain_energy);
}

/// One that has lost its neighbors keeps its stress and has no force; a correction of its gradient does not exist.
TEST(LaterReference, ALonelyParticleHasNoForce) {
  Cloud<2> cloud = make_cloud<2>(6, 0.0, 2.41, false, 1, 8);
  const auto solid = renewed_solid<2>(cloud, options<2>(material_with<RateForm<ElasticRate>>(1.3, 2.0, 0.3)), 0.5);
  VectorField<2> forces(cloud.particles.slots);
  const int corner = cloud.particles.slot_of[0], next = cloud.particles.slot_of[1];
  cloud.particles.displacement.set(corner, Vec<double, 2>{{-9.0, -8.0}});
  cloud.particles.displacement.set(next, Vec<double, 2>{{-9.0, -8.0}});
  forces_of<2>(*solid, cloud, forces);
  ASSERT_TRUE(solid->rearrange(cloud.particles));
  EXPECT_EQ(solid->pairs().neighbor_count[corner], 1);
  cloud.particles.displacement.at(1, corner) += 0.3;
  const ForceSummary summary = forces_of<2>(*solid, cloud, forces);
  EXPECT_TRUE(summary.finite);
  EXPECT_EQ(norm(forces[corner]), 0.0);
}

}  // namespace
}  // namespace sinew
