/// Artificial viscosity: against a sum over all pairs, conservation, energy, and that it only acts on what comes together.

#include <gtest/gtest.h>

#include <cmath>

#include "clouds.hpp"
#include "run_case.hpp"

namespace sinew {
namespace {

using namespace sinew::testing;

template <int D>
TotalLagrangianOptions viscous(bool lattice, WeightStorage weights = WeightStorage::stored) {
  TotalLagrangianOptions o = options<D>(material_with<NeoHookean>(1.3, 2.0, 0.4));
  o.hourglass.reset();
  o.lattice = lattice;
  o.weights = weights;
  o.viscosity = ArtificialViscosity{1.5, 0.7};
  return o;
}

template <int D>
void set_velocities(Particles<D>& particles) {
  for (int slot : particles.slot_of) {
    const Vec<double, D> X = particles.position[slot];
    Vec<double, D> v;
    for (int c = 0; c < D; ++c) v[c] = 0.3 * std::sin(0.9 * X[(c + 1) % D] + c) - 0.1 * X[c];
    particles.velocity.set(slot, v);
  }
}

template <int D>
VectorField<D> forces_with(Cloud<D>& cloud, const TotalLagrangianOptions& o, ForceSummary& summary) {
  TotalLagrangian<D> solid(cloud.particles, cloud.radius, o);
  VectorField<D> forces(cloud.particles.slots);
  summary = solid.internal_forces(cloud.particles, forces);
  return forces;
}

/// The formula, pair by pair, with gradients that are corrected to be exact for linear fields.
template <int D>
std::vector<Vec<double, D>> slow_viscous_forces(const Particles<D>& p, double R, double E, double rho,
                                                const ArtificialViscosity& law) {
  const std::size_t n = p.slot_of.size();
  std::vector<Mat<double, D>> L(n), F(n);
  const auto weight = [&](std::size_t i, std::size_t j) {  // V_j |dW/dr| / r
    const double r = norm(p.position[p.slot_of[j]] - p.position[p.slot_of[i]]);
    return r < R && i != j ? -p.volume[p.slot_of[j]] * Spiky::slope<D>(r, R) / r : 0.0;
  };
  for (std::size_t i = 0; i < n; ++i) {
    Mat<double, D> moments, S;
    for (std::size_t j = 0; j < n; ++j) {
      const Vec<double, D> X = p.position[p.slot_of[j]] - p.position[p.slot_of[i]];
      const Vec<double, D> x = X + p.displacement[p.slot_of[j]] - p.displacement[p.slot_of[i]];
      moments += weight(i, j) * outer(X, X);
      S += weight(i, j) * outer(x, X);
    }
    L[i] = inverse(moments);
    F[i] = S * L[i];
  }
  std::vector<Vec<double, D>> forces(n);
  const double c = std::sqrt(E / rho), h = 0.5 * R;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      if (weight(i, j) == 0.0) continue;
      const int si = p.slot_of[i], sj = p.slot_of[j];
      const Vec<double, D> X = p.position[sj] - p.position[si], x = X + p.displacement[sj] - p.displacement[si],
                           v = p.velocity[sj] - p.velocity[si];
      const double mu = std::min(0.0, h * dot(v, x) / (dot(x, x) + 0.01 * h * h)), J = determinant(F[i]);
      const double pi = (-law.alpha * c * mu + law.beta * mu * mu) / (rho / J);
      const double mi = rho * p.volume[si];
      const Vec<double, D> g = L[i] * (weight(i, j) * X);  // with V_j, so m_j is rho times it
      const Vec<double, D> half = (-0.5 * mi * rho * pi * J) * (transpose(inverse(F[i])) * g);
      if (dot(half, v) < 0.0) continue;  // it would give energy
      forces[i] += half;
      forces[j] -= half;
    }
  return forces;
}

/// Largest rate at which viscosity damps, by power iteration about a motion in which all pairs come together, over the squared rate that it asks of the time step:
/// cfl = 0.3 then makes steps of at most 0.75 over it (2 is the limit of stability), and not far less.
template <int D>
double largest_damping_over_rate() {
  Cloud<D> cloud = make_cloud<D>(D == 3 ? 5 : 9, 0.2, 2.41, false, 1, 6);
  TotalLagrangianOptions o = viscous<D>(false);
  o.viscosity = ArtificialViscosity{200.0, 0.0};
  TotalLagrangian<D> solid(cloud.particles, cloud.radius, o);
  const auto set_motion = [&](const VectorField<D>* more) {
    for (int slot : cloud.particles.slot_of) {
      Vec<double, D> v = -cloud.particles.position[slot];
      if (more) v += 1e-3 * (*more)[slot];
      cloud.particles.velocity.set(slot, v);
    }
  };
  const auto forces_now = [&](ForceSummary& summary) {
    VectorField<D> forces(cloud.particles.slots);
    summary = solid.internal_forces(cloud.particles, forces);
    return forces;
  };
  ForceSummary summary;
  set_motion(nullptr);
  const VectorField<D> base = forces_now(summary);
  const double rate = std::sqrt(summary.largest_rate2);
  VectorField<D> w(cloud.particles.slots);
  for (int slot : cloud.particles.slot_of) w.set(slot, {{std::sin(3.0 * slot), std::cos(5.0 * slot)}});
  double damping = 0.0;
  for (int round = 0; round < 300; ++round) {
    set_motion(&w);
    const VectorField<D> forces = forces_now(summary);
    double size2 = 0.0;
    for (int slot : cloud.particles.slot_of) {
      w.set(slot, (-1e3 / cloud.particles.mass[slot]) * (forces[slot] - base[slot]));
      size2 += dot(w[slot], w[slot]);
    }
    damping = std::sqrt(size2);
    for (int slot : cloud.particles.slot_of) w.set(slot, (1.0 / damping) * w[slot]);
  }
  return 0.3 * damping / rate;
}
TEST(Viscosity, LimitsTheTimeStepByItsDamping) {
  for (const double steps : {largest_damping_over_rate<2>(), largest_damping_over_rate<3>()}) {
    EXPECT_LT(steps, 0.75);
    EXPECT_GT(steps, 0.15);
  }
}

template <int D>
void compare(double jitter) {
  const BlockSize small(100);
  Cloud<D> cloud = make_cloud<D>(D == 3 ? 6 : 13, jitter, 2.41, false, 1, 4);
  Mat<double, D> A = Mat<double, D>::identity();
  A[0][0] = 0.9, A[0][1] = 0.2, A[1][0] = -0.1;
  displace<D>(cloud.particles, A, 0.05);
  set_velocities(cloud.particles);
  ForceSummary with, without;
  for (const bool lattice : {true, false})
    for (const WeightStorage weights : {WeightStorage::stored, WeightStorage::computed}) {
      TotalLagrangianOptions o = viscous<D>(lattice, weights);
      const VectorField<D> total = forces_with(cloud, o, with);
      o.viscosity.reset();
      const VectorField<D> elastic = forces_with(cloud, o, without);
      const auto expected = slow_viscous_forces<D>(cloud.particles, cloud.radius[0], 2.0, 1.3, {1.5, 0.7});
      double worst = 0.0, largest = 0.0, power = 0.0;
      for (std::size_t i = 0; i < expected.size(); ++i) {
        const int slot = cloud.particles.slot_of[i];
        const Vec<double, D> force = total[slot] - elastic[slot];
        worst = std::max(worst, norm(force - expected[i]));
        largest = std::max(largest, norm(expected[i]));
        power -= dot(force, cloud.particles.velocity[slot]);
      }
      EXPECT_GT(largest, 0.01);
      EXPECT_LT(worst, 1e-12 * largest) << D << "D, jitter " << jitter;
      EXPECT_NEAR(with.viscous_power, power, 1e-11 * power);
      EXPECT_GT(power, 0.0);
      EXPECT_GT(with.largest_rate2, without.largest_rate2) << "a smaller time step";
    }
}

TEST(Viscosity, IsTheSumOverAllPairs) {
  for (const double jitter : {0.0, 0.2}) {
    compare<2>(jitter);
    compare<3>(jitter);
  }
}

/// Moving, turning or growing apart is not resisted.
TEST(Viscosity, ActsOnlyOnWhatComesTogether) {
  Cloud<2> cloud = make_cloud<2>(12, 0.2, 2.41, false, 1, 4);
  for (const double growth : {0.0, 0.3}) {
    for (int slot : cloud.particles.slot_of) {
      const Vec<double, 2> X = cloud.particles.position[slot];
      cloud.particles.velocity.set(slot, {{3.0 - 0.5 * X[1] + growth * X[0], -1.0 + 0.5 * X[0] + growth * X[1]}});
    }
    ForceSummary summary;
    const VectorField<2> forces = forces_with(cloud, viscous<2>(true), summary);
    for (int slot : cloud.particles.slot_of) EXPECT_LT(norm(forces[slot]), 1e-12);
  }
}

TEST(Viscosity, ConservesMomentumAndCountsItsEnergy) {
  const std::string on =
      "[formulation]\nstabilization = [{ model = \"hourglass_stiffness\" }, { model = \"artificial_viscosity\", alpha = 1.0, "
      "beta = 1.0 }]\n";
  for (int dimension : {2, 3}) {
    const auto simulation = simulation_of(free_block(dimension) + on), ideal = simulation_of(free_block(dimension));
    const Momenta before = simulation->momenta();
    run_until(*simulation, 0.1);
    run_until(*ideal, 0.1);
    const Momenta after = simulation->momenta();
    EXPECT_LT(norm(after.linear - before.linear), 1e-12 * before.linear_scale);
    const Energies e = simulation->energies();
    EXPECT_GT(e.dissipated, 0.005 * e.initial);
    EXPECT_LT(std::abs(e.balance_error()), 5e-3 * e.initial);
    EXPECT_LT(e.total(), ideal->energies().total());
  }
}

/// A bar that hits a stiff wall rings less.
TEST(Viscosity, TakesTheRingingAway) {
  const auto ringing = [](const std::string& stabilization) {
    const auto simulation = simulation_of(
        "[case]\ndimension = 2\n[[body]]\nname = \"bar\"\ngeometry = { shape = \"box\", low = [0, 0], high = [0.2, 4], spacing = "
        "0.1 }\n"
        "material = { model = \"st_venant_kirchhoff\", youngs_modulus = 1e4, poissons_ratio = 0, density = 1 }\n"
        "[[initial]]\nregion = \"bar\"\nvelocity = [0, -0.3]\n[[wall]]\nname = \"anvil\"\nstiffness = 1e6\n"
        "geometry = { shape = \"plane\", point = [0, 0], normal = [0, 1] }\n[solver]\nend_time = 1\n"
        "[[probe]]\nname = \"stress\"\nquantity = \"cauchy_stress\"\ncomponent = \"yy\"\nregion = { nearest = [0.05, 1] }\n"
        "[formulation]\nstabilization = " +
        stabilization + "\n");
    double least = 0.0;
    while (simulation->time() < 0.03) {
      simulation->step(1e300);
      least = std::min(least, simulation->probe_values()[0]);
    }
    return -least / (100.0 * 0.3) - 1.0;  // overshoot over rho c v
  };
  EXPECT_GT(ringing("[{ model = \"hourglass_stiffness\" }]"), 0.2);
  EXPECT_LT(ringing("[{ model = \"hourglass_stiffness\" }, { model = \"artificial_viscosity\", alpha = 1, beta = 1 }]"), 0.08);
}

TEST(Viscosity, IsStableAtThePublishedCoefficients) {
  const std::string on =
      "[formulation]\nstabilization = [{ model = \"hourglass_stiffness\" }, { model = \"artificial_viscosity\" }]\n";
  for (int dimension : {2, 3}) {
    const auto simulation = simulation_of(free_block(dimension) + on);
    run_until(*simulation, 0.3);
    const Energies e = simulation->energies();
    EXPECT_LT(e.total(), e.initial);
    EXPECT_LT(std::abs(e.balance_error()), 1e-2 * e.initial);
  }
}

}  // namespace
}  // namespace sinew
