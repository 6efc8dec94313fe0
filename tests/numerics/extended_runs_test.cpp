/// Runs with the extended methods: gradients integrated in time, averages over bonds, JST dissipation, projection of angular momentum.

#include <gtest/gtest.h>

#include <cmath>

#include "clouds.hpp"
#include "run_case.hpp"

namespace sinew {
namespace {

using namespace sinew::testing;

std::string method(const std::string& formulation, const std::string& solver = "", int dimension = 2) {
  return free_block(dimension, solver + "\n[formulation]\nkernel = \"cubic_spline\"\nsupport = 2.4\n" + formulation + "\n");
}

/// Largest difference of positions after some steps.
double difference(const std::string& a, const std::string& b, int steps) {
  const auto one = simulation_of(a), other = simulation_of(b);
  run_steps(*one, steps);
  run_steps(*other, steps);
  const Snapshot x = one->snapshot({}), y = other->snapshot({});
  double worst = 0.0;
  for (std::size_t k = 0; k < x.position.size(); ++k) worst = std::max(worst, norm(x.position[k] - y.position[k]));
  return worst;
}

/// Positions and gradients that are advanced alike stay consistent.
TEST(RateGradient, IsThatOfTheDisplacements) {
  for (int dimension : {2, 3})
    for (const std::string integrator : {"velocity_verlet", "rk3"}) {
      const std::string solver = "integrator = \"" + integrator + "\"\n[[boundary]]\nregion = { where = \"X < 0.2\" }\n" +
                                 (dimension == 2 ? "velocity = [\"sin(9*t)\", 0]" : "velocity = [\"sin(9*t)\", 0, 0]");
      const std::string common = "correction = \"linear\"\nmomentum = \"symmetric\"\nstabilization = []\ndeformation_gradient = ";
      const std::string rate = method(common + "\"rate\"", solver, dimension),
                        direct = method(common + "\"direct\"", solver, dimension);
      EXPECT_LT(difference(rate, direct, 100), 1e-11) << integrator << " in " << dimension << "D";
    }
}

/// What it takes is in the balance; that closes by the error of the time integration.
TEST(Jst, EnergyIsCounted) {
  for (const std::string integrator : {"velocity_verlet", "rk3"}) {
    const auto simulation = simulation_of(method("stabilization = [{ model = \"jst\", eta2 = 0.02, eta4 = 0.02 }]",
                                                 "time_step = 2e-4\nintegrator = \"" + integrator + "\""));
    run_until(*simulation, 0.2);
    const Energies e = simulation->energies();
    EXPECT_GT(e.dissipated, 0.01 * e.initial);
    EXPECT_LT(std::abs(e.balance_error()), 2e-3 * e.dissipated) << integrator;
  }
}

/// A large coefficient shortens the step instead of blowing up.
TEST(Jst, LimitsTheTimeStep) {
  for (const std::string integrator : {"velocity_verlet", "rk3"}) {
    const auto simulation = simulation_of(method("stabilization = [{ model = \"jst\", eta2 = 2.0, eta4 = 0.5 }]",
                                                 "cfl = 0.9\nintegrator = \"" + integrator + "\""));
    EXPECT_EQ(simulation->facts().time_step_limit, "JST dissipation");
    run_steps(*simulation, 300);
    EXPECT_LT(simulation->energies().total(), simulation->energies().initial);
  }
}

/// Energy and both momenta, over many steps.
TEST(BondVariational, ConservesEnergyAndMomenta) {
  for (int dimension : {2, 3}) {
    const auto simulation = simulation_of(method(
        "correction = \"linear\"\ndeformation_gradient = \"bond_variational\"\nstabilization = []", "cfl = 0.2", dimension));
    const Momenta before = simulation->momenta();
    run_until(*simulation, 0.2);
    EXPECT_LT(norm(simulation->momenta().linear - before.linear), 1e-12 * before.linear_scale);
    EXPECT_LT(norm(simulation->momenta().angular - before.angular), 1e-11 * norm(before.angular));
    EXPECT_LT(std::abs(simulation->energies().balance_error()), 1e-4 * simulation->energies().initial);
    EXPECT_GT(simulation->energies().strain, 0.005 * simulation->energies().initial);
  }
}

/// Symmetric momentum loses angular momentum, and the projection gives it back: exactly with Verlet, by the error of the integration with stages.
TEST(Projection, ConservesAngularMomentum) {
  const auto drift = [](int dimension, const std::string& integrator, const std::string& more) {
    const auto simulation = simulation_of(
        method("correction = \"linear\"\ndeformation_gradient = \"bond\"\nstabilization = [{ model = \"jst\" }]\n" + more,
               "integrator = \"" + integrator + "\"", dimension));
    const Momenta before = simulation->momenta();
    run_until(*simulation, 0.1);
    EXPECT_LT(norm(simulation->momenta().linear - before.linear), 1e-12 * before.linear_scale);
    return norm(simulation->momenta().angular - before.angular) / norm(before.angular);
  };
  for (int dimension : {2, 3}) {
    const std::string project = "project_angular_momentum = true";
    EXPECT_GT(drift(dimension, "velocity_verlet", ""), 1e-5);
    EXPECT_LT(drift(dimension, "velocity_verlet", project), 1e-12);
    EXPECT_LT(drift(dimension, "rk3", project), 1e-2 * drift(dimension, "rk3", ""));
  }
}

/// Loads keep their moment: only that of the internal forces goes.
TEST(Projection, LeavesLoadsAlone) {
  const std::string push = "[[boundary]]\nregion = { where = \"X > 1.7\" }\nforce = [0, 2]\n";
  const auto simulation = simulation_of(method("project_angular_momentum = true", push));
  const Point before = simulation->momenta().angular;
  run_until(*simulation, 0.05);
  EXPECT_NEAR(simulation->momenta().angular[2] - before[2], 2.0 * 0.05 * 1.85, 0.02);
}

class ExtendedMethods : public ::testing::TestWithParam<std::string> {};

TEST_P(ExtendedMethods, RestartGivesTheSameBits) {
  for (int dimension : {2, 3})
    for (const std::string integrator : {"velocity_verlet", "rk3"}) {
      const std::string text = method(GetParam(), "integrator = \"" + integrator + "\"", dimension);
      const auto whole = simulation_of(text), first = simulation_of(text);
      run_steps(*whole, 25);
      run_steps(*first, 12);
      const auto second = simulation_of(text);
      second->restore(first->save());
      run_steps(*second, 13);
      EXPECT_EQ(second->state_hash(), whole->state_hash());
      EXPECT_EQ(second->energies().dissipated, whole->energies().dissipated);
    }
}

/// What is asked for in between does not change the run.
TEST_P(ExtendedMethods, ProbesAndPicturesChangeNothing) {
  const std::string text = method(GetParam(), "integrator = \"rk3\"");
  const std::string probe = "[[probe]]\nname = \"s\"\nquantity = \"von_mises_stress\"\nreduce = \"max\"\n";
  const auto plain = simulation_of(text), watched = simulation_of(text + probe);
  for (int k = 0; k < 10; ++k) {
    plain->step(1e300);
    watched->step(1e300);
    EXPECT_GT(watched->probe_values()[0], 0.0);
    watched->snapshot({"deformation_gradient"});
  }
  EXPECT_EQ(plain->state_hash(), watched->state_hash());
}

INSTANTIATE_TEST_SUITE_P(
    All, ExtendedMethods,
    ::testing::Values(
        "deformation_gradient = \"rate\"\ncorrection = \"linear\"\nstabilization = [{ model = \"jst\" }]",
        "deformation_gradient = \"bond\"\ncorrection = \"linear\"\nstabilization = [{ model = \"jst\", eta2 = 0.01 }]",
        "deformation_gradient = \"bond_variational\"\nstabilization = [{ model = \"hourglass_stiffness\" }, { model = "
        "\"artificial_viscosity\" }]",
        "momentum = \"symmetric\"\ncorrection = \"mixed\"\nstabilization = [{ model = \"jst\" }]\n"
        "project_angular_momentum = true"));

}  // namespace
}  // namespace sinew
