/// The three-stage Runge-Kutta method in whole runs, and the limits of the time step.

#include <gtest/gtest.h>

#include <cmath>

#include "run_case.hpp"
#include <sinew/time/runge_kutta.hpp>

namespace sinew {
namespace {

using namespace sinew::testing;

std::string staged(const std::string& more, int dimension = 2) { return free_block(dimension, "integrator = \"rk3\"\n" + more); }

/// A free particle with a damped spring: the method is the polynomial of third order of exp(dt A), for any damping.
TEST(RungeKutta, IsTheTaylorPolynomialOfALinearSystem) {
  PointSet one;
  one.position = {Point{}};
  one.volume = {1.0};
  one.spacing = 1.0;
  Particles<2> particles = make_particles<2>({{"a", &one, 1.0, 1.0}}, 1.0);
  RungeKuttaStep<2> step(particles.slots);
  const double k = 7.0, c = 0.8, dt = 0.1, u = 0.3, v = -0.5;
  particles.displacement.at(0, 0) = u, particles.velocity.at(0, 0) = v;
  step.begin(particles);
  for (const RungeKutta3::Stage& stage : RungeKutta3::stage) {
    particles.acceleration.at(0, 0) = -k * particles.displacement.at(0, 0);
    step.advance(particles, stage, dt, c);
  }
  Vec<double, 2> term{{u, v}}, sum = term;
  const Mat<double, 2> A{{{0.0, 1.0}, {-k, -c}}};
  for (int n = 1; n <= 3; ++n) {
    term = (dt / n) * (A * term);
    sum += term;
  }
  EXPECT_NEAR(particles.displacement.at(0, 0), sum[0], 1e-15);
  EXPECT_NEAR(particles.velocity.at(0, 0), sum[1], 1e-15);
}

TEST(RungeKutta, IsOfThirdOrder) {
  const auto tip = [](double dt) {
    const auto simulation = simulation_of(staged("time_step = " + std::to_string(dt) + "\n[formulation]\nstabilization = []\n"));
    run_until(*simulation, 0.016);
    return simulation->snapshot({}).position.back();
  };
  const Point exact = tip(2.5e-5);
  EXPECT_NEAR(std::log2(norm(tip(4e-4) - exact) / norm(tip(2e-4) - exact)), 3.0, 0.2);
}

/// Energy falls by a little, momenta stay.
TEST(RungeKutta, ConservesMomentaAndLosesEnergyOnly) {
  for (int dimension : {2, 3}) {
    const auto simulation = simulation_of(staged("", dimension));
    const Momenta before = simulation->momenta();
    run_until(*simulation, 0.3);
    EXPECT_LT(norm(simulation->momenta().linear - before.linear), 1e-12 * before.linear_scale);
    EXPECT_LT(norm(simulation->momenta().angular - before.angular), 1e-6 * norm(before.angular));
    EXPECT_LT(simulation->energies().balance_error(), 0.0);
    EXPECT_GT(simulation->energies().balance_error(), -0.02 * simulation->energies().initial);
  }
}

/// Particles on which everything is prescribed are where the condition says, and the work of what holds them is in the balance.
TEST(RungeKutta, FollowsPrescribedMotion) {
  for (const std::string motion :
       {"displacement = [\"0.1*t^2\", \"0.02*sin(9*t)\"]", "velocity = [\"0.2*t\", \"0.18*cos(9*t)\"]"}) {
    std::string text =
        staged("[[boundary]]\nregion = { where = \"X < 0.3\" }\n" + motion +
               "\n[[probe]]\nname = \"ux\"\nquantity = \"displacement\"\nregion = { where = \"X < 0.3\" }\ncomponent = \"x\"\n"
               "[[probe]]\nname = \"uy\"\nquantity = \"displacement\"\nregion = { where = \"X < 0.3\" }\ncomponent = \"y\"\n");
    const std::string before = "[\"3*sin(2*y)\", \"-2*x\"]";
    text.replace(text.find(before), before.size(), "[0, 0.18]");
    const auto simulation = simulation_of(text);
    run_until(*simulation, 0.5);
    EXPECT_NEAR(simulation->probe_values()[0], 0.025, 1e-9);
    EXPECT_NEAR(simulation->probe_values()[1], 0.02 * std::sin(4.5), 1e-9);
    EXPECT_LT(std::abs(simulation->energies().balance_error()), 1e-4 * simulation->energies().external_work);
  }
}

/// What is prescribed begins with the velocity that follows from it: no energy comes from nowhere in the first step.
TEST(PrescribedMotion, BeginsWithItsVelocity) {
  for (const std::string motion : {"displacement = [\"0.02*sin(9*t)\", 0]", "velocity = [\"0.18*cos(9*t)\", 0]"})
    for (const std::string integrator : {"velocity_verlet", "rk3"}) {
      std::string text =
          free_block(2, "integrator = \"" + integrator + "\"\n[[boundary]]\nregion = { where = \"X < 0.3\" }\n" + motion + "\n");
      const std::string before = "[\"3*sin(2*y)\", \"-2*x\"]";
      text.replace(text.find(before), before.size(), "[0.18, 0]");
      const auto simulation = simulation_of(text);
      EXPECT_NEAR(simulation->momenta().linear[0], 0.18 * simulation->facts().bodies[0].mass, 1e-5);
      run_until(*simulation, 0.2);
      EXPECT_LT(std::abs(simulation->energies().balance_error()), 1e-4 * simulation->energies().initial);
    }
}

/// With flow, loads and damping; stages must not leave anything in histories.
TEST(RungeKutta, RestartGivesTheSameBits) {
  std::string text = staged("damping = 2.0\n[[boundary]]\nregion = { where = \"X > 1.7\" }\nforce = [\"3*cos(20*t)\", 0]\n");
  text.replace(text.find("model = \"neo_hookean\""), 21,
               "model = \"j2_voce\"\nyield_stress = 5.0\nsaturation_stress = 10.0\nsaturation_rate = 5.0");
  const auto whole = simulation_of(text), first = simulation_of(text);
  run_steps(*whole, 60);
  run_steps(*first, 25);
  const auto second = simulation_of(text);
  second->restore(first->save());
  run_steps(*second, 35);
  EXPECT_EQ(second->state_hash(), whole->state_hash());
  EXPECT_EQ(second->energies().plastic_work, whole->energies().plastic_work);
  EXPECT_GT(whole->energies().plastic_work, 0.0);
  EXPECT_EQ(second->energies().external_work, whole->energies().external_work);
}

/// Metal flows by the same path with both integrators, up to their errors.
TEST(RungeKutta, HistoriesFollowTheSteps) {
  const auto work = [](const std::string& integrator) {
    std::string text = free_block(2, "integrator = \"" + integrator + "\"\ntime_step = 1e-4\n");
    text.replace(text.find("model = \"neo_hookean\""), 21,
                 "model = \"j2_plastic\"\nyield_stress = 5.0\nhardening_modulus = 50.0");
    const auto simulation = simulation_of(text);
    run_until(*simulation, 0.05);
    EXPECT_LT(std::abs(simulation->energies().balance_error()), 5e-3 * simulation->energies().initial);
    return simulation->energies().plastic_work;
  };
  EXPECT_NEAR(work("rk3"), work("velocity_verlet"), 2e-3 * work("rk3"));
}

/// At rest and under a known stretch: dt = cfl dx / c, with c = sqrt(M / rho) over the smallest stretch and the current distance.
TEST(WaveSpeed, StretchAndReference) {
  for (int dimension : {2, 3}) {
    const bool space = dimension == 3;
    const auto step = [&](const std::string& speed, const std::string& stretch) {
      return simulation_of("[case]\ndimension = " + std::to_string(dimension) +
                           "\n[[body]]\nname = \"b\"\nmaterial = { model = \"neo_hookean\", youngs_modulus = 1000, "
                           "poissons_ratio = 0.25, density = 2 }\n"
                           "geometry = { shape = \"box\", low = " +
                           (space ? "[0, 0, 0], high = [1, 1, 1]" : "[0, 0], high = [1, 1]") +
                           ", spacing = 0.1 }\n[[initial]]\nregion = \"b\"\nstretch = " + stretch +
                           "\n[formulation]\nstabilization = []\n[solver]\nend_time = 1\ncfl = 0.9\nwave_speed = \"" + speed +
                           "\"\n")
          ->stable_time_step();
    };
    const std::string rest = space ? "[1, 1, 1]" : "[1, 1]", pulled = space ? "[2, 0.8, 0.9]" : "[2, 0.8]";
    const double at_rest = 0.9 * 0.1 / std::sqrt(1200.0 / 2.0);
    EXPECT_NEAR(step("reference", rest), at_rest, 1e-12);
    EXPECT_NEAR(step("reference", pulled), at_rest, 1e-12);
    EXPECT_NEAR(step("stretch", rest), at_rest, 1e-12);
    EXPECT_NEAR(step("stretch", pulled), at_rest * 0.8 * 0.8, 1e-12) << "smallest stretch, and nearest neighbor";
    EXPECT_NEAR(step("bound", rest), at_rest, 1e-6);
  }
}

TEST(RungeKutta, KnowsNoContact) {
  try {
    simulation_of(staged("[[wall]]\nname = \"w\"\ngeometry = { shape = \"plane\", point = [0, -1], normal = [0, 1] }\n"));
    FAIL();
  } catch (const CaseError& error) {
    EXPECT_NE(std::string(error.what()).find("integrator \"rk3\" knows no contact and no walls"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace sinew
