/// Materials with history in whole bodies: each particle follows the material alone, energies balance, restarts and layouts change nothing.

#include <gtest/gtest.h>

#include "clouds.hpp"
#include "run_case.hpp"

namespace sinew {
namespace {

using namespace sinew::testing;

using Metal = J2<VoceHardening>;

Metal metal() {
  Metal m = material_with<Metal>(1.0, 2.0, 0.3);
  m.hardening = {0.01, 0.02, 5.0, 0.01};
  return m;
}

/// The homogeneous path: shear and stretch at once.
template <int D>
Mat<double, D> path(int step) {
  Mat<double, D> A = Mat<double, D>::identity();
  A[0][0] += 0.004 * step, A[0][1] += 0.01 * step, A[1][1] -= 0.003 * step;
  return A;
}

/// All particles of a cloud, with ghosts, padding and patterns of a lattice, go through what a single point goes through.
template <int D>
void check_path(double jitter) {
  const BlockSize small(100);
  Cloud<D> cloud = make_cloud<D>(D == 3 ? 6 : 13, jitter, 2.41, true, 1, 4);
  TotalLagrangian<D> solid(cloud.particles, cloud.radius, options<D>(metal()));
  VectorField<D> forces(cloud.particles.slots);
  PlasticHistory<Mat3<double>> history;
  RecordedState recorded(cloud.particles.slots);
  recorded.inelastic = VectorField<4>(cloud.particles.slots);
  for (int step = 1; step <= 12; ++step) {
    displace<D>(cloud.particles, path<D>(step), 0.0);
    const Response<Mat3<double>> expected = metal().respond(embed(path<D>(step), 1.0), history, 0.0);
    solid.internal_forces(
        cloud.particles, forces, {0.0, HistoryUse::advance}, [](int, int) {}, &recorded);
    if (step % 4 == 0) solid.record(cloud.particles, recorded);  // changes nothing
    double worst = 0.0, strain = 0.0;
    for (int slot : cloud.particles.slot_of) {
      for (int c = 0; c < 9; ++c) worst = std::max(worst, std::abs(recorded.stress.at(c, slot) - expected.P[c / 3][c % 3]));
      strain = std::max(strain, std::abs(recorded.inelastic.at(0, slot) - history.strain));
      EXPECT_NEAR(recorded.inelastic.at(1, slot), history.work, 1e-13);
    }
    EXPECT_LT(worst, 1e-12);
    EXPECT_LT(strain, 1e-12);
  }
  EXPECT_GT(history.strain, 0.05);
}

TEST(Plasticity, ParticlesFollowTheMaterial) {
  for (const double jitter : {0.0, 0.2}) {
    check_path<2>(jitter);
    check_path<3>(jitter);
  }
}

/// A free block of metal that tumbles and flows.
std::string metal_block(int dimension, const std::string& more = "", const std::string& model = "j2_voce") {
  std::string text = free_block(dimension, more);
  const std::string rubber = "model = \"neo_hookean\"\nyoungs_modulus = 1000.0";
  const std::string voce = "\nsaturation_stress = 5.0\nsaturation_rate = 10.0";
  text.replace(text.find(rubber), rubber.size(),
               "model = \"" + model + "\"\nyoungs_modulus = 1000.0\nyield_stress = 3.0" + (model == "j2_voce" ? voce : ""));
  return text;
}

double balance_error(double dt, const std::string& stabilization) {
  const auto simulation = simulation_of(metal_block(2, "time_step = " + std::to_string(dt) + "\n") +
                                        "[formulation]\nstabilization = " + stabilization + "\n");
  double worst = 0.0;
  while (simulation->time() < 0.2) {
    simulation->step(1e300);
    worst = std::max(worst, std::abs(simulation->energies().balance_error()));
  }
  EXPECT_GT(simulation->energies().plastic_work, 0.015 * simulation->energies().initial);
  return worst / simulation->energies().initial;
}

/// What the flow and the softened hourglass stiffness take is counted.
TEST(Plasticity, EnergyBalances) {
  for (const std::string stabilization : {"[]", "[{ model = \"hourglass_stiffness\" }]"}) {
    EXPECT_LT(balance_error(4e-4, stabilization), 3e-3) << stabilization;
    EXPECT_LT(balance_error(1e-4, stabilization), 0.4 * balance_error(4e-4, stabilization)) << stabilization;
  }
}

TEST(Plasticity, MomentumStaysToRounding) {
  for (int dimension : {2, 3}) {
    const auto simulation = simulation_of(metal_block(dimension));
    const Momenta before = simulation->momenta();
    run_steps(*simulation, 200);
    const Momenta after = simulation->momenta();
    EXPECT_LT(norm(after.linear - before.linear), 1e-12 * before.linear_scale);
    EXPECT_LT(norm(after.angular - before.angular), 1e-11 * before.linear_scale);
  }
}

TEST(Plasticity, RestartGivesTheSameBits) {
  for (int dimension : {2, 3}) {
    const auto whole = simulation_of(metal_block(dimension)), first = simulation_of(metal_block(dimension));
    run_steps(*whole, 150);
    run_steps(*first, 70);
    const auto second = simulation_of(metal_block(dimension));
    second->restore(first->save());
    EXPECT_EQ(second->energies().plastic_work, first->energies().plastic_work);
    run_steps(*second, 80);
    EXPECT_EQ(second->state_hash(), whole->state_hash());
    EXPECT_GT(whole->energies().plastic_work, 0.0);
    EXPECT_EQ(second->energies().plastic_work, whole->energies().plastic_work);
  }
}

/// Looking at a state (files, probes) does not change what comes.
TEST(Plasticity, LookingChangesNothing) {
  const auto quiet = simulation_of(metal_block(2)), watched = simulation_of(metal_block(2));
  for (int step = 0; step < 60; ++step) {
    quiet->step(1e300);
    if (step % 3 == 0) watched->expect_record();
    watched->step(1e300);
    if (step % 2 == 0) watched->snapshot({"plastic_strain", "von_mises_stress", "temperature"});
  }
  EXPECT_EQ(quiet->state_hash(), watched->state_hash());
}

/// In a very hard metal nothing flows: Hencky's elasticity, near Hooke's at small strain, in which energy stays.
TEST(Plasticity, HardMetalIsElastic) {
  std::string text = metal_block(2, "", "j2_plastic");
  text.replace(text.find("yield_stress = 3.0"), 18, "yield_stress = 1e6");
  const auto simulation = simulation_of(text);
  run_steps(*simulation, 300);
  EXPECT_EQ(simulation->energies().plastic_work, 0.0);
  EXPECT_LT(std::abs(simulation->energies().balance_error()), 2e-3 * simulation->energies().initial);
}

/// Forces of a cloud in its second step, in the first of which all of it has flowed.
std::vector<Vec<double, 2>> second_forces(double alpha, bool plastic_switch) {
  Cloud<2> cloud = make_cloud<2>(12, 0.2, 2.41, true, 1, 4);
  TotalLagrangianOptions o = options<2>(metal());
  o.hourglass->alpha = alpha, o.hourglass->plastic_switch = plastic_switch;
  TotalLagrangian<2> solid(cloud.particles, cloud.radius, o);
  VectorField<2> forces(cloud.particles.slots);
  displace<2>(cloud.particles, path<2>(30), 0.02);
  solid.internal_forces(cloud.particles, forces);
  forces.clear();
  solid.internal_forces(cloud.particles, forces);
  std::vector<Vec<double, 2>> all;
  for (int slot : cloud.particles.slot_of) all.push_back(forces[slot]);
  return all;
}

/// The yield stress, E / 200, takes the place of Young's modulus.
TEST(Plasticity, SwitchTakesTheYieldStressForTheModulus) {
  const auto with_switch = second_forces(50.0, true), expected = second_forces(50.0 / 200.0, false),
             stiff = second_forces(50.0, false);
  double worst = 0.0, far = 0.0;
  for (std::size_t i = 0; i < with_switch.size(); ++i) {
    worst = std::max(worst, norm(with_switch[i] - expected[i]));
    far = std::max(far, norm(with_switch[i] - stiff[i]));
  }
  EXPECT_LT(worst, 1e-13);
  EXPECT_GT(far, 1e-3);
}

}  // namespace
}  // namespace sinew
