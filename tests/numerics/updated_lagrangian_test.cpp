/// SPH on the current configuration: against the plain reference, and its conservation laws.

#include <gtest/gtest.h>

#include "../reference/ulsph_minimal.hpp"
#include "clouds.hpp"

namespace sinew {
namespace {

using namespace sinew::testing;

constexpr double support = 2.3;

template <int D>
struct UpdatedCloud {
  std::vector<PointSet> bodies;
  Particles<D> particles;
  UpdatedLagrangian<D> solid;
  VectorField<D> forces;

  UpdatedCloud(Cloud<D> cloud, const UpdatedLagrangianOptions& options)
      : bodies(std::move(cloud.bodies)),
        particles(std::move(cloud.particles)),
        solid(particles, make_block_pairs(particles, build_pair_list(particles, cloud.radius), cloud.radius, false), options,
              Comm(), Halo()),
        forces(particles.slots) {}

  ForceSummary evaluate(double dt) {
    forces.clear();
    return solid.internal_forces(particles, forces, {dt, HistoryUse::advance}, [](int, int) {});
  }
};

UpdatedLagrangianOptions basic_options() {
  UpdatedLagrangianOptions options{.kernel = CubicSpline{}, .materials = {}};
  NeoHookean rubber;
  rubber.density = 1.3;
  rubber.elastic = {};
  rubber.elastic.youngs_modulus = 7.0;
  rubber.elastic.poissons_ratio = 0.3;
  rubber.elastic.complete();
  options.materials = {rubber, rubber};
  options.radius = support;
  options.spacing = 1.0;
  return options;
}

/// Disturbed displacements and velocities.
template <int D>
void disturb(Particles<D>& particles, double size, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> part(-size, size);
  for (int slot = 0; slot < particles.slots; ++slot)
    for (int c = 0; c < D; ++c) {
      if (particles.user_index[slot] < 0) continue;
      const Point X = particles.reference(slot);
      particles.displacement.at(c, slot) = 0.1 * X[(c + 1) % D] + part(random);
      particles.velocity.at(c, slot) = 0.3 * X[c] - 0.2 * X[(c + 1) % D] + part(random);
    }
}

template <int D>
PlainUpdatedLagrangian<D> plain_of(const UpdatedCloud<D>& cloud, const UpdatedLagrangianOptions& options, MatrixField<D>& F) {
  PlainUpdatedLagrangian<D> plain{options, {}};
  for (int number = 0; number < cloud.particles.count; ++number) {
    const int slot = cloud.particles.slot_of[number];
    PlainParticle<D> p{};
    p.x = cloud.particles.position[slot] + cloud.particles.displacement[slot];
    p.v = cloud.particles.velocity[slot];
    p.mass = cloud.particles.mass[slot];
    p.density = 1.3;
    p.F = Mat<double, D>::identity();
    for (int c = 0; c < D * D; ++c) p.F[c / D][c % D] += F.at(c, slot);
    p.J = determinant(p.F);
    plain.particles.push_back(p);
  }
  return plain;
}

/// Two steps, so that what is held from one to the next counts.
template <int D>
void compare_with_plain(const UpdatedLagrangianOptions& options) {
  const BlockSize small(24);
  UpdatedCloud<D> cloud(make_cloud<D>(D == 3 ? 4 : 6, 0.2, support, false, 1, 3), options);
  disturb(cloud.particles, 0.05, 5);
  cloud.solid.begin(cloud.particles);
  PlainUpdatedLagrangian<D> plain = plain_of(cloud, options, *cloud.solid.fields_to_save().matrices[0].field);
  double error = 0.0, size = 0.0;
  for (const double dt : {0.01, 0.02}) {
    cloud.evaluate(dt);
    plain.evaluate(dt);
    for (int number = 0; number < cloud.particles.count; ++number) {
      const Vec<double, D> force = cloud.forces[cloud.particles.slot_of[number]];
      error = std::max(error, norm(force - plain.particles[number].force));
      size = std::max(size, norm(force));
    }
  }
  EXPECT_GT(size, 1e-3);
  EXPECT_LT(error, 1e-11 * size);
}

template <int D>
void compare_all_with_plain() {
  for (const bool corrected : {false, true}) {
    UpdatedLagrangianOptions options = basic_options();
    options.corrected = corrected;
    compare_with_plain<D>(options);
    options.viscosity = ArtificialViscosity{1.5, 0.7};
    options.stress = ArtificialStress{};
    compare_with_plain<D>(options);
    options.stress.reset();
    options.pressure = ArtificialPressure{};
    options.shear = NonNestedShear{};
    compare_with_plain<D>(options);
    options.shear->form.value = "printed";
    compare_with_plain<D>(options);
  }
}
TEST(UpdatedLagrangian, IsThePlainReferenceIn2D) { compare_all_with_plain<2>(); }
TEST(UpdatedLagrangian, IsThePlainReferenceIn3D) { compare_all_with_plain<3>(); }

/// L of a linear field of velocities is exact with the correction, on any arrangement.
template <int D>
void check_linear_velocities() {
  UpdatedLagrangianOptions options = basic_options();
  options.corrected = true;
  UpdatedCloud<D> cloud(make_cloud<D>(5, 0.2, support, false, 1, 3), options);
  Mat<double, D> A;
  for (int c = 0; c < D * D; ++c) A[c / D][c % D] = 0.3 * std::sin(2.0 + 3.0 * c);
  for (int slot = 0; slot < cloud.particles.slots; ++slot) cloud.particles.velocity.set(slot, A * cloud.particles.position[slot]);
  cloud.evaluate(0.0);
  for (int slot = 0; slot < cloud.particles.slots; ++slot)
    for (int c = 0; c < D * D && cloud.particles.user_index[slot] >= 0; ++c)
      EXPECT_NEAR(cloud.solid.velocity_gradient().at(c, slot), A[c / D][c % D], 1e-12);
}
TEST(UpdatedLagrangian, LinearVelocitiesAreExactWithTheCorrection) {
  check_linear_velocities<2>();
  check_linear_velocities<3>();
}

template <int D>
struct Balance {
  Vec<double, D> force;
  Vec3<double> moment;
  double power = 0.0, size = 0.0;

