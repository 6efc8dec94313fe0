#include <unit/physics/plastic_support.hpp>

namespace sinew {
namespace {

using namespace testing_support;
using Elastic = RateForm<ElasticRate>;
using Soil = RateForm<DruckerPrager>;
using Grains = RateForm<MuIRheology>;
using M3 = Mat3<double>;
using History = RateHistory<M3>;

template <class Material>
Material with_bulk_and_shear(double K, double G) {
  Material m = with_lame<Material>(K - 2.0 / 3.0 * G, G);
  return m;
}

/// Of the reference numbers: K = 5 MPa, phi = 25 degrees, c = 5 kPa.
Soil soil(double dilatancy = 0.0) {
  Soil m = with_bulk_and_shear<Soil>(5e6, 2.30769e6);
  m.law.friction_angle = 25.0;
  m.law.cohesion = 5e3;
  m.law.dilatancy_angle = dilatancy;
  return m;
}

TEST(RateForm, FrictionAndStrengthOfDruckerPrager) {
  EXPECT_NEAR(DruckerPrager::slope(25.0), 0.4105731305, 1e-10);
  EXPECT_NEAR(soil().law.strength(), 4402.38, 0.01);
  EXPECT_NEAR(-soil().law.least_pressure(), 10722.5, 0.05);
  EXPECT_NEAR(DruckerPrager::slope(30.0), 0.4803844615, 1e-10);
}

/// Returns of two trial stresses, computed independently of this code.
TEST(RateForm, ReturnsToTheConeAsComputedElsewhere) {
  const M3 first{{{-3e4, 8e3, 0}, {8e3, -1e4, 0}, {0, 0, -1.5e4}}}, second{{{-3e4, 3e4, 0}, {3e4, -1e4, 0}, {0, 0, -1.5e4}}};
  const Soil even = soil(), dilating = soil(5.0);
  const M3 a{{{-28935.3021461484, 7269.9214716446, 0}, {7269.9214716446, -10760.4984670369, 0}, {0, 0, -15304.1993868148}}};
  const M3 b{{{-26709.9872648641, 12616.5728733988, 0}, {12616.5728733988, -18298.9386825982, 0}, {0, 0, -20401.7008281647}}};
  EXPECT_LT(distance(even.law.flow(first, even.elastic, 0.0).stress, a), 1e-6);
  const Flowed<M3> flowed = dilating.law.flow(second, dilating.elastic, 0.0);
  EXPECT_LT(distance(flowed.stress, b), 1e-6);
  EXPECT_NEAR(flowed.strain, 0.00461500554, 1e-10);
}

M3 random_symmetric(std::mt19937_64& random, double size) {
  std::uniform_real_distribution<double> part(-size, size);
  M3 a;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) a[i][j] = a[j][i] = part(random);
  return a;
}

/// No stress is left outside, and what flows takes work.
TEST(RateForm, DruckerPragerEndsInsideOfTheCone) {
  std::mt19937_64 random(6);
  int flowed = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    Soil m = soil(trial % 3 == 0 ? 0.0 : trial % 3 == 1 ? 8.0 : 25.0);
    if (trial % 5 == 0) m.law.tensile_strength = 1e3;
    const M3 stress = random_symmetric(random, 4e4);
    const Flowed<M3> result = m.law.flow(stress, m.elastic, 0.0);
    const StressInvariants<M3> at(result.stress);
    const double k_phi = DruckerPrager::slope(25.0), k_c = m.law.strength();
    EXPECT_LE(at.shear - k_phi * at.pressure - k_c, 1e-10 * k_c);
    EXPECT_GE(at.pressure, m.law.least_pressure() * (1.0 + 1e-12));
    EXPECT_GE(result.work, -1e-9);
    flowed += result.strain > 0.0;
    if (result.strain == 0.0) {
      EXPECT_LT(distance(result.stress, stress), 1e-10);
    }
  }
  EXPECT_GT(flowed, 1000);
}

