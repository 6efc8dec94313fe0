/// Bodies that come apart: energy and momentum, contact of the pieces, restarts.

#include <gtest/gtest.h>

#include <cmath>

#include "run_case.hpp"

namespace sinew {
namespace {

using namespace sinew::testing;

/// A notched strip, its left and its right part thrown apart; walls send them back.
std::string thrown_strip(const std::string& damage, const std::string& contact, const std::string& more = "") {
  return "[case]\ndimension = 2\n[[body]]\nname = \"strip\"\nmaterial = \"m\"\ngeometry = { shape = \"polygon\", points = [0, 0, "
         "4, "
         "0, 4, 1, 2.3, 1, 2.05, 0.6, 1.95, 0.6, 1.7, 1, 0, 1], spacing = 0.1 }\n"
         "[material.m]\nyoungs_modulus = 1000.0\npoissons_ratio = 0.3\ndensity = 1.0\n" +
         damage +
         "[[initial]]\nregion = { where = \"X < 2\" }\nvelocity = [-1, 0]\n[[initial]]\nregion = { where = \"X > 2\" }\nvelocity "
         "= [1, 0]\n[[wall]]\nname = \"room\"\ngeometry = { shape = \"box\", low = [-0.5, -50], high = [4.5, 50], inside = true "
         "}\n" +
         contact + "[solver]\nend_time = 5.0\nblock_size = 60\n" + more +
         "[[probe]]\nname = \"pieces\"\nquantity = \"fragments\"\n[[probe]]\nname = \"largest\"\nquantity = "
         "\"largest_fragment\"\n"
         "[[probe]]\nname = \"debris\"\nquantity = \"debris\"\n[[probe]]\nname = \"depth\"\nquantity = \"contact_depth\"\n"
         "[[probe]]\nname = \"left\"\nquantity = \"position\"\nregion = { where = \"X < 1.5\" }\ncomponent = \"x\"\n"
         "[[probe]]\nname = \"right\"\nquantity = \"position\"\nregion = { where = \"X > 2.5\" }\ncomponent = \"x\"\n";
}
const std::string brittle =
    "model = \"st_venant_kirchhoff\"\ndamage = { model = \"principal_strain\", threshold = 0.04, separate = true }\n";
const std::string tough =
    "model = \"j2_plastic\"\nyield_stress = 20.0\ndamage = { model = \"plastic_strain\", limit = 0.05, separate = true }\n";
const std::string touching = "[[contact]]\nself = true\n";

/// The halves fly apart, come back from the walls, meet by contact and part again; what is not kinetic or elastic is dissipated. Metal
/// leaves more open, since its rough edges are crushed when they meet.
TEST(Separation, PiecesMeetByContact) {
  for (const std::string& material : {brittle, tough}) {
    const auto simulation = simulation_of(thrown_strip(material, touching));
    const double mass = simulation->facts().bodies[0].mass;
    double worst = 0.0, contact = 0.0, nearest = 10.0, farthest = 0.0;
    while (simulation->time() < 4.0) {
      run_steps(*simulation, 10);
      const Energies e = simulation->energies();
      worst = std::max(worst, std::abs(e.balance_error()));
      const std::vector<double> probes = simulation->probe_values();
      if (probes[0] < 2.0) continue;  // still one
      contact = std::max(contact, e.contact);
      nearest = std::min(nearest, probes[5] - probes[4]);
      farthest = std::max(farthest, probes[5] - probes[4]);
    }
    const std::vector<double> probes = simulation->probe_values();
    EXPECT_GE(probes[0], 2.0);
    EXPECT_GT(probes[1], 0.25 * mass);
    EXPECT_GT(probes[2], 0.0);
    EXPECT_LT(probes[2], 0.3 * mass);
    EXPECT_LT(probes[3], 1.0) << "depth of contact";
    EXPECT_GT(farthest, 2.9) << "the halves were apart";
    EXPECT_GT(nearest, 1.8) << "and did not pass through each other";
    EXPECT_LT(worst, (material == brittle ? 0.005 : 0.06) * simulation->energies().initial);
  }
}

TEST(Separation, WithoutContactPiecesPassThroughEachOther) {
  const auto simulation = simulation_of(thrown_strip(brittle, ""));
  bool warned = false;
  for (const std::string& warning : simulation->facts().warnings)
    warned = warned || warning.find("no [[contact]] with self") != std::string::npos;
  EXPECT_TRUE(warned);
  double nearest = 10.0;
  while (simulation->time() < 4.0) {
    run_steps(*simulation, 10);
    nearest = std::min(nearest, simulation->probe_values()[5] - simulation->probe_values()[4]);
  }
  EXPECT_LT(nearest, 1.7);
}

/// What separates gets no push: momentum without walls is that of the start, and no debris is faster than what threw it.
TEST(Separation, MomentumStays) {
  std::string text = thrown_strip(tough, touching);
  const auto begin = text.find("[[wall]]"), end = text.find("[[contact]]");
  text.erase(begin, end - begin);
  const auto simulation = simulation_of(text);
  const Momenta before = simulation->momenta();
  run_until(*simulation, 0.3);
  EXPECT_GE(simulation->probe_values()[0], 2.0);
  EXPECT_LT(norm(simulation->momenta().linear - before.linear), 1e-12 * before.linear_scale);
}

/// Some particles have failed, others are about to.
TEST(Separation, RestartGivesTheSameBits) {
  for (const std::string& material : {brittle, tough}) {
    const std::string text = thrown_strip(material, touching + "friction = 0.2\n");
    const auto whole = simulation_of(text), first = simulation_of(text);
    while (first->probe_values()[2] == 0.0) first->step(1e300), whole->step(1e300);
    const double debris = first->probe_values()[2];
    const auto second = simulation_of(text);
    second->restore(first->save());
    EXPECT_EQ(second->probe_values()[2], debris);
    EXPECT_EQ(second->stable_time_step(), whole->stable_time_step());
    run_steps(*whole, 200);
    run_steps(*second, 200);
    EXPECT_GT(second->probe_values()[2], debris);
    EXPECT_EQ(second->state_hash(), whole->state_hash());
    EXPECT_EQ(second->energies().dissipated, whole->energies().dissipated);
    EXPECT_EQ(second->probe_values(), whole->probe_values());
  }
}

}  // namespace
}  // namespace sinew
