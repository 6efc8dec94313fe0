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

/// A lattice with velocities, and the force of JST dissipation on them.
template <int D>
struct Damped {
  Cloud<D> cloud;
  TotalLagrangian<D> solid;
  VectorField<D> forces;
  ForceSummary summary;

  Damped(double jitter, const JstDissipation& jst, const std::function<Vec<double, D>(const Vec<double, D>&)>& velocity)
      : cloud(make_cloud<D>(D == 3 ? 9 : 13, jitter, 2.4, false, 1, 5)),
        solid(cloud.particles, cloud.radius, options_with(jst)),
        forces(cloud.particles.slots) {
    for (int slot : cloud.particles.slot_of) cloud.particles.velocity.set(slot, velocity(cloud.particles.position[slot]));
    evaluate();
  }
  void evaluate() {
    forces.clear();
    summary = solid.internal_forces(cloud.particles, forces);
  }
  static TotalLagrangianOptions options_with(const JstDissipation& jst) {
    TotalLagrangianOptions o = options<D>(material_with<NeoHookean>(1.3, 2.0, 0.4), 1, CubicSpline{});
    o.hourglass.reset();
    o.jst = jst;
    return o;
  }
};

JstDissipation plain(double eta2, double eta4) {
  JstDissipation jst{eta2, eta4};
  jst.laplacian.value = "plain";
  return jst;
}

constexpr double c_of_rubber = 1.8156825980064073;  // sqrt((lambda + 2 mu) / rho) for E = 2, nu = 0.4, rho = 1.3

/// In the middle of a lattice, eta2 c h lap |X|^2 = eta2 c h 2 D, and eta4 c h^3 lap lap of it = 0.
template <int D>
void check_laplacian() {
  const auto square = [](const Vec<double, D>& X) {
    Vec<double, D> v{};
    v[0] = dot(X, X);
    return v;
  };
  const Damped<D> harmonic(0.0, plain(0.3, 0.0), square), both(0.0, plain(0.3, 0.2), square);
  const double h = 1.2;
  Vec<double, D> middle{};
  middle[0] = (D == 3 ? 10.0 : 14.0) / 2.0;
  for (int c = 1; c < D; ++c) middle[c] = (D == 3 ? 8.0 : 12.0) / 2.0;
  int found = 0;
  for (int slot : harmonic.cloud.particles.slot_of) {
    if (norm(harmonic.cloud.particles.position[slot] - middle) > 0.1) continue;
    ++found;
    EXPECT_NEAR(harmonic.forces.at(0, slot), 1.3 * 0.3 * c_of_rubber * h * 2.0 * D, 1e-12);
    EXPECT_NEAR(both.forces.at(0, slot), harmonic.forces.at(0, slot), 1e-10);
    EXPECT_NEAR(harmonic.forces.at(1, slot), 0.0, 1e-14);
  }
  EXPECT_EQ(found, 1);
}

TEST(Jst, LaplacianInALattice) {
  check_laplacian<2>();
  check_laplacian<3>();
}

/// A wave cos(k X): the biharmonic term is eta4 c h^3 s^2 with s the eigenvalue of the harmonic one.
TEST(Jst, BiharmonicIsTheLaplacianTwice) {
  const double k = 1.1;
  const auto wave = [k](const Vec<double, 2>& X) { return Vec<double, 2>{{std::cos(k * (X[0] - 7.0)), 0.0}}; };
  const Damped<2> harmonic(0.0, plain(0.3, 0.0), wave), biharmonic(0.0, plain(0.0, 0.2), wave);
  for (int slot : harmonic.cloud.particles.slot_of) {
    if (norm(harmonic.cloud.particles.position[slot] - Vec<double, 2>{{7.0, 6.0}}) > 0.1) continue;
    const double s = harmonic.forces.at(0, slot) / (1.3 * 0.3 * c_of_rubber * 1.2);
    EXPECT_LT(s, 0.0);
    EXPECT_NEAR(biharmonic.forces.at(0, slot), -1.3 * 0.2 * c_of_rubber * 1.2 * 1.2 * 1.2 * s * s, 1e-12);
  }
}

