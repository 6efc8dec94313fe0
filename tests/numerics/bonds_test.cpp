/// The extended methods against a slow reference and against what they promise: averages over bonds, both forms of momentum, JST dissipation.

#include <gtest/gtest.h>

#include "clouds.hpp"
#include "reference/bonds_minimal.hpp"

namespace sinew {
namespace {

using namespace sinew::testing;

const auto rubber = material_with<NeoHookean>(1.3, 2.0, 0.4);

template <int D>
Mat<double, D> shear() {
  if constexpr (D == 2)
    return {{{1.1, 0.2}, {-0.1, 0.95}}};
  else
    return {{{1.1, 0.2, 0.0}, {-0.1, 0.9, 0.05}, {0.03, 0.0, 1.05}}};
}

template <int D>
TotalLagrangianOptions method(DeformationGradient form, MomentumForm momentum, const AnyCorrection& correction) {
  TotalLagrangianOptions o = options<D>(rubber, 1, CubicSpline{}, correction);
  o.hourglass.reset();
  o.deformation_gradient = form;
  o.momentum = momentum;
  return o;
}

template <int D>
Cloud<D> wavy_cloud(unsigned seed) {
  Cloud<D> cloud = make_cloud<D>(D == 3 ? 4 : 8, 0.3, 2.4, false, 1, seed);
  displace<D>(cloud.particles, shear<D>(), 0.05);
  return cloud;
}

/// Largest difference between fast and slow forces over the largest force.
template <int D>
double difference(const TotalLagrangianOptions& o) {
  Cloud<D> cloud = wavy_cloud<D>(5);
  TotalLagrangian<D> solid(cloud.particles, cloud.radius, o);
  VectorField<D> forces(cloud.particles.slots);
  solid.internal_forces(cloud.particles, forces);
  reference::BondMethod<D> slow;
  slow.W = [](double r, double R) { return CubicSpline::value<D>(r, R); };
  slow.slope = [](double r, double R) { return CubicSpline::slope<D>(r, R); };
  slow.stress = [](const Mat<double, D>& F) { return in_plane<D>(virgin_response(rubber, embed(F, 1.0)).P); };
  slow.linear = std::holds_alternative<LinearCorrection>(o.correction);
  slow.bonds = o.averages();
  slow.variational = o.deformation_gradient == DeformationGradient::bond_variational;
  slow.symmetric = o.momentum == MomentumForm::symmetric;
  for (int slot : cloud.particles.slot_of)
    slow.particles.push_back({cloud.particles.position[slot], cloud.particles.displacement[slot], cloud.particles.volume[slot],
                              cloud.radius[slot], 1.0});
  const auto expected = slow.forces();
  double worst = 0.0, largest = 0.0;
  for (int user = 0; user < cloud.particles.count; ++user) {
    worst = std::max(worst, norm(forces[cloud.particles.slot_of[user]] - expected[user]));
    largest = std::max(largest, norm(expected[user]));
  }
  return worst / largest;
}

TEST(Bonds, ForcesOfTheSlowReference) {
  using enum DeformationGradient;
  using enum MomentumForm;
  for (const AnyCorrection& correction : {AnyCorrection(LinearCorrection{}), AnyCorrection(GradientCorrection{})}) {
    EXPECT_LT(difference<2>(method<2>(direct, symmetric, correction)), 1e-11);
    EXPECT_LT(difference<2>(method<2>(bond, adjoint, correction)), 1e-11);
    EXPECT_LT(difference<2>(method<2>(bond, symmetric, correction)), 1e-11);
    EXPECT_LT(difference<2>(method<2>(bond_variational, adjoint, correction)), 1e-11);
    EXPECT_LT(difference<3>(method<3>(bond, symmetric, correction)), 1e-11);
    EXPECT_LT(difference<3>(method<3>(bond_variational, adjoint, correction)), 1e-11);
  }
}

TEST(Bonds, ForcesOfTheSlowReferenceInBlocks) {
  const BlockSize small(30);
  EXPECT_LT(difference<2>(method<2>(DeformationGradient::bond, MomentumForm::symmetric, LinearCorrection{})), 1e-11);
  EXPECT_LT(difference<3>(method<3>(DeformationGradient::bond_variational, MomentumForm::adjoint, LinearCorrection{})), 1e-11);
}

template <int D>
void check_patch(DeformationGradient form, const AnyCorrection& correction) {
  Cloud<D> cloud = make_cloud<D>(D == 3 ? 5 : 9, 0.4, 2.41, false, 1, 1);
  displace<D>(cloud.particles, shear<D>(), 0.0);
  TotalLagrangian<D> solid(cloud.particles, cloud.radius, method<D>(form, MomentumForm::adjoint, correction));
  solid.begin(cloud.particles);
  RecordedState state(cloud.particles.slots);
  solid.record(cloud.particles, state);
  for (int slot : cloud.particles.slot_of)
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) EXPECT_NEAR(state.deformation_gradient.at(3 * i + j, slot), shear<D>()[i][j], 1e-12);
}

/// The average over bonds is exact for affine maps with every kernel whose sum is one.
TEST(Bonds, PatchTest) {
  using enum DeformationGradient;
  for (const DeformationGradient form : {rate, bond, bond_variational})
    for (const AnyCorrection& correction :
         {AnyCorrection(GradientCorrection{}), AnyCorrection(MixedCorrection{}), AnyCorrection(LinearCorrection{})}) {
      check_patch<2>(form, correction);
      check_patch<3>(form, correction);
    }
}

struct Resultant {
  Point force, moment;
  double scale = 0.0;
};

template <int D>
Resultant resultant(const TotalLagrangianOptions& o) {
  const BlockSize small(40);
  Cloud<D> cloud = make_cloud<D>(D == 3 ? 5 : 9, 0.3, 2.41, false, 1, 3);
  displace<D>(cloud.particles, Mat<double, D>::identity(), 0.15);
  for (int slot : cloud.particles.slot_of) cloud.particles.velocity.set(slot, cloud.particles.displacement[slot]);
  TotalLagrangian<D> solid(cloud.particles, cloud.radius, o);
  VectorField<D> forces(cloud.particles.slots);
  solid.internal_forces(cloud.particles, forces);
  Resultant sum;
  for (int slot : cloud.particles.slot_of) {
    Point f;
    for (int c = 0; c < D; ++c) f[c] = forces[slot][c];
    sum.force += f;
    sum.moment += cross(cloud.particles.current(slot), f);
    sum.scale += norm(f);
  }
  return sum;
}

/// Linear momentum always; angular momentum with the force that is a gradient, and not with the symmetric one.
template <int D>
void check_momenta() {
  using enum DeformationGradient;
  using enum MomentumForm;
  const LinearCorrection linear;
  const Resultant symmetric_bonds = resultant<D>(method<D>(bond, symmetric, linear));
  EXPECT_LT(norm(symmetric_bonds.force), 1e-13 * symmetric_bonds.scale);
  EXPECT_GT(norm(symmetric_bonds.moment), 1e-4 * symmetric_bonds.scale);
  const Resultant variational = resultant<D>(method<D>(bond_variational, adjoint, linear));
  EXPECT_LT(norm(variational.force), 1e-13 * variational.scale);
  EXPECT_LT(norm(variational.moment), 1e-12 * variational.scale);
  TotalLagrangianOptions dissipating = method<D>(direct, symmetric, linear);
  dissipating.jst = JstDissipation{0.3, 0.1};
  const Resultant jst = resultant<D>(dissipating);
  EXPECT_LT(norm(jst.force), 1e-13 * jst.scale);
}

TEST(Bonds, Momenta) {
  check_momenta<2>();
  check_momenta<3>();
}

template <int D>
void check_energy_gradient(const AnyCorrection& correction) {
  Cloud<D> cloud = make_cloud<D>(D == 3 ? 3 : 6, 0.3, 2.2, false, 1, 4);
  displace<D>(cloud.particles, Mat<double, D>::identity(), 0.1);
  TotalLagrangianOptions o = method<D>(DeformationGradient::bond_variational, MomentumForm::adjoint, correction);
  if (std::holds_alternative<GradientCorrection>(correction)) o.hourglass = HourglassStiffness{};
  TotalLagrangian<D> solid(cloud.particles, cloud.radius, o);
  VectorField<D> forces(cloud.particles.slots), scratch(cloud.particles.slots);
  solid.internal_forces(cloud.particles, forces);
  const auto energy = [&] {
    const ForceSummary summary = solid.internal_forces(cloud.particles, scratch);
    return summary.strain_energy + summary.hourglass_energy;
  };
  double scale = 0.0;
  for (int slot : cloud.particles.slot_of) scale = std::max(scale, norm(forces[slot]));
  for (int user = 0; user < cloud.particles.count; user += 5)
    for (int c = 0; c < D; ++c) {
      double& u = cloud.particles.displacement.at(c, cloud.particles.slot_of[user]);
      const double kept = u, step = 1e-5;
      u = kept + step;
      const double after = energy();
      u = kept - step;
      const double before = energy();
      u = kept;
      EXPECT_NEAR(forces[cloud.particles.slot_of[user]][c], -(after - before) / (2.0 * step), 1e-7 * scale);
    }
}

/// With any correction; with the conservative hourglass stiffness too where it has a gradient.
TEST(Bonds, VariationalForceIsMinusTheGradientOfTheEnergy) {
  check_energy_gradient<2>(LinearCorrection{});
  check_energy_gradient<3>(LinearCorrection{});
  check_energy_gradient<2>(MixedCorrection{});
  check_energy_gradient<2>(GradientCorrection{});
  check_energy_gradient<3>(GradientCorrection{});
}

}  // namespace
}  // namespace sinew
