/// Whole runs on the current configuration.

#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>

#include "clouds.hpp"
#include "run_case.hpp"

namespace sinew {
namespace {

using namespace sinew::testing;

std::string formulation(const std::string& more) { return "[formulation]\nmodel = \"updated_lagrangian\"\n" + more; }

const std::string with_all_of_it =
    "stabilization = [{ model = \"non_nested_shear\" }, { model = \"artificial_viscosity\", alpha = 0.3 }, { model = "
    "\"artificial_stress\" }]\n";

/// Blocks that rotate and fly through each other's neighborhood, with lists that change.
std::string mixing_blocks(int dimension) {
  const bool space = dimension == 3;
  const std::string box = space ? "[1, 0.6, 0.6], spacing = 0.1, jitter = 0.2 }\n" : "[1, 0.6], spacing = 0.05, jitter = 0.2 }\n";
  const std::string low = space ? "[0, 0, 0]" : "[0, 0]",
                    high = space ? "[1.05, 0.3, 0], high = [2.05, 0.9, 0.6]" : "[1.05, 0.3], high = [2.05, 0.9]";
  const std::string rest = space ? ", spacing = 0.1, jitter = 0.2 }\n" : ", spacing = 0.05, jitter = 0.2 }\n";
  return std::string("[case]\ndimension = ") + (space ? "3" : "2") +
         "\n[[body]]\nname = \"a\"\nmaterial = \"rubber\"\ngeometry = { shape = \"box\", low = " + low + ", high = " + box +
         "[[body]]\nname = \"b\"\nmaterial = \"rubber\"\ngeometry = { shape = \"box\", low = " + high + rest +
         "[material.rubber]\nmodel = \"neo_hookean\"\nyoungs_modulus = 1000.0\npoissons_ratio = 0.4\ndensity = 1.0\n" +
         "[[initial]]\nregion = \"b\"\nvelocity = " + (space ? "[-8, 3, 1]" : "[-8, 3]") + "\n[solver]\nend_time = 1.0\n";
}

std::string hash_with(const std::string& text, int threads, int steps) {
  const int fewest = fewest_for_threads;
  fewest_for_threads = 0;
  omp_set_num_threads(threads);
  const auto simulation = simulation_of(text);
  run_steps(*simulation, steps);
  fewest_for_threads = fewest;
  return simulation->state_hash();
}

TEST(UpdatedRuns, SameBitsOnAnyNumberOfThreads) {
  const BlockSize small(60);
  for (const int dimension : {2, 3}) {
    const std::string text = mixing_blocks(dimension) + formulation(with_all_of_it);
    const std::string one = hash_with(text, 1, 60);
    for (const int threads : {2, 3, 7})
      EXPECT_EQ(hash_with(text, threads, 60), one) << dimension << "D, " << threads << " threads";
  }
}

/// How blocks cut the bodies does not matter for the motion, since forces are sums over neighbors in an order of their own.
TEST(UpdatedRuns, BlocksDoNotMatter) {
  const std::string text = mixing_blocks(2) + formulation(with_all_of_it);
  const std::string whole = hash_with(text, 1, 60);
  const BlockSize small(60);
  EXPECT_EQ(hash_with(text, 1, 60), whole);
}

TEST(UpdatedRuns, RestartHasTheSameBits) {
  for (const int dimension : {2, 3}) {
    const std::string text = mixing_blocks(dimension) + formulation(with_all_of_it);
    const auto whole = simulation_of(text), resumed = simulation_of(text);
    run_steps(*whole, 37);
    const SavedState state = whole->save();
    run_steps(*whole, 40);
    resumed->restore(state);
    run_steps(*resumed, 40);
    EXPECT_EQ(resumed->state_hash(), whole->state_hash());
    EXPECT_EQ(resumed->energies().total(), whole->energies().total());
    EXPECT_EQ(resumed->energies().dissipated, whole->energies().dissipated);
  }
}

/// Energy of a free block that deforms: the error of the leapfrog, of second order.
double drift_of(double time_step) {
  const auto simulation = simulation_of(free_block(2, "time_step = " + std::to_string(time_step) + "\n") +
                                        formulation("support = 2.4\nkernel = \"cubic_spline\"\n"));
  double most = 0.0;
  while (simulation->time() < 0.02) {
    simulation->step(1e300);
    const Energies e = simulation->energies();
    most = std::max(most, std::abs(e.balance_error()) / e.initial);
  }
  return most;
}
TEST(UpdatedRuns, EnergyIsConservedToSecondOrder) {
  const double coarse = drift_of(2e-4), fine = drift_of(1e-4);
  EXPECT_LT(coarse, 1e-3);
  EXPECT_NEAR(coarse / fine, 4.0, 0.7);
}

/// A body that rotates as a whole has no stress, whatever the angle.
TEST(UpdatedRuns, RotationMakesNoStress) {
  const std::string text =
      "[case]\ndimension = 2\n[[body]]\nname = \"disk\"\nmaterial = { model = \"neo_hookean\", youngs_modulus = 1e3, "
      "poissons_ratio = 0.3, density = 1.0 }\n"
      "geometry = { shape = \"box\", low = [-0.5, -0.5], high = [0.5, 0.5], spacing = 0.1 }\n[[boundary]]\nregion = \"disk\"\n"
      "displacement = [\"X*cos(t)-Y*sin(t)-X\", \"X*sin(t)+Y*cos(t)-Y\"]\n[solver]\nend_time = 3.0\ntime_step = 0.01\n"
      "[[probe]]\nname = \"stress\"\nquantity = \"von_mises_stress\"\nreduce = \"max\"\n";
  const auto simulation = simulation_of(text + formulation("correction = \"gradient\"\n"));
  run_until(*simulation, 3.0);
  EXPECT_LT(simulation->probe_values()[0], 1e-8);
}

/// In the reference configuration the non-nested shear force is the conservative hourglass stiffness with alpha = 32 1.07 D G / E.
TEST(NonNestedShear, IsAStiffnessInTheReferenceConfiguration) {
  const double alpha = 32.0 * 1.07 * 2.0 / (2.0 * (1.0 + 0.4));
  const auto shear = simulation_of(free_block(2) + "[formulation]\nstabilization = [{ model = \"non_nested_shear\" }]\n");
  const auto stiffness = simulation_of(
      free_block(2) + "[formulation]\nstabilization = [{ model = \"hourglass_stiffness\", alpha = " + std::to_string(alpha) +
      " }]\n");
  run_until(*shear, 0.02);
  run_until(*stiffness, 0.02);
  EXPECT_GT(shear->energies().hourglass, 1e-4);
  EXPECT_NEAR(shear->energies().hourglass, stiffness->energies().hourglass, 1e-5 * stiffness->energies().hourglass);
  EXPECT_NEAR(shear->energies().strain, stiffness->energies().strain, 1e-6 * stiffness->energies().strain);
}

}  // namespace
}  // namespace sinew
