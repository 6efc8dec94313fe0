/// Bodies against rigid walls: impacts, friction, moving walls, energies, momenta.

#include <gtest/gtest.h>

#include <cmath>

#include "run_case.hpp"

namespace sinew {
namespace {

using namespace sinew::testing;

/// An elastic bar, 20 x 2 particles of spacing 0.1, 0.05 above the floor y = 0 and falling on it at speed 0.3; c = 100.
std::string falling_bar(const std::string& wall, const std::string& more = "") {
  return "[case]\ndimension = 2\n[[body]]\nname = \"bar\"\nmaterial = \"m\"\n"
         "geometry = { shape = \"box\", low = [0, 0.05], high = [0.2, 2.05], spacing = 0.1 }\n"
         "[material.m]\nmodel = \"st_venant_kirchhoff\"\nyoungs_modulus = 1e4\npoissons_ratio = 0.0\ndensity = 1.0\n"
         "[[initial]]\nregion = \"bar\"\nvelocity = [0, -0.3]\n[solver]\nend_time = 1.0\n"
         "[[wall]]\nname = \"floor\"\ngeometry = { shape = \"plane\", point = [0, 0], normal = [0, 1] }\n" +
         wall + more;
}

/// One-dimensional elastic impact: contact for 2 L / c and rebound with the speed of the fall; impulse 2 m v.
TEST(Walls, ElasticBarBouncesAfterTwoTransits) {
  const auto simulation = simulation_of(falling_bar(
      "stiffness = 1e6\n", "[[probe]]\nname = \"push\"\nquantity = \"wall_force\"\nwall = \"floor\"\ncomponent = \"y\"\n"));
  double touching = 0.0, impulse = 0.0;
  while (simulation->time() < 0.3) {
    const double before = simulation->time();
    simulation->step(1e300);
    const double dt = simulation->time() - before, push = simulation->probe_values()[0];
    EXPECT_GE(push, 0.0);
    if (push > 0.0) touching += dt;
    impulse += push * dt;
  }
  const double mass = 0.4;
  EXPECT_NEAR(touching, 2.0 * 2.0 / 100.0, 0.1 * 0.04);
  EXPECT_NEAR(impulse / touching, 1.0 * 100.0 * 0.3 * 0.2, 0.05 * 6.0) << "rho c v times the area";
  EXPECT_NEAR(simulation->momenta().linear[1], impulse - mass * 0.3, 1e-2 * mass * 0.3);
  EXPECT_NEAR(impulse, 2.0 * mass * 0.3, 0.03 * 2.0 * mass * 0.3);
  EXPECT_LT(std::abs(simulation->energies().balance_error()), 5e-3 * simulation->energies().initial);
}

/// The energy is in the contact while it lasts, and with damping some of it is gone afterwards; the balance closes either way.
TEST(Walls, EnergyBalancesWithDampingAndFriction) {
  std::string text = falling_bar("damping = 0.3\nfriction = 0.4\n");
  text.replace(text.find("velocity = [0, -0.3]"), 20, "velocity = [0.5, -0.3]");
  const auto simulation = simulation_of(text);
  double most_contact = 0.0, worst = 0.0;
  while (simulation->time() < 0.3) {
    simulation->step(1e300);
    most_contact = std::max(most_contact, simulation->energies().contact);
    worst = std::max(worst, std::abs(simulation->energies().balance_error()));
  }
  const Energies e = simulation->energies();
  EXPECT_GT(most_contact, 0.01 * e.initial);
  EXPECT_EQ(e.contact, 0.0);
  EXPECT_GT(e.dissipated, 0.05 * e.initial);
  EXPECT_LT(worst, 5e-3 * e.initial);
}

/// Coulomb: sliding friction takes mu times the normal impulse, 2 m v_n, off the momentum along the wall.
TEST(Walls, FrictionTakesItsShareOfTheImpulse) {
  std::string text = falling_bar("friction = 0.05\n");
  text.replace(text.find("velocity = [0, -0.3]"), 20, "velocity = [2.0, -0.3]");
  const auto simulation = simulation_of(text);
  const double before = simulation->momenta().linear[0];
  run_until(*simulation, 0.3);
  const double normal = simulation->momenta().linear[1] + 0.4 * 0.3;
  EXPECT_NEAR(before - simulation->momenta().linear[0], 0.05 * normal, 0.0005 * normal);
}

/// In the frame of a wall that comes up to a bar at rest everything is as in that of the wall; the wall does the work.
TEST(Walls, MovingWallDoesTheWork) {
  for (const std::string motion : {"velocity = [0, 0.3]\n", "displacement = [0, \"0.3*t\"]\n"}) {
    std::string text = falling_bar(motion);
    text.replace(text.find("velocity = [0, -0.3]"), 20, "velocity = [0, 0]");
    const auto simulation = simulation_of(text);
    run_until(*simulation, 0.3);
    EXPECT_NEAR(simulation->momenta().linear[1], 0.4 * 0.6, 0.02 * 0.24);
    const Energies e = simulation->energies();
    EXPECT_NEAR(e.external_work, 0.5 * 0.4 * 0.36, 0.03 * 0.072);
    EXPECT_LT(std::abs(e.balance_error()), 1e-3 * e.external_work);
  }
}

/// Trapezoidal rule in every step, so that the balance holds while they touch.
TEST(Walls, WorkOfAMovingWallIsThatOfItsForce) {
  std::string text = falling_bar("velocity = [0, 0.3]\n",
                                 "[[probe]]\nname = \"push\"\nquantity = \"wall_force\"\nwall = \"floor\"\ncomponent = \"y\"\n");
  text.replace(text.find("velocity = [0, -0.3]"), 20, "velocity = [0, 0]");
  const auto simulation = simulation_of(text);
  double work = 0.0, before = simulation->probe_values()[0];
  while (simulation->time() < 0.3) {
    const double begin = simulation->time();
    simulation->step(1e300);
    const double push = simulation->probe_values()[0];
    work += 0.5 * (before + push) * 0.3 * (simulation->time() - begin);
    before = push;
    EXPECT_NEAR(simulation->energies().external_work, work, 1e-12 * 0.072);
  }
  EXPECT_GT(work, 0.05);
}

/// A wall that comes at a bar, and a bar that comes at a wall: the same in every step, with friction and damping.
TEST(Walls, OnlyRelativeMotionCounts) {
  std::string moving = falling_bar("velocity = [-0.5, 0.3]\nfriction = 0.2\ndamping = 0.3\n"),
              fixed = falling_bar("friction = 0.2\ndamping = 0.3\n");
  moving.replace(moving.find("velocity = [0, -0.3]"), 20, "velocity = [0, 0]");
  fixed.replace(fixed.find("velocity = [0, -0.3]"), 20, "velocity = [0.5, -0.3]");
  for (std::string* text : {&moving, &fixed}) text->replace(text->find("end_time = 1.0"), 14, "end_time = 1.0\ntime_step = 2e-4");
  const auto a = simulation_of(moving), b = simulation_of(fixed);
  for (int step = 0; step < 1500; ++step) {
    a->step(1e300);
    b->step(1e300);
    EXPECT_NEAR(a->momenta().linear[0], b->momenta().linear[0] - 0.4 * 0.5, 1e-10);
    EXPECT_NEAR(a->momenta().linear[1], b->momenta().linear[1] + 0.4 * 0.3, 1e-10);
  }
  EXPECT_GT(std::abs(a->momenta().linear[0]), 0.01) << "friction has acted";
}

TEST(Walls, ActOnNamedBodiesOnly) {
  std::string text = falling_bar("bodies = [\"other\"]\n",
                                 "[[body]]\nname = \"other\"\nmaterial = \"m\"\n"
                                 "geometry = { shape = \"box\", low = [5, 5], high = [6, 6], spacing = 0.1 }\n");
  const auto simulation = simulation_of(text);
  run_until(*simulation, 0.3);
  EXPECT_DOUBLE_EQ(simulation->energies().contact, 0.0);
  EXPECT_NEAR(simulation->momenta().linear[1], -0.4 * 0.3, 1e-12);
}

TEST(Walls, RestartGivesTheSameBits) {
  const std::string text = falling_bar("friction = 0.3\ndamping = 0.1\nvelocity = [0, \"0.1*cos(40*t)\"]\n");
  const auto whole = simulation_of(text), first = simulation_of(text);
  run_steps(*whole, 900);
  run_steps(*first, 600);
  EXPECT_GT(first->energies().contact, 0.0) << "in the middle of the impact";
  const auto second = simulation_of(text);
  second->restore(first->save());
  EXPECT_EQ(second->stable_time_step(), first->stable_time_step());
  run_steps(*second, 300);
  EXPECT_EQ(second->state_hash(), whole->state_hash());
  EXPECT_EQ(second->energies().external_work, whole->energies().external_work);
  EXPECT_EQ(second->energies().dissipated, whole->energies().dissipated);
}

/// A wall 10 000 times as stiff as the bar: contact decides the step, and the run keeps its energy.
TEST(Walls, ContactLimitsTheTimeStep) {
  const auto simulation = simulation_of(falling_bar("stiffness = 1e8\n"));
  const double before = simulation->stable_time_step();
  double least = before;
  while (simulation->time() < 0.3) {
    simulation->step(1e300);
    least = std::min(least, simulation->stable_time_step());
  }
  EXPECT_LT(least, 0.5 * before);
  EXPECT_LT(std::abs(simulation->energies().balance_error()), 6e-2 * simulation->energies().initial);
}

/// In SI units, with lanes of padding beside real particles: no sum becomes infinite.
TEST(Walls, StiffMetalInTheLastLanes) {
  const auto simulation = simulation_of(
      "[case]\ndimension = 2\n[[body]]\nname = \"bar\"\ngeometry = { shape = \"box\", low = [0, 0], high = [0.003, 0.011], "
      "spacing = 0.001 }\n"
      "material = { model = \"st_venant_kirchhoff\", youngs_modulus = 2e11, poissons_ratio = 0.3, density = 7800 }\n"
      "[[initial]]\nregion = \"bar\"\nvelocity = [0, -10]\n[[wall]]\nname = \"anvil\"\ngeometry = { shape = \"plane\", point = "
      "[0, 0], normal = [0, 1] }\n"
      "[solver]\nend_time = 1\n");
  run_steps(*simulation, 60);
  EXPECT_LT(std::abs(simulation->energies().balance_error()), 1e-3 * simulation->energies().initial);
}

TEST(Walls, BodiesInsideAreAnError) {
  std::string text = falling_bar("");
  text.replace(text.find("point = [0, 0]"), 14, "point = [0, 0.5]");
  try {
    simulation_of(text);
    FAIL();
  } catch (const CaseError& error) {
    EXPECT_NE(std::string(error.what()).find("wall \"floor\" is inside a body at the start: 10 particles"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace sinew
