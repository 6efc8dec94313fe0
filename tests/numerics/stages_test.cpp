/// Runs in stages.

#include <gtest/gtest.h>

#include <cmath>

#include "clouds.hpp"
#include "run_case.hpp"

namespace sinew {
namespace {

using namespace sinew::testing;

std::string without_solver(std::string text) { return text.replace(text.find("[solver]"), text.size(), ""); }

const std::string two_stages = "[[stage]]\nname = \"first\"\nduration = 0.02\n[[stage]]\nname = \"second\"\nduration = 0.03\n";

/// Stages that change nothing leave no trace.
TEST(Stages, AreNotSeenUnlessTheyChangeSomething) {
  for (const std::string formulation : {"total_lagrangian", "updated_lagrangian"}) {
    const std::string block = without_solver(free_block(2)) + "[formulation]\nmodel = \"" + formulation + "\"\n";
    const auto plain = simulation_of(block + "[solver]\nend_time = 0.05\ntime_step = 2.5e-4\n");
    const auto staged = simulation_of(block + "[solver]\ntime_step = 2.5e-4\n" + two_stages);
    EXPECT_EQ(staged->end_time(), 0.05);
    EXPECT_EQ(staged->stage(), "first");
    run_until(*plain, 0.05);
    run_until(*staged, 0.05);
    EXPECT_EQ(staged->stage(), "second");
    EXPECT_EQ(staged->steps(), plain->steps());
    EXPECT_NEAR(staged->energies().kinetic, plain->energies().kinetic, 1e-9 * plain->energies().kinetic);
    EXPECT_NEAR(staged->energies().strain, plain->energies().strain, 1e-9 * plain->energies().kinetic);
    EXPECT_NEAR(staged->energies().initial, plain->energies().initial, 1e-9 * plain->energies().initial);
  }
}

/// Damping, gravity, a held edge and a softer material come with the second stage; the books stay balanced.
TEST(Stages, ChangeWhatTheySay) {
  const auto simulation = simulation_of(
      without_solver(free_block(2)) + two_stages +
      "[stage.solver]\ndamping = 40.0\n[stage.body_force]\nacceleration = [0, -50.0]\n[stage.material.rubber]\nyoungs_modulus = "
      "500.0\n[[stage.boundary]]\nregion = { where = \"Y < 0.1\" }\nvelocity = [0, 0]\n[[probe]]\nname = \"held\"\nquantity = "
      "\"velocity\"\ncomponent = \"x\"\nreduce = \"max\"\nregion = { where = \"Y < 0.1\" }\n");
  while (simulation->stage() == "first") simulation->step(1e300);
  const Energies at_change = simulation->energies();
  EXPECT_NEAR(simulation->time(), 0.02, 1e-12);
  EXPECT_EQ(simulation->probe_values()[0], 0.0);
  EXPECT_LT(std::abs(at_change.balance_error()), 1e-3 * at_change.initial);
  run_until(*simulation, 0.05);
  const Energies energies = simulation->energies();
  EXPECT_GT(energies.dissipated - at_change.dissipated, 0.3 * at_change.kinetic);
  EXPECT_LT(std::abs(energies.balance_error()), 3e-3 * at_change.initial);
  EXPECT_EQ(simulation->end_time(), 0.05);
}

TEST(Stages, RestartHasTheSameBits) {
  for (const std::string formulation : {"total_lagrangian", "updated_lagrangian"}) {
    const std::string text = without_solver(free_block(2)) + "[formulation]\nmodel = \"" + formulation + "\"\n" + two_stages +
                             "[stage.solver]\ndamping = 40.0\n";
    for (const int before : {5, 60}) {
      const auto whole = simulation_of(text), resumed = simulation_of(text);
      run_steps(*whole, before);
      resumed->restore(whole->save());
      EXPECT_EQ(resumed->stage(), whole->stage());
      while (whole->time() < whole->end_time() - 1e-9) whole->step(1e300);
      while (resumed->time() < resumed->end_time() - 1e-9) resumed->step(1e300);
      EXPECT_EQ(resumed->state_hash(), whole->state_hash());
      EXPECT_EQ(resumed->energies().total(), whole->energies().total());
    }
  }
}

/// A layer of soil under its own weight, held at the bottom, smooth sides.
std::string layer(const std::string& formulation) {
  return "[case]\ndimension = 2\n[[body]]\nname = \"layer\"\nmaterial = \"soil\"\ngeometry = { shape = \"box\", low = [0, -0.3], "
         "high = "
         "[1, 2], spacing = 0.1 }\n[material.soil]\nmodel = \"drucker_prager\"\nyoungs_modulus = 3e7\npoissons_ratio = "
         "0.3\ndensity = "
         "1500.0\nfriction_angle = 30\ncohesion = 1e4\n[formulation]\n" +
         formulation +
         "[body_force]\nacceleration = [0, -10.0]\n[[boundary]]\nregion = { where = \"Y < 0\" }\ndisplacement = [0, "
         "0]\n[[boundary]]\n"
         "region = { where = \"Y > 0\" }\ndisplacement = [0, \"free\"]\n[[stage]]\nname = \"geostatic\"\nduration = "
         "3.0\n"
         "residual = 1e-4\nsettle = true\nsolver = { damping = 100.0 }\n[[stage]]\nname = \"rest\"\nduration = 0.2\nsolver = { "
         "damping = 100.0 }\n"
         "[[probe]]\nname = \"vertical\"\nquantity = \"cauchy_stress\"\ncomponent = \"yy\"\nregion = { nearest = [0.55, 0.45] }\n"
         "[[probe]]\nname = \"horizontal\"\nquantity = \"cauchy_stress\"\ncomponent = \"xx\"\nregion = { nearest = [0.55, 0.45] "
         "}\n"
         "[[probe]]\nname = \"moved\"\nquantity = \"displacement\"\ncomponent = \"magnitude\"\nreduce = \"max\"\n";
}

/// Equilibrium in closed form: sigma_yy = -rho g (depth), sigma_xx = nu / (1 - nu) sigma_yy. Then all particles go back, and the stresses hold them there, but for what the hourglass
/// stiffness has carried.
TEST(Stages, GeostaticStress) {
  for (const std::string formulation :
       {"kernel = \"wendland_c2\"\nsupport = 3.0\n", "reference_update = { threshold = 0.5 }\n"}) {
    const auto simulation = simulation_of(layer(formulation));
    while (simulation->stage() == "geostatic") simulation->step(1e300);
    EXPECT_LT(simulation->time(), 0.9);
    std::vector<double> values = simulation->probe_values();
    const double expected = -1500.0 * 10.0 * 1.55;
    EXPECT_NEAR(values[0], expected, 0.02 * std::abs(expected));
    EXPECT_NEAR(values[1], 0.3 / 0.7 * expected, 0.02 * std::abs(expected));
    EXPECT_EQ(values[2], 0.0);
    EXPECT_EQ(simulation->energies().kinetic, 0.0);
    run_until(*simulation, simulation->end_time());
    values = simulation->probe_values();
    EXPECT_NEAR(values[0], expected, 0.03 * std::abs(expected));
    EXPECT_LT(values[2], 1e-3);
  }
}

TEST(Stages, GeostaticStressOnTheCurrentConfiguration) {
  const auto simulation = simulation_of(layer("model = \"updated_lagrangian\"\ncorrection = \"gradient\"\n"));
  while (simulation->stage() == "geostatic") simulation->step(1e300);
  const double expected = -1500.0 * 10.0 * 1.55;
  EXPECT_NEAR(simulation->probe_values()[0], expected, 0.05 * std::abs(expected));
  EXPECT_EQ(simulation->probe_values()[2], 0.0);
  run_until(*simulation, simulation->end_time());
  EXPECT_NEAR(simulation->probe_values()[0], expected, 0.05 * std::abs(expected));
  EXPECT_LT(simulation->probe_values()[2], 4e-3);
}

}  // namespace
}  // namespace sinew
