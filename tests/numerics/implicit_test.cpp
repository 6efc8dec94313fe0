/// Motion in steps that solve equations, and pressures that follow the surface.

#include <gtest/gtest.h>

#include <cmath>

#include "clouds.hpp"
#include "run_case.hpp"
#include <sinew/formulations/boundary/loads.hpp>

namespace sinew {
namespace {

using namespace sinew::testing;

/// A cantilever that starts to swing in its first mode. `material`: with model and parameters.
std::string beam(const std::string& material, const std::string& solver, double amplitude = 0.01) {
  return "[case]\ndimension = 2\n[[body]]\nname = \"beam\"\nmaterial = { model = \"" + material +
         "\", density = 1, youngs_modulus = 100, poissons_ratio = 0.3 }\n"
         "geometry = { shape = \"box\", low = [0, 0], high = [4, 1], spacing = 0.25 }\n"
         "[region]\nleft = { where = \"X < 0.25\" }\ntip = { where = \"X > 3.75\" }\n"
         "[[initial]]\nregion = { where = \"X > 0.25\" }\nvelocity = [0, \"" +
         std::to_string(amplitude) +
         "*X^2\"]\n"
         "[[boundary]]\nregion = \"left\"\ndisplacement = [0, 0]\n"
         "[[probe]]\nname = \"tip\"\nquantity = \"displacement\"\ncomponent = \"y\"\nregion = \"tip\"\n" +
         solver;
}

double tip_of(const std::string& text, double time) {
  const auto simulation = simulation_of(text);
  run_until(*simulation, time);
  return simulation->probe_values()[0];
}

TEST(Implicit, NewmarkConservesTheEnergyOfALinearBody) {
  const auto simulation =
      simulation_of(beam("linear_elastic", "[solver]\nmode = \"implicit\"\ntime_step = 0.5\nend_time = 40\ntolerance = 1e-12\n"));
  const double start = simulation->energies().total();
  run_until(*simulation, 40.0);
  EXPECT_EQ(simulation->steps(), 80);
  EXPECT_NEAR(simulation->energies().total(), start, 1e-9 * start);
}

/// Against velocity Verlet with its short steps, from rest and under a load that grows smoothly, so that no fast modes are excited.
TEST(Implicit, IsOfSecondOrder) {
  const std::string load = "[[boundary]]\nregion = \"tip\"\nforce = [0, \"-0.2*(1 - cos(0.6*t))\"]\n";
  for (const char* material : {"linear_elastic", "neo_hookean"}) {
    const auto tip = [&](const std::string& solver) { return tip_of(beam(material, load + solver, 0.0), 6.0); };
    const double exact = tip("[solver]\nend_time = 6\ncfl = 0.05\n");
    for (const char* method : {"newmark", "hht_alpha"}) {
      std::vector<double> errors;
      for (const char* step : {"0.4", "0.2", "0.1"})
        errors.push_back(std::abs(tip(std::string("[solver]\nmode = \"implicit\"\nintegrator = \"") + method +
                                      "\"\ntime_step = " + step + "\nend_time = 6\n") -
                                  exact));
      EXPECT_GT(errors[0] / errors[1], 3.2) << material << ", " << method;
      EXPECT_GT(errors[1] / errors[2], 3.2) << material << ", " << method;
      EXPECT_LT(errors[2], 0.02 * std::abs(exact)) << material << ", " << method;
    }
  }
}

/// Kinetic energy beyond the first mode, in which the beam starts badly.
TEST(Implicit, HilberHughesTaylorDampsWhatIsTooFastAndLittleElse) {
  const auto energy = [](double damping, double step) {
    const auto simulation = simulation_of(
        beam("linear_elastic", "[solver]\nmode = \"implicit\"\nintegrator = \"hht_alpha\"\nnumerical_damping = " +
                                   std::to_string(damping) + "\ntime_step = " + std::to_string(step) + "\nend_time = 50\n"));
    const double start = simulation->energies().total();
    run_until(*simulation, 50.0);
    return simulation->energies().total() / start;
  };
  EXPECT_NEAR(energy(0.0, 0.5), 1.0, 1e-6);
  EXPECT_LT(energy(0.3, 0.5), 0.9999);
  EXPECT_GT(energy(0.3, 0.5), 0.9);   // the first mode, 40 steps a period, is there
  EXPECT_LT(energy(0.3, 10.0), 0.7);  // two steps a period: it is not
}

TEST(Implicit, DampingTakesWhatItSaysItTakes) {
  const auto simulation =
      simulation_of(beam("neo_hookean", "[solver]\nmode = \"implicit\"\ntime_step = 0.02\nend_time = 10\ndamping = 0.1\n", 0.05));
  run_until(*simulation, 10.0);
  const Energies e = simulation->energies();
  EXPECT_GT(e.dissipated, 0.3 * e.initial);
  EXPECT_LT(std::abs(e.balance_error()), 5e-3 * e.initial);
}

TEST(Implicit, StepsFollowTheErrorThatIsAllowed) {
  const auto steps = [](const char* error) {
    const auto simulation = simulation_of(
        beam("linear_elastic", std::string("[solver]\nmode = \"implicit\"\ntime_step = 0.01\nlongest_step = 5\nstep_error = ") +
                                   error + "\nend_time = 20\n"));
    run_until(*simulation, 20.0);
    return static_cast<double>(simulation->steps());
  };
  const double few = steps("1e-2"), many = steps("1e-5");
  EXPECT_LT(few, 200.0);
  EXPECT_GT(many / few, 4.0);
  EXPECT_LT(many / few, 16.0);
}

/// A restart goes on with the same bits, in both modes; so does another number of threads.
TEST(Implicit, ARestartLeavesNoTrace) {
  for (const std::string solver :
       {"[solver]\nmode = \"implicit\"\nintegrator = \"hht_alpha\"\ntime_step = 0.3\nlongest_step = 1\nend_time = 6\n",
        "[solver]\nmode = \"static\"\ntime_step = 1\nlongest_step = 3\nend_time = 6\n"}) {
    const std::string text = beam("neo_hookean", "[[boundary]]\nregion = \"tip\"\nforce = [0, -0.3]\n" + solver, 0.05);
    const auto whole = simulation_of(text), first = simulation_of(text), second = simulation_of(text);
    run_until(*whole, 6.0);
    run_steps(*first, 3);
    second->restore(first->save());
    EXPECT_EQ(second->stable_time_step(), first->stable_time_step());
    run_until(*second, 6.0);
    EXPECT_EQ(second->state_hash(), whole->state_hash()) << solver;
    EXPECT_EQ(second->energies().external_work, whole->energies().external_work);
  }
}

/// Preload and release: an explicit stage goes on from a static one. Under the same load nothing moves; without it the beam swings with the energy that the load has put in.
TEST(Implicit, AnExplicitStageGoesOnFromBalance) {
  const auto run = [](const std::string& load) {
    std::string text = beam("neo_hookean", "", 0.0);
    text +=
        "[[stage]]\nname = \"load\"\nduration = 1\nsolver = { mode = \"static\", time_step = 0.25, tolerance = 1e-11 }\n"
        "boundary = [{ region = \"left\", displacement = [0, 0] }, { region = \"tip\", force = [0, \"-0.3*t\"] }]\n"
        "[[stage]]\nname = \"after\"\nduration = 3\nsolver = { mode = \"explicit\" }\n"
        "boundary = [{ region = \"left\", displacement = [0, 0] }, { region = \"tip\", force = [0, " +
        load + "] }]\n";
    auto simulation = simulation_of(text);
    run_until(*simulation, 4.0);
    return simulation;
  };
  const Energies still = run("-0.3")->energies(), swings = run("0")->energies();
  EXPECT_GT(still.strain, 0.01);
  EXPECT_LT(still.kinetic, 1e-12 * still.strain);
  EXPECT_GT(swings.kinetic, 0.01 * still.strain);
  EXPECT_NEAR(swings.total(), still.total(), 1e-4 * still.total());
}

/// A cloud with a pressure on the particles of its right face.
template <int D>
struct Pressed {
  Cloud<D> cloud = make_cloud<D>(D == 3 ? 4 : 7, 0.2, 2.3, true, 1, 6);
  TotalLagrangian<D> solid{cloud.particles, cloud.radius, options<D>(material_with<NeoHookean>(1.3, 2.0, 0.3))};
  Loads<D> loads;