  explicit Balance(const UpdatedCloud<D>& cloud) {
    for (int slot = 0; slot < cloud.particles.slots; ++slot) {
      if (cloud.particles.user_index[slot] < 0) continue;
      const Vec<double, D> f = cloud.forces[slot];
      force += f;
      Point f3{};
      for (int c = 0; c < D; ++c) f3[c] = f[c];
      moment += cross(cloud.particles.current(slot), f3);
      power += dot(f, cloud.particles.velocity[slot]);
      size += norm(f);
    }
  }
};

/// Momentum: any options. Angular momentum: with the correction, where T M is sigma.
template <int D>
void check_momenta() {
  for (const bool corrected : {false, true}) {
    UpdatedLagrangianOptions options = basic_options();
    options.corrected = corrected;
    options.viscosity = ArtificialViscosity{};
    UpdatedCloud<D> cloud(make_cloud<D>(5, 0.2, support, false, 2, 3), options);
    disturb(cloud.particles, 0.05, 8);
    cloud.solid.begin(cloud.particles);
    cloud.evaluate(0.0);
    const Balance<D> balance(cloud);
    EXPECT_LT(norm(balance.force), 1e-13 * balance.size);
    if (corrected) {
      EXPECT_LT(norm(balance.moment), 1e-10 * balance.size);
    }
  }
}
TEST(UpdatedLagrangian, ConservesMomenta) {
  check_momenta<2>();
  check_momenta<3>();
}

/// The power of the forces is that of the stresses: minus the rate of the strain energy, here by a central difference of the latter along the motion.
template <int D>
void check_power() {
  for (const bool corrected : {false, true}) {
    UpdatedLagrangianOptions options = basic_options();
    options.corrected = corrected;
    const auto energy_after = [&](double dt) {
      UpdatedCloud<D> cloud(make_cloud<D>(4, 0.2, support, false, 1, 3), options);
      disturb(cloud.particles, 0.05, 8);
      cloud.solid.begin(cloud.particles);
      for (int slot = 0; slot < cloud.particles.slots; ++slot)
        for (int c = 0; c < D; ++c) cloud.particles.displacement.at(c, slot) += dt * cloud.particles.velocity.at(c, slot);
      return cloud.evaluate(dt).strain_energy;
    };
    UpdatedCloud<D> cloud(make_cloud<D>(4, 0.2, support, false, 1, 3), options);
    disturb(cloud.particles, 0.05, 8);
    cloud.solid.begin(cloud.particles);
    cloud.evaluate(0.0);
    constexpr double dt = 1e-4;
    const double rate = (energy_after(dt) - energy_after(-dt)) / (2.0 * dt);
    EXPECT_NEAR(Balance<D>(cloud).power, -rate, 1e-6 * std::abs(rate));
  }
}
TEST(UpdatedLagrangian, PowerOfForcesIsThatOfStresses) {
  check_power<2>();
  check_power<3>();
}

}  // namespace
}  // namespace sinew
