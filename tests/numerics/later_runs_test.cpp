/// Whole runs whose reference configuration is renewed.

#include <gtest/gtest.h>

#include <cmath>

#include "clouds.hpp"
#include "run_case.hpp"

namespace sinew {
namespace {

using namespace sinew::testing;

std::string flowing(int dimension, const std::string& material) {
  const bool space = dimension == 3;
  return std::string("[case]\ndimension = ") + (space ? "3" : "2") +
         "\n[[body]]\nname = \"block\"\nmaterial = \"stuff\"\ngeometry = { shape = \"box\", low = " +
         (space ? "[0, 0, 0], high = [1, 0.6, 0.6], spacing = 0.1" : "[0, 0], high = [2, 1], spacing = 0.1") +
         ", jitter = 0.2 }\n[material.stuff]\n" + material +
         "\nyoungs_modulus = 1000.0\npoissons_ratio = 0.3\ndensity = 1.0\n[formulation]\nreference_update = { threshold = 0.25 "
         "}\n"
         "[[initial]]\nregion = \"block\"\nvelocity = " +
         (space ? "[\"30*y\", \"-20*x\", \"9*x\"]" : "[\"30*y\", \"-9*x\"]") + "\n[solver]\nend_time = 1.0\n";
}

const std::string metal = "model = \"j2_plastic\"\nyield_stress = 30.0\nhardening_modulus = 10.0",
                  soil = "model = \"drucker_prager\"\nfriction_angle = 20\ncohesion = 20.0", rubber = "model = \"neo_hookean\"";

TEST(LaterRuns, RestartHasTheSameBits) {
  for (const int dimension : {2, 3})
    for (const std::string& material : {metal, soil, rubber}) {
      const BlockSize small(60);
      const std::string text = flowing(dimension, material) + "[[probe]]\nname = \"updates\"\nquantity = \"reference_updates\"\n";
      const auto whole = simulation_of(text), resumed = simulation_of(text);
      while (whole->probe_values()[0] < 1.0 && whole->steps() < 2000) whole->step(1e300);
      run_steps(*whole, 3);
      const SavedState state = whole->save();
      resumed->restore(state);
      EXPECT_EQ(resumed->probe_values()[0], whole->probe_values()[0]);
      const long begin = whole->steps();
      while (whole->probe_values()[0] < 2.0 && whole->steps() < 4000) whole->step(1e300);
      run_steps(*whole, 3);
      EXPECT_EQ(whole->probe_values()[0], 2.0) << dimension << material;
      run_steps(*resumed, static_cast<int>(whole->steps() - begin));
      EXPECT_EQ(resumed->state_hash(), whole->state_hash());
      EXPECT_EQ(resumed->energies().total(), whole->energies().total());
      EXPECT_EQ(resumed->energies().dissipated, whole->energies().dissipated);
    }
}

/// Momenta go on as they were, and what the updates take of the energy is accounted for.
TEST(LaterRuns, RunsConserve) {
  for (const std::string& material : {metal, soil, rubber}) {
    const auto simulation =
        simulation_of(flowing(2, material) + "[[probe]]\nname = \"updates\"\nquantity = \"reference_updates\"\n");
    const Momenta before = simulation->momenta();
    while (simulation->probe_values()[0] < 3.0 && simulation->steps() < 4000) simulation->step(1e300);
    const Momenta after = simulation->momenta();
    const Energies energies = simulation->energies();
    EXPECT_EQ(simulation->probe_values()[0], 3.0) << material;
    EXPECT_LT(norm(after.linear - before.linear), 1e-12 * before.linear_scale);
    EXPECT_LT(std::abs(after.angular[2] - before.angular[2]), 1e-10 * std::abs(before.angular[2]));
    EXPECT_LT(std::abs(energies.balance_error()), 5e-3 * energies.initial) << material;
  }
}

}  // namespace
}  // namespace sinew
