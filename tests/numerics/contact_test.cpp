/// Bodies that touch: momenta, energies, search, restarts, threads, ways to fail.

#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>
#include <sinew/contact/pair_contacts.hpp>

#include "clouds.hpp"
#include "two_balls.hpp"

namespace sinew {
namespace {

using namespace sinew::testing;

double overlap_of(Simulation& simulation) {
  const Snapshot s = simulation.snapshot({"displacement"});
  double most = 0.0;
  for (std::size_t i = 0; i < s.position.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (s.body[i] != s.body[j])
        most = std::max(most, 1.0 - norm(s.position[i] - s.position[j]) / (0.5 * (s.size[i] + s.size[j])));
  return most;
}

TEST(Contact, ConservesMomentaAndEnergy) {
  for (int dimension : {2, 3}) {
    const auto simulation = simulation_of(two_balls(dimension));
    const Momenta before = simulation->momenta();
    double most_contact = 0.0, worst = 0.0, deepest = 0.0;
    int step = 0;
    while (simulation->time() < 0.6) {
      simulation->step(1e300);
      most_contact = std::max(most_contact, simulation->energies().contact);
      worst = std::max(worst, std::abs(simulation->energies().balance_error()));
      if (++step % 20 == 0) deepest = std::max(deepest, overlap_of(*simulation));
    }
    const Momenta after = simulation->momenta();
    EXPECT_LT(norm(after.linear - before.linear), 1e-12 * before.linear_scale);
    EXPECT_LT(norm(after.angular - before.angular), 1e-12 * before.linear_scale);
    EXPECT_GT(most_contact, 0.001 * simulation->energies().initial);
    EXPECT_LT(worst, 2e-3 * simulation->energies().initial) << dimension;
    EXPECT_LT(deepest, 0.5);
    EXPECT_EQ(simulation->energies().contact, 0.0) << "apart again";
  }
}

TEST(Contact, EnergyBalancesWithFrictionAndDamping) {
  const auto simulation = simulation_of(two_balls(2, "friction = 0.5\ndamping = 0.2\n"));
  double worst = 0.0;
  while (simulation->time() < 0.6) {
    simulation->step(1e300);
    worst = std::max(worst, std::abs(simulation->energies().balance_error()));
  }
  EXPECT_GT(simulation->energies().dissipated, 0.02 * simulation->energies().initial);
  EXPECT_LT(worst, 5e-3 * simulation->energies().initial);
}

/// Without [[contact]] they pass through each other, and a warning says so.
TEST(Contact, OnlyWhereAskedFor) {
  std::string text = two_balls(2);
  text.erase(text.find("[[contact]]\n"), 12);
  const auto simulation = simulation_of(text);
  run_until(*simulation, 0.25);
  EXPECT_GT(overlap_of(*simulation), 0.7);
  ASSERT_EQ(simulation->facts().warnings.size(), 1U);
  EXPECT_NE(simulation->facts().warnings[0].find("[[contact]]"), std::string::npos);
}

/// Forces of contact on the particles of one body are what drives it.
TEST(Contact, ForceIsThatOnTheBody) {
  const auto simulation = simulation_of(
      two_balls(2, "",
                "[[probe]]\nname = \"fa\"\nquantity = \"contact_force\"\nregion = \"a\"\nreduce = \"sum\"\ncomponent = \"x\"\n"
                "[[probe]]\nname = \"fb\"\nquantity = \"contact_force\"\nregion = \"b\"\nreduce = \"sum\"\ncomponent = \"x\"\n"
                "[[probe]]\nname = \"pa\"\nquantity = \"force\"\nregion = \"a\"\nreduce = \"sum\"\ncomponent = \"x\"\n"));
  run_until(*simulation, 0.12);
  const std::vector<double> probes = simulation->probe_values();
  EXPECT_LT(probes[0], -0.5);
  EXPECT_NEAR(probes[0], -probes[1], 1e-12 * std::abs(probes[0]));
  EXPECT_NEAR(probes[0], probes[2], 1e-10 * std::abs(probes[0]));
}

TEST(Contact, SameBitsOnAnyNumberOfThreadsAndAfterARestart) {
  const BlockSize small(40);
  const std::string text = two_balls(3, "friction = 0.3\ndamping = 0.1\n");
  omp_set_num_threads(1);
  const auto whole = simulation_of(text), first = simulation_of(text);
  run_steps(*whole, 220);
  run_steps(*first, 140);
  EXPECT_GT(first->energies().contact, 0.0) << "in the middle of the impact";
  omp_set_num_threads(3);
  const int before = fewest_for_threads;
  fewest_for_threads = 1;
  const auto second = simulation_of(text), threads = simulation_of(text);
  second->restore(first->save());
  EXPECT_EQ(second->stable_time_step(), first->stable_time_step());
  run_steps(*second, 80);
  run_steps(*threads, 220);
  fewest_for_threads = before;
  EXPECT_EQ(second->state_hash(), whole->state_hash());
  EXPECT_EQ(threads->state_hash(), whole->state_hash());
  EXPECT_EQ(second->energies().dissipated, whole->energies().dissipated);
}

/// The list against looking at all pairs, while particles fly about; and it is made rarely.
TEST(Contact, ListMissesNobody) {
  PointSet a, b;
  a.spacing = b.spacing = 1.0;
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> place(0.0, 8.0), speed(-1.0, 1.0);
  for (PointSet* points : {&a, &b})
    for (int k = 0; k < 150; ++k) {
      points->position.push_back({{place(random), place(random), place(random)}});
      points->volume.push_back(1.0);
    }
  Particles<3> particles = make_particles<3>({{"a", &a, 1.0, 1.0}, {"b", &b, 1.0, 1.0}}, 1.0);
  HertzContact law;
  law.stiffness = 3.0;
  const ContactTable table{2, {law}, {-1, 0, 0, -1}, {0, 0}};
  PairContacts<3> contacts(table, particles, std::vector<double>(particles.slots, 2.0), 1.0, Comm());
  VectorField<3> velocity(particles.slots), forces(particles.slots), unused(particles.slots);
  for (int slot : particles.slot_of) velocity.set(slot, {{speed(random), speed(random), speed(random)}});
  std::vector<ContactSums> sums(particles.blocks.size());
  for (int step = 0; step < 100; ++step) {
    forces.clear();
    contacts.push(particles, 0.0, forces, unused, sums);
    double worst = 0.0;
    for (int i : particles.slot_of) {
      Vec3<double> expected;
      for (int j : particles.slot_of) {
        if (particles.body_of(i) == particles.body_of(j)) continue;
        const Vec3<double> d = particles.current(i) - particles.current(j);
        const double depth = 1.0 - norm(d);
        if (depth > 0.0) expected += (16.0 / 15.0 * 3.0 * depth * std::sqrt(depth * 0.25) / norm(d)) * d;
      }
      worst = std::max(worst, norm(expected - forces[i]));
    }
    EXPECT_LT(worst, 1e-13);
    for (int slot : particles.slot_of) particles.displacement.set(slot, particles.displacement[slot] + 0.02 * velocity[slot]);
  }
  EXPECT_GT(contacts.lists_made(), 3);
  EXPECT_LT(contacts.lists_made(), 20);
}

/// Two particles that come from just beyond the list and pass: in every step the list has them as soon as they are near enough to limit the time step.
TEST(Contact, ListIsRenewedInTime) {
  PointSet a, b;
  a.spacing = b.spacing = 1.0;
  a.position = {{{0.0, 0.0, 0.0}}}, b.position = {{{1.7501, 0.0, 0.0}}};  // 1.25 and a skin of 0.5
  a.volume = b.volume = {1.0};
  Particles<3> particles = make_particles<3>({{"a", &a, 1.0, 1.0}, {"b", &b, 1.0, 1.0}}, 1.0);
  HertzContact law;
  law.stiffness = 3.0;
  PairContacts<3> contacts(ContactTable{2, {law}, {-1, 0, 0, -1}, {0, 0}}, particles, std::vector<double>(particles.slots, 2.0),
                           1.0, Comm());
  VectorField<3> forces(particles.slots), unused(particles.slots);
  const int left = particles.slot_of[0], right = particles.slot_of[1];
  particles.velocity.set(left, {{1, 0, 0}});
  particles.velocity.set(right, {{-1, 0, 0}});
  for (int step = 0; step < 50; ++step) {
    std::vector<ContactSums> sums(particles.blocks.size());
    contacts.push(particles, 0.0, forces, unused, sums);
    const bool near = norm(particles.current(right) - particles.current(left)) < 1.25;
    for (const ContactSums& of_block : sums) EXPECT_DOUBLE_EQ(of_block.approach, near ? 2.0 : 0.0) << "step " << step;
    particles.displacement.set(left, particles.displacement[left] + Vec3<double>{{0.01, 0, 0}});
    particles.displacement.set(right, particles.displacement[right] - Vec3<double>{{0.01, 0, 0}});
  }
}

/// The arms of a C swing at each other: with `self` they push each other away, without they pass.
TEST(Contact, BodyTouchesItself) {
  const auto closest = [](const std::string& contact) {
    const auto simulation = simulation_of(
        "[case]\ndimension = 2\n[material.rubber]\nmodel = \"neo_hookean\"\nyoungs_modulus = 1000.0\npoissons_ratio = "
        "0.4\ndensity = 1.0\n"
        "[[body]]\nname = \"u\"\nmaterial = \"rubber\"\ngeometry = { shape = \"polygon\", points = [[0, 0], [1, 0], [1, 0.2], "
        "[0.2, 0.2], [0.2, 0.5], [1, 0.5], [1, 0.7], [0, 0.7]], spacing = 0.05 }\n"
        "[[initial]]\nregion = \"u\"\nvelocity = [0, \"-8*(Y - 0.35)*X\"]\n" +
        contact + "[solver]\nend_time = 1.0\n");
    double least = 1e300;
    while (simulation->time() < 0.3) {
      simulation->step(1e300);
      const Snapshot s = simulation->snapshot({"displacement"});
      double top = 1e300, bottom = -1e300;
      for (std::size_t i = 0; i < s.position.size(); ++i) {
        const Point reference = s.position[i] - Point{{s.fields[0].values[3 * i], s.fields[0].values[3 * i + 1], 0.0}};
        if (reference[0] < 0.5) continue;
        (reference[1] > 0.35 ? top : bottom) =
            reference[1] > 0.35 ? std::min(top, s.position[i][1]) : std::max(bottom, s.position[i][1]);
      }
      least = std::min(least, top - bottom);
    }
    return least;
  };
  EXPECT_LT(closest(""), 0.0);
  EXPECT_GT(closest("[[contact]]\nself = true\n"), 0.02);
}

/// A tool of particles four times as small that moves as given pushes a block without limiting the step.
TEST(Contact, RigidToolPushes) {
  const auto text = [](const std::string& tool) {
    return "[case]\ndimension = 2\n[material.rubber]\nmodel = \"neo_hookean\"\nyoungs_modulus = 1000.0\npoissons_ratio = "
           "0.4\ndensity = 1.0\n"
           "[material.steel]\nmodel = \"rigid\"\ndensity = 1.0\n"
           "[[body]]\nname = \"block\"\nmaterial = \"rubber\"\ngeometry = { shape = \"box\", low = [0, 0], high = [1, 1], "
           "spacing = 0.1 }\n" +
           tool + "[solver]\nend_time = 1.0\n";
  };
  const auto alone = simulation_of(text(""));
  const auto simulation = simulation_of(text(
      "[[body]]\nname = \"tool\"\nmaterial = \"steel\"\ngeometry = { shape = \"box\", low = [-0.2, 1.0625], high = [1.2, "
      "1.2125], spacing = 0.025 }\n"
      "[[boundary]]\nregion = \"tool\"\nvelocity = [0, \"-min(t, 0.1)*10\"]\n"
      "[[boundary]]\nregion = { body = \"block\", where = \"Y < 0.1\" }\nvelocity = [0, 0]\n[[contact]]\n"
      "[[probe]]\nname = \"push\"\nquantity = \"reaction_force\"\nregion = \"tool\"\ncomponent = \"y\"\n"
      "[[probe]]\nname = \"contact\"\nquantity = \"contact_force\"\nregion = \"block\"\ncomponent = \"y\"\nreduce = \"sum\"\n"
      "[[probe]]\nname = \"depth\"\nquantity = \"contact_depth\"\n"));
  EXPECT_NEAR(simulation->stable_time_step(), alone->stable_time_step(), 0.05 * alone->stable_time_step());
  run_until(*simulation, 0.3);
  const std::vector<double> probes = simulation->probe_values();
  EXPECT_LT(probes[0], -30.0);
  EXPECT_NEAR(probes[0], probes[1], 0.02 * std::abs(probes[0]));
  EXPECT_LT(std::abs(simulation->energies().balance_error()), 5e-3 * simulation->energies().external_work);
  EXPECT_LT(overlap_of(*simulation), 0.65);
  EXPECT_NEAR(probes[2], overlap_of(*simulation), 1e-12);
}

/// case.resolved.toml, from which a run goes on, is a case again and means the same.
TEST(Contact, ResolvedCaseIsACase) {
  const std::string walls =
      "[[wall]]\nname = \"w\"\ngeometry = { shape = \"box\", low = [-9, -9], high = [9, 9], inside = true }\nvelocity = [0, "
      "\"0.1*t\"]\n";
  for (const std::string contact : {"", "bodies = [\"a\", \"b\"]\nself = true\nstiffness = 300\n"}) {
    const Case first = make_case(read_toml_text(two_balls(2, contact, walls), "case.toml"), ".");
    const Case again = make_case(first.resolved, ".");
    const auto one = Simulation::build(first), other = Simulation::build(again);
    run_steps(*one, 100);
    run_steps(*other, 100);
    EXPECT_EQ(one->state_hash(), other->state_hash());
  }
}

/// A tool faster than sound is probably a wrong unit; a slow one gives no warning.
TEST(Contact, SupersonicMotionIsWarnedOf) {
  std::string text = two_balls(2);
  EXPECT_TRUE(simulation_of(text)->facts().warnings.empty());
  text.replace(text.find("velocity = [1, 0"), 16, "velocity = [99, 0");
  const auto simulation = simulation_of(text);
  ASSERT_EQ(simulation->facts().warnings.size(), 1U);
  EXPECT_NE(simulation->facts().warnings[0].find("faster than the waves"), std::string::npos);
}

}  // namespace
}  // namespace sinew
