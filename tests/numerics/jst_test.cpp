/// JST dissipation at one instant: against closed forms, slow sums, and what it must leave alone.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "clouds.hpp"

namespace sinew {
namespace {

using namespace sinew::testing;

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

/// With the least-squares gradient, what the corrected harmonic term takes is 1/2 sum V_i w_ij |v_ij - G_i X_ij|^2, here by the slow sum over all pairs.
template <int D>
void check_power_of_squares() {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  const Damped<D> noisy(0.3, {0.3, 0.0}, [&](const auto&) {
    Vec<double, D> v;
    for (int c = 0; c < D; ++c) v[c] = any(random);
    return v;
  });
  const Particles<D>& p = noisy.cloud.particles;
  double squares = 0.0, most_trace = 0.0;
  for (int i : p.slot_of) {
    Mat<double, D> moment, moved;
    const auto for_each_neighbor = [&](auto&& use) {
      for (int j : p.slot_of) {
        const Vec<double, D> X = p.position[j] - p.position[i];
        const double r = norm(X);
        if (j != i && r < 2.4) use(-p.volume[j] * CubicSpline::slope<D>(r, 2.4) / r, p.velocity[j] - p.velocity[i], X);
      }
    };
    for_each_neighbor([&](double a, const Vec<double, D>& v, const Vec<double, D>& X) {
      moment += outer(a * X, X);
      moved += outer(a * v, X);
    });
    most_trace = std::max(most_trace, trace(moment));
    const Mat<double, D> G = moved * inverse(moment);
    for_each_neighbor([&](double a, const Vec<double, D>& v, const Vec<double, D>& X) {
      squares += p.volume[i] * a * dot(v - G * X, v - G * X);
    });
  }
  const double expected = 1.3 * 0.3 * c_of_rubber * 1.2 * 0.5 * (2.0 * D / most_trace) * squares;
  EXPECT_NEAR(noisy.summary.viscous_power, expected, 1e-12 * expected);
}

TEST(Jst, PowerIsASumOfSquares) {
  check_power_of_squares<2>();
  check_power_of_squares<3>();
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

}  // namespace
}  // namespace sinew