/// Compressed and sheared to some state in which soil and grains have stress.
template <class Material>
History state_of(const Material& m, std::mt19937_64& random, M3& F) {
  History history;
  F = random_rotation(random);
  for (int step = 0; step < 5; ++step) {
    F = (0.9995 * M3::identity()) * (M3::identity() + 0.3 * (random_gradient(random, 1e-3) - M3::identity())) * F;
    respond(m, F, history, 1e-3);
  }
  return history;
}

Grains grains() {
  Grains m = with_bulk_and_shear<Grains>(5e6, 2.30769e6);
  m.law = {0.38, 0.64, 0.28, 1e-3, 2500.0};
  return m;
}

template <class Material>
void check_frame(const Material& m, double scale) {
  std::mt19937_64 random(7);
  for (int trial = 0; trial < 50; ++trial) {
    M3 F;
    const History old = state_of(m, random, F);
    const M3 Q = random_rotation(random), next = (M3::identity() + 1e-3 * random_symmetric(random, 1.0)) * F;
    History turned = old, straight = old;
    const M3 P = respond(m, next, straight, 1e-3).P;
    respond(m, Q * F, turned, 0.0);  // turning alone
    EXPECT_LT(distance(turned.stress, Q * old.stress * transpose(Q)), 1e-9 * scale);
    EXPECT_LT(std::abs(turned.strain - old.strain), 1e-12);
    EXPECT_LT(distance(respond(m, Q * next, turned, 1e-3).P, Q * P), 1e-9 * scale);
    EXPECT_LT(distance(P * transpose(next), next * transpose(P)), 1e-9 * scale);
  }
}
TEST(RateForm, StressTurnsWithTheBody) {
  check_frame(with_bulk_and_shear<Elastic>(5e6, 2e6), 5e6);
  check_frame(soil(), 5e6);
  check_frame(grains(), 5e6);
}

template <class Material>
void check_tangent(const Material& m) {
  std::mt19937_64 random(9);
  for (int trial = 0; trial < 20; ++trial) {
    M3 F;
    const History old = state_of(m, random, F);
    F = (M3::identity() + 1e-4 * random_symmetric(random, 1.0)) * F;
    const Tangent<double> A = tangent(m, F, old, 1e-3);
    constexpr double step = 1e-8;
    for (int column = 0; column < 9; ++column) {
      M3 up = F, down = F;
      up[column / 3][column % 3] += step;
      down[column / 3][column % 3] -= step;
      History a = old, b = old;
      const M3 difference = (0.5 / step) * (respond(m, up, a, 1e-3).P - respond(m, down, b, 1e-3).P);
      for (int row = 0; row < 9; ++row) EXPECT_NEAR(A[row][column], difference[row / 3][row % 3], 20.0) << "of some 5e6";
    }
  }
}
TEST(RateForm, TangentIsTheDerivativeOfTheStress) {
  check_tangent(with_bulk_and_shear<Elastic>(5e6, 2e6));
  check_tangent(soil(5.0));
  check_tangent(grains());
}

TEST(RateForm, ObeysHookesLawAtSmallStrain) {
  const Elastic m = with_bulk_and_shear<Elastic>(2.0, 0.8);
  const LinearElastic hooke = with_lame<LinearElastic>(2.0 - 1.6 / 3.0, 0.8);
  const M3 I = M3::identity(), F = I + 1e-6 * M3{{{1, 2, -1}, {0.5, -2, 1}, {0, 1, 3}}};
  History history;
  EXPECT_LT(distance(respond(m, F, history, 0.0).P, hooke.respond(F).P), 1e-10);
}

/// Simple shear g with the Jaumann rate: sigma_12 = G sin g, sigma_11 = G (1 - cos g) = -sigma_22. Dienes (1979).
TEST(RateForm, SimpleShearOscillatesAsItMust) {
  const Elastic m = with_bulk_and_shear<Elastic>(2.0, 0.8);
  const auto error_with = [&](int steps) {
    History history;
    const double g = 3.0;
    for (int k = 1; k <= steps; ++k) {
      M3 F = M3::identity();
      F[0][1] = g * k / steps;
      respond(m, F, history, 0.0);
    }
    return std::abs(history.stress[0][1] - 0.8 * std::sin(g)) + std::abs(history.stress[0][0] - 0.8 * (1.0 - std::cos(g)));
  };
  EXPECT_LT(error_with(400), 1e-4);
  EXPECT_NEAR(error_with(100) / error_with(200), 4.0, 0.2);
}