  Pressed() {
    FollowerCondition<D> follower;
    follower.pressure = {[](const Point&, const Point&, double t) { return 0.7 * t; }, false, "pressure"};
    for (int slot : cloud.particles.slot_of)
      if (cloud.particles.position.at(0, slot) > (D == 3 ? 4.5 : 7.5)) {
        Vec<double, D> N{};
        N[0] = 1.2, N[1] = 0.1;
        follower.surfaces.push_back({solid.stencil_of(cloud.particles, slot), N});
      }
    EXPECT_GT(follower.surfaces.size(), 3U);
    loads = Loads<D>({}, {std::move(follower)}, cloud.particles);
  }
  VectorField<D> forces() {
    VectorField<D> f(cloud.particles.slots);
    loads.add(cloud.particles, 1.0, f);
    return f;
  }
};

template <int D>
void check_follower() {
  Pressed<D> body;
  Particles<D>& particles = body.cloud.particles;
  const VectorField<D> at_rest = body.forces();
  Mat<double, D> R = Mat<double, D>::identity();
  R[0][0] = R[1][1] = std::cos(0.8), R[0][1] = -std::sin(0.8), R[1][0] = std::sin(0.8);
  displace<D>(particles, R, 0.0);
  const VectorField<D> turned = body.forces();
  for (int slot : particles.slot_of)
    for (int c = 0; c < D; ++c) EXPECT_NEAR(turned.at(c, slot), (R * at_rest[slot])[c], 1e-13);

  Mat<double, D> A = Mat<double, D>::identity();
  A[0][1] = 0.2, A[1][1] = 1.3;
  displace<D>(particles, A, 0.1);
  VectorField<D> direction(particles.slots), change(particles.slots), assembled(particles.slots);
  for (int slot : particles.slot_of)
    for (int c = 0; c < D; ++c) direction.at(c, slot) = std::sin(3.1 * slot + 1.7 * c);
  body.loads.add_change(particles, direction, 1.0, change);
  body.loads.for_each_stiffness(particles, 1.0, [&](std::span<const int> slots, std::span<const double> K) {
    const std::size_t size = D * slots.size();
    for (std::size_t r = 0; r < size; ++r)
      for (std::size_t c = 0; c < size; ++c)
        assembled.at(r % D, slots[r / D]) -= K[r * size + c] * direction.at(c % D, slots[c / D]);
  });
  const VectorField<D> start = particles.displacement;
  constexpr double h = 1e-6;
  VectorField<D> ends[2];
  for (const int side : {0, 1}) {
    for (int slot : particles.slot_of) particles.displacement.set(slot, start[slot] + (side ? h : -h) * direction[slot]);
    ends[side] = body.forces();
  }
  for (int slot : particles.slot_of)
    for (int c = 0; c < D; ++c) {
      EXPECT_NEAR((ends[1].at(c, slot) - ends[0].at(c, slot)) / (2.0 * h), change.at(c, slot), 1e-8);
      EXPECT_NEAR(assembled.at(c, slot), change.at(c, slot), 1e-13);
    }
}

TEST(FollowerPressure, TurnsWithTheSurfaceAndHasTheDerivativeOfDifferences) {
  check_follower<2>();
  check_follower<3>();
}

/// A strip that a pressure bends: with a dead load its tip goes down for ever, with one that follows it curls up; Newton converges either way, and the books close.
TEST(FollowerPressure, BendsAStripFartherThanADeadLoad) {
  const auto run = [](const std::string& follower) {
    const auto simulation = simulation_of(
        "[case]\ndimension = 2\n[[body]]\nname = \"strip\"\nmaterial = { model = \"neo_hookean\", density = 1, youngs_modulus = "
        "100, poissons_ratio = 0.3 }\n"
        "geometry = { shape = \"box\", low = [0, 0], high = [8, 1], spacing = 0.25 }\n"
        "[[boundary]]\nregion = { where = \"X < 0.25\" }\ndisplacement = [0, 0]\n"
        "[[boundary]]\nregion = { where = \"Y > 0.75\" }\npressure = 0.12\nnormal = [0, 1]\n" +
        follower +
        "[[probe]]\nname = \"tip\"\nquantity = \"displacement\"\ncomponent = \"x\"\nregion = { nearest = [8, 0.5] }\n"
        "[solver]\nmode = \"static\"\ntime_step = 0.05\n");
    run_until(*simulation, 1.0);
    const Energies e = simulation->energies();
    EXPECT_LT(std::abs(e.balance_error()), 2e-3 * e.external_work) << follower;
    return simulation->probe_values()[0];
  };
  const double dead = run(""), following = run("follower = true\n");
  EXPECT_LT(dead, -1.0);
  EXPECT_LT(following, 1.2 * dead);
}

}  // namespace
}  // namespace sinew
