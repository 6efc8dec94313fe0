/// Damage in whole bodies: stress goes, energy is counted, compression stays, restarts change nothing.

#include <gtest/gtest.h>

#include <cmath>

#include "run_case.hpp"

namespace sinew {
namespace {

using namespace sinew::testing;

/// A block all of whose particles move as u = stretch(t) - 1 times X says, E = 1000, c = 36.
std::string driven(int dimension, const std::string& motion,
                   const std::string& damage = "{ model = \"principal_strain\", threshold = 0.08 }",
                   const std::string& material = "model = \"st_venant_kirchhoff\"") {
  const bool space = dimension == 3;
  return "[case]\ndimension = " + std::to_string(dimension) +
         "\n[[body]]\nname = \"block\"\nmaterial = \"m\"\ngeometry = { shape = \"box\", low = " +
         (space ? "[0, 0, 0], high = [1, 0.5, 0.5]" : "[0, 0], high = [1, 0.5]") + ", spacing = 0.1 }\n[material.m]\n" +
         material + "\nyoungs_modulus = 1000.0\npoissons_ratio = 0.0\ndensity = 1.0\ndamage = " + damage +
         "\n[[boundary]]\nregion = \"block\"\ndisplacement = [\"" + motion + "\", 0" + (space ? ", 0" : "") +
         "]\n[solver]\nend_time = 10.0\n"
         "[[probe]]\nname = \"stress\"\nquantity = \"first_piola_kirchhoff_stress\"\ncomponent = \"xx\"\n"
         "[[probe]]\nname = \"damage\"\nquantity = \"damage\"\nreduce = \"max\"\n"
         "[[probe]]\nname = \"least\"\nquantity = \"damage\"\nreduce = \"min\"\n";
}

/// Damage begins at the threshold and is complete 2.5 R / c later; then no tension is left. The work that is not in the strain energy is in damage.
TEST(Damage, TensionGoes) {
  for (int dimension : {2, 3}) {
    const auto simulation = simulation_of(driven(dimension, "0.2*t*X"));
    double begun = -1.0, ended = -1.0;
    while (simulation->time() < 0.6) {
      simulation->step(1e300);
      const std::vector<double> probes = simulation->probe_values();
      EXPECT_NEAR(probes[1], probes[2], 1e-12) << "all alike";
      if (begun < 0.0 && probes[1] > 0.0) begun = simulation->time();
      if (ended < 0.0 && probes[1] == 1.0) ended = simulation->time();
      const double stretch = 1.0 + 0.2 * simulation->time(), E = 0.5 * (stretch * stretch - 1.0);
      EXPECT_NEAR(probes[0], (1.0 - probes[1]) * stretch * 1000.0 * E, 1e-9 * 1000.0);
    }
    EXPECT_NEAR(begun, (std::sqrt(1.16) - 1.0) / 0.2, 0.002);
    EXPECT_NEAR(ended - begun, 2.5 * 2.41 * 0.1 / std::sqrt(1000.0), 0.002);
    const Energies e = simulation->energies();
    EXPECT_NEAR(e.damage_work, e.external_work - e.kinetic + e.initial, 0.03 * e.damage_work);
    EXPECT_NEAR(e.strain, 0.0, 1e-9);
    EXPECT_GT(e.damage_work, 0.0);
  }
}

/// Pulled until it fails, then pushed: it carries compression as if nothing had happened.
TEST(Damage, CompressionStays) {
  const auto simulation = simulation_of(driven(2, "X*if(t < 0.5, 0.2*t, 0.1 - 0.4*(t - 0.5))"));
  run_until(*simulation, 1.0);
  const std::vector<double> probes = simulation->probe_values();
  EXPECT_EQ(probes[1], 1.0);
  EXPECT_NEAR(probes[0], 0.9 * 1000.0 * 0.5 * (0.81 - 1.0), 1.0);
}

TEST(Damage, PushDoesNotDamage) {
  const auto simulation = simulation_of(driven(2, "-0.3*t*X"));
  run_until(*simulation, 0.8);
  EXPECT_EQ(simulation->probe_values()[1], 0.0);
}

TEST(Damage, FollowsPlasticStrain) {
  const std::string metal = "model = \"j2_plastic\"\nyield_stress = 10.0";
  for (const std::string damage : {"{ model = \"plastic_strain\", limit = 0.05 }", "{ model = \"johnson_cook\", d1 = 0.05 }"}) {
    const auto simulation = simulation_of(driven(2, "0.2*t*X", damage, metal));
    run_until(*simulation, 0.3);
    EXPECT_EQ(simulation->probe_values()[1], 0.0);
    run_until(*simulation, 0.6);
    EXPECT_EQ(simulation->probe_values()[1], 1.0);
    EXPECT_LT(simulation->probe_values()[0], 1e-9);
    const Energies e = simulation->energies();
    EXPECT_LT(std::abs(e.balance_error()), 0.03 * e.external_work) << "flow of what has failed takes no work";
  }
}

std::string torn_strip() {
  std::string text = free_block(2, "[[probe]]\nname = \"damage\"\nquantity = \"damage\"\nreduce = \"max\"\n");
  text.replace(text.find("density = 1.0"), 13, "density = 1.0\ndamage = { model = \"principal_strain\", threshold = 0.02 }");
  const std::string before = "[\"3*sin(2*y)\", \"-2*x\"]";
  text.replace(text.find(before), before.size(), "[\"2*(X - 1)\", 0]");
  return text;
}

TEST(Damage, RestartGivesTheSameBits) {
  const auto whole = simulation_of(torn_strip()), first = simulation_of(torn_strip());
  run_steps(*whole, 120);
  run_steps(*first, 20);
  EXPECT_GT(first->probe_values()[0], 0.0);
  EXPECT_LT(first->probe_values()[0], 1.0);
  const auto second = simulation_of(torn_strip());
  second->restore(first->save());
  run_steps(*second, 100);
  EXPECT_EQ(second->state_hash(), whole->state_hash());
  EXPECT_EQ(second->energies().damage_work, whole->energies().damage_work);
}

/// A strip pulled apart at both ends: one piece, then two, with debris between them, whose masses add up.
TEST(Damage, PiecesAreCounted) {
  const auto simulation = simulation_of(
      "[case]\ndimension = 2\n[[body]]\nname = \"strip\"\nmaterial = \"m\"\ngeometry = { shape = \"polygon\", points = [0, 0, 4, "
      "0, 4, 1, 2.3, 1, 2.05, 0.6, 1.95, 0.6, 1.7, 1, 0, 1], "
      "spacing = 0.1 }\n"
      "[material.m]\nmodel = \"st_venant_kirchhoff\"\nyoungs_modulus = 1000.0\npoissons_ratio = 0.3\ndensity = 1.0\n"
      "damage = { model = \"principal_strain\", threshold = 0.05 }\n"
      "[[boundary]]\nregion = { where = \"X < 0.3\" }\nvelocity = [\"-min(t, 0.1)*10\", 0]\n"
      "[[boundary]]\nregion = { where = \"X > 3.7\" }\nvelocity = [\"min(t, 0.1)*10\", 0]\n"
      "[solver]\nend_time = 1.0\nblock_size = 60\n"
      "[[probe]]\nname = \"pieces\"\nquantity = \"fragments\"\n[[probe]]\nname = \"largest\"\nquantity = \"largest_fragment\"\n"
      "[[probe]]\nname = \"debris\"\nquantity = \"debris\"\n");
  std::vector<double> probes = simulation->probe_values();
  const double mass = probes[1];
  EXPECT_EQ(probes[0], 1.0);
  EXPECT_NEAR(mass, simulation->facts().bodies[0].mass, 1e-12);
  EXPECT_EQ(probes[2], 0.0);
  run_until(*simulation, 0.4);
  probes = simulation->probe_values();
  EXPECT_EQ(probes[0], 2.0);
  EXPECT_GT(probes[2], 0.0);
  EXPECT_LT(probes[2], 0.3 * mass);
  EXPECT_GT(probes[1], 0.35 * mass);
  EXPECT_LT(probes[1] + probes[2], 0.7 * mass);
}

/// The free strip tears: momentum stays, and the energy that is gone is that of damage, within what its split of the energy leaves open.
TEST(Damage, EnergyBalancesWhenItTears) {
  const auto simulation = simulation_of(torn_strip());
  const Momenta before = simulation->momenta();
  double worst = 0.0;
  while (simulation->time() < 0.2) {
    simulation->step(1e300);
    worst = std::max(worst, std::abs(simulation->energies().balance_error()));
  }
  EXPECT_EQ(simulation->probe_values()[0], 1.0);
  EXPECT_LT(norm(simulation->momenta().linear - before.linear), 1e-12 * before.linear_scale);
  EXPECT_LT(worst, 0.1 * simulation->energies().initial);
}

}  // namespace
}  // namespace sinew