/// What the shape of F is forgotten after each step changes no stress.
TEST(RateForm, ShapeMayBeForgotten) {
  const Soil m = soil();
  std::mt19937_64 random(4);
  History whole, forgetful;
  M3 F = M3::identity(), rest = F;
  for (int step = 0; step < 300; ++step) {
    const M3 change = (0.99995 * M3::identity()) * (M3::identity() + 0.01 * (random_gradient(random, 0.1) - M3::identity()));
    F = change * F;
    respond(m, F, whole, 1e-3);
    respond(m, change * rest, forgetful, 1e-3);
    rest = m.forget_shape(change * rest, forgetful);
    EXPECT_LT(distance(forgetful.stress, whole.stress), 1e-4);
    EXPECT_NEAR(determinant(rest), determinant(F), 1e-10);
  }
  EXPECT_GT(whole.strain, 0.01);
  EXPECT_NEAR(forgetful.work, whole.work, 1e-6 * whole.work);
}

/// The work of the stress is stored, or dissipated by flow, to the order of the elastic strain.
TEST(RateForm, WorkIsStoredOrDissipated) {
  const Soil m = soil(3.0);
  History history;
  M3 F = M3::identity(), before;
  double done = 0.0, energy = 0.0;
  for (int step = 0; step < 2000; ++step) {
    const M3 P_before = m.recall(F, history).P;
    before = F;
    M3 change = M3::identity();
    change[0][1] = 2e-5;
    change[1][1] -= step < 500 ? 1e-5 : 0.0;
    F = change * F;
    const Response<M3> r = respond(m, F, history, 1e-3);
    done += double_dot(0.5 * (r.P + P_before), F - before);
    energy = r.energy;
  }
  EXPECT_GT(history.work, 0.3 * done);
  EXPECT_NEAR(energy + history.work, done, 0.01 * done);
}

/// Steady simple shear under constant pressure: the ratio of shear to pressure is mu(I).
TEST(RateForm, GrainsFlowWithTheirFriction) {
  const Grains m = grains();
  for (const double rate : {0.5, 20.0, 400.0}) {
    History history;
    M3 F = 0.9999 * M3::identity();
    respond(m, F, history, 1.0);
    const double dt = 1e-3 / rate;
    for (int step = 0; step < 2000; ++step) {
      M3 change = M3::identity();
      change[0][1] = rate * dt;
      F = change * F;
      respond(m, F, history, dt);
    }
    const StressInvariants<M3> at(history.stress);
    const double I = rate * 1e-3 / std::sqrt(at.pressure / 2500.0), friction = 0.38 + (0.64 - 0.38) / (0.28 / I + 1.0);
    EXPECT_NEAR(at.shear / at.pressure, friction, 1e-3 * friction) << rate;
  }
  History history;
  respond(m, 1.01 * M3::identity(), history, 1e-3);
  EXPECT_EQ(von_mises_of(history.stress), 0.0);
  EXPECT_NEAR(trace(history.stress), 0.0, 1e-9);
}

/// The plane matrix gives the same as three dimensions.
TEST(RateForm, PlaneStrainIsAPartOfSpace) {
  const Soil m = soil(2.0);
  std::mt19937_64 random(12);
  RateHistory<PlaneMatrix<double>> plane;
  History space;
  PlaneMatrix<double> F = PlaneMatrix<double>::identity();
  for (int step = 0; step < 50; ++step) {
    const M3 change = random_gradient(random, 2e-3);
    F = PlaneMatrix<double>{0.9995 * in_plane<2>(change), 1.0} * F;
    const auto a = respond(m, F, plane, 1e-3);
    const auto b = respond(m, in_space(F), space, 1e-3);
    EXPECT_LT(distance(in_space(a.P), b.P), 1e-8);
    EXPECT_NEAR(a.energy, b.energy, 1e-9 * (1.0 + b.energy));
  }
  EXPECT_GT(space.strain, 0.0);
}

}  // namespace
}  // namespace sinew