/// On uneven particles, rigid translation is left alone, and the power is that of the forces and never negative.
TEST(Jst, TakesEnergyFromDifferencesOnly) {
  const Damped<2> rigid(0.3, {0.3, 0.2}, [](const auto&) { return Vec<double, 2>{{3.0, -1.0}}; });
  EXPECT_NEAR(rigid.summary.viscous_power, 0.0, 1e-12);
  for (const JstDissipation& jst : {plain(0.3, 0.0), plain(0.0, 0.2), JstDissipation{0.3, 0.0}, JstDissipation{0.0, 0.2}}) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    const Damped<2> noisy(0.3, jst, [&](const auto&) { return Vec<double, 2>{{any(random), any(random)}}; });
    double power = 0.0;
    for (int slot : noisy.cloud.particles.slot_of) power -= dot(noisy.forces[slot], noisy.cloud.particles.velocity[slot]);
    EXPECT_GT(power, 0.0);
    EXPECT_NEAR(noisy.summary.viscous_power, power, 1e-12 * power);
  }
}

/// Linear fields of velocities, rotations above all, are left alone by the corrected one, up to surfaces and on uneven particles; by the plain one they are not.
TEST(Jst, CorrectedLaplacianOfLinearFields) {
  const auto turn = [](const Vec<double, 3>& X) { return Vec<double, 3>{{-X[1] + 0.3 * X[2], X[0], 0.7 * X[1] - 0.2 * X[2]}}; };
  double largest[2] = {0.0, 0.0};
  for (const JstDissipation& jst : {JstDissipation{0.3, 0.2}, plain(0.3, 0.2)}) {
    const Damped<3> turning(0.3, jst, turn);
    double& most = largest[jst.corrected() ? 0 : 1];
    for (int slot : turning.cloud.particles.slot_of) most = std::max(most, norm(turning.forces[slot]));
  }
  EXPECT_LT(largest[0], 1e-11 * largest[1]);
  EXPECT_GT(largest[1], 0.1);
}

/// The mean of the exact gradients of both ends explains differences of quadratic fields exactly.
TEST(Jst, CorrectedLaplacianLeavesQuadraticFieldsInside) {
  const Damped<2> quadratic(0.0, {0.3, 0.2}, [](const auto& X) { return Vec<double, 2>{{dot(X, X), X[0] * X[1]}}; });
  for (int slot : quadratic.cloud.particles.slot_of)
    if (norm(quadratic.cloud.particles.position[slot] - Vec<double, 2>{{7.0, 6.0}}) < 0.1) {
      EXPECT_NEAR(norm(quadratic.forces[slot]), 0.0, 1e-11);
    }
}

/// The bound of the fastest damping is one, and not a loose one: power iteration.
TEST(Jst, FastestDamping) {
  for (const JstDissipation& jst : {plain(0.3, 0.0), plain(0.0, 0.2), JstDissipation{0.3, 0.0}, JstDissipation{0.0, 0.2}}) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    Damped<2> noisy(0.2, jst, [&](const auto&) { return Vec<double, 2>{{any(random), any(random)}}; });
    double rate = 0.0;
    for (int k = 0; k < 300; ++k) {
      double before = 0.0, after = 0.0;
      for (int slot : noisy.cloud.particles.slot_of) {
        const Vec<double, 2> a = (1.0 / noisy.cloud.particles.mass[slot]) * noisy.forces[slot];
        before += dot(noisy.cloud.particles.velocity[slot], noisy.cloud.particles.velocity[slot]);
        after += dot(a, a);
        noisy.cloud.particles.velocity.set(slot, (-1.0 / std::max(rate, 1.0)) * a);
      }
      rate = std::sqrt(after / before);
      noisy.evaluate();
    }
    EXPECT_GT(noisy.solid.dissipation_rate(), rate);
    EXPECT_LT(noisy.solid.dissipation_rate(), (jst.eta4 > 0.0 ? 4.0 : 2.0) * rate);
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
