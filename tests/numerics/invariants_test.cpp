/// What must hold for every arrangement: patch test, momentum, rotation, the force as gradient of the energy, dual support.

#include <gtest/gtest.h>

#include "clouds.hpp"
#include <sinew/core/error.hpp>

namespace sinew {
namespace {

using namespace sinew::testing;

const auto rubber = material_with<NeoHookean>(1.3, 2.0, 0.4);

Mat<double, 3> rotation(double angle) {
  return {{{std::cos(angle), -std::sin(angle), 0.0}, {std::sin(angle), std::cos(angle), 0.0}, {0.0, 0.0, 1.0}}};
}

template <int D>
void check_patch(const Mat<double, D>& A, const AnyCorrection& correction = GradientCorrection{}) {
  Cloud<D> cloud = make_cloud<D>(D == 3 ? 5 : 9, 0.4, 2.41, true, 1, 1);
  displace<D>(cloud.particles, A, 0.0);
  TotalLagrangian<D> solid(cloud.particles, cloud.radius, options<D>(rubber, 1, CubicSpline{}, correction));
  RecordedState state(cloud.particles.slots);
  const ForceSummary summary = solid.record(cloud.particles, state);
  for (int slot : cloud.particles.slot_of)
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) EXPECT_NEAR(state.deformation_gradient.at(3 * i + j, slot), A[i][j], 1e-12);
  EXPECT_NEAR(summary.hourglass_energy, 0.0, 1e-12 * summary.strain_energy);
}

TEST(Invariants, PatchTestOnDisturbedParticles) {
  for (const AnyCorrection& correction :
       {AnyCorrection(GradientCorrection{}), AnyCorrection(MixedCorrection{}), AnyCorrection(LinearCorrection{})}) {
    check_patch<2>({{{1.1, 0.2}, {-0.1, 0.95}}}, correction);
    check_patch<3>({{{1.1, 0.2, 0.0}, {-0.1, 0.9, 0.05}, {0.03, 0.0, 1.05}}}, correction);
  }
}

TEST(Invariants, ARigidRotationLeavesNoStress) {
  Cloud<3> cloud = make_cloud<3>(5, 0.3, 2.41, true, 1, 2);
  displace<3>(cloud.particles, rotation(1.0), 0.0);
  TotalLagrangian<3> solid(cloud.particles, cloud.radius, options<3>(rubber));
  RecordedState state(cloud.particles.slots);
  solid.record(cloud.particles, state);
  for (int slot : cloud.particles.slot_of)
    for (int k = 0; k < 9; ++k) EXPECT_NEAR(state.stress.at(k, slot), 0.0, 1e-12 * 2.0);
}

template <int D>
void check_momentum(AnyCorrection correction, bool torque) {
  const BlockSize small(40);
  Cloud<D> cloud = make_cloud<D>(D == 3 ? 5 : 9, 0.4, 2.41, true, 1, 3);
  displace<D>(cloud.particles, Mat<double, D>::identity(), 0.15);
  TotalLagrangianOptions o = options<D>(rubber, 1, WendlandC2{}, correction);
  if (torque && !std::holds_alternative<GradientCorrection>(correction)) o.hourglass.reset();
  TotalLagrangian<D> solid(cloud.particles, cloud.radius, o);
  VectorField<D> forces(cloud.particles.slots);
  solid.internal_forces(cloud.particles, forces);
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
  if (torque) {
    EXPECT_LT(norm(moment), 1e-11 * scale);
  }
}

/// Of every correction that is exact for linear fields; the hourglass stiffness only with the first of them, whose F is what minimizes its energy.
TEST(Invariants, LinearAndAngularMomentum) {
  check_momentum<2>(GradientCorrection{}, true);
  check_momentum<3>(GradientCorrection{}, true);
  check_momentum<2>(MixedCorrection{}, true);
  check_momentum<3>(MixedCorrection{}, true);
  check_momentum<2>(LinearCorrection{}, true);
  check_momentum<3>(LinearCorrection{}, true);
}

/// Uncorrected and Shepard gradients keep linear momentum only: F X_ij is then not consistent with x_ij.
TEST(Invariants, LinearMomentumWithEveryCorrection) {
  check_momentum<2>(NoCorrection{}, false);
  check_momentum<2>(ShepardCorrection{}, false);
  check_momentum<3>(ShepardCorrection{}, false);
}

/// f = -dE/dx by central differences, for every material and correction, with uneven radii; E includes the conservative hourglass energy.
template <int D>
void check_energy_gradient(const AnyMaterial& material, const AnyCorrection& correction, bool hourglass) {
  Cloud<D> cloud = make_cloud<D>(D == 3 ? 3 : 6, 0.3, 2.2, true, 1, 4);
  displace<D>(cloud.particles, Mat<double, D>::identity(), 0.1);
  TotalLagrangianOptions o = options<D>(material, 1, CubicSpline{}, correction);
  if (!hourglass) o.hourglass.reset();
  TotalLagrangian<D> solid(cloud.particles, cloud.radius, o);
  const auto energy = [&](VectorField<D>& unused) {
    const ForceSummary summary = solid.internal_forces(cloud.particles, unused);
    return summary.strain_energy + summary.hourglass_energy;
  };
  VectorField<D> forces(cloud.particles.slots), scratch(cloud.particles.slots);
  solid.internal_forces(cloud.particles, forces);
  const double step = 1e-5;
  double scale = 0.0;
  for (int slot : cloud.particles.slot_of) scale = std::max(scale, norm(forces[slot]));
  for (int user = 0; user < cloud.particles.count; user += 5)
    for (int c = 0; c < D; ++c) {
      double& u = cloud.particles.displacement.at(c, cloud.particles.slot_of[user]);
      const double kept = u;
      u = kept + step;
      const double after = energy(scratch);
      u = kept - step;
      const double before = energy(scratch);
      u = kept;
      EXPECT_NEAR(forces[cloud.particles.slot_of[user]][c], -(after - before) / (2.0 * step), 1e-7 * scale);
    }
}

TEST(Invariants, ForceIsMinusTheGradientOfTheEnergy) {
  ElasticMaterials::for_each([]<class M>() {
    for (bool hourglass : {false, true}) {
      check_energy_gradient<2>(material_with<M>(1.0, 2.0, 0.35), GradientCorrection{}, hourglass);
      check_energy_gradient<3>(material_with<M>(1.0, 2.0, 0.35), GradientCorrection{}, hourglass);
    }
  });
  Corrections::for_each([]<class C>() { check_energy_gradient<2>(rubber, C{}, false); });
}

/// j sees i though i does not see j: the pair still pushes both ends with opposite forces.
TEST(Invariants, DualSupport) {
  PointSet points;
  points.spacing = 1.0;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      points.position.push_back({{double(i), double(j), 0.0}});
      points.volume.push_back(1.0);
    }
  Particles<2> particles = make_particles<2>({{"body", &points, 1.0, 1.0}}, 1.0);
  std::vector<double> radius(particles.slots, 1.5);
  radius[particles.slot_of[0]] = 3.2;
  TotalLagrangian<2> solid(particles, radius, options<2>(rubber));
  const int corner = particles.slot_of[0], far = particles.slot_of[3];
  EXPECT_EQ(solid.pairs().neighbor_count[corner], 12);  // of the 15 others all but (2, 3), (3, 2) and (3, 3)
  EXPECT_EQ(solid.pairs().neighbor_count[far], 3);
  VectorField<2> before(particles.slots), after(particles.slots);
  solid.internal_forces(particles, before);
  particles.displacement.at(0, far) += 1e-3;  // only the corner sees this one at distance 3
  solid.internal_forces(particles, after);
  Vec<double, 2> sum;
  for (int slot : particles.slot_of) sum += after[slot];
  EXPECT_LT(norm(sum), 1e-15);
  EXPECT_GT(norm(after[corner] - before[corner]), 1e-8);
}

TEST(Invariants, TooFewNeighborsAreNamed) {
  PointSet points;
  points.spacing = 1.0;
  for (int i = 0; i < 5; ++i) points.position.push_back({{double(i), 0.0, 0.0}});
  points.volume.assign(5, 1.0);
  const Particles<2> particles = make_particles<2>({{"wire", &points, 1.0, 1.0}}, 1.0);
  try {
    TotalLagrangian<2> solid(particles, std::vector<double>(particles.slots, 2.41), options<2>(rubber));
    FAIL() << "no error";
  } catch (const CaseError& error) {
    EXPECT_EQ(
        std::string(error.what()),
        "body \"wire\": particle 0 at (0, 0, 0) has 2 neighbors, too few (or all in one line) to correct its gradient. Make "
        "[formulation] support larger or spacing smaller, fill the shape there, or choose another correction than \"gradient\".");
  }
}

}  // namespace
}  // namespace sinew
