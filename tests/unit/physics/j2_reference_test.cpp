/// Return mapping against closed forms.

#include <unit/physics/plastic_support.hpp>

namespace sinew {
namespace {

using namespace testing_support;

using Linear = J2<LinearHardening>;
using Voce = J2<VoceHardening>;
using JohnsonCook = J2<JohnsonCookHardening>;
using History = PlasticHistory<Mat3<double>>;

/// Stretch by exp(strain) along one axis at constant volume: the deviator of ln(stretch) is {strain, -strain/2, -strain/2}, q = 3 mu strain.
Mat3<double> isochoric(double strain) {
  Mat3<double> F;
  F[0][0] = std::exp(strain);
  F[1][1] = F[2][2] = std::exp(-0.5 * strain);
  return F;
}

/// Pulls in many steps and hands q and the history of each to `check`.
template <class Material, class Check>
History pull(const Material& m, double most, int steps, double dt, Check&& check) {
  History history;
  for (int n = 1; n <= steps; ++n) {
    const double strain = most * n / steps;
    const Mat3<double> F = isochoric(strain), P = m.respond(F, history, dt).P;
    check(strain, von_mises_of(kirchhoff(P, F)), history);
  }
  return history;
}

/// e_p = (3 mu e - sigma_0) / (3 mu + H) for any number of steps, since the path is straight in ln(stretch).
TEST(J2Reference, UniaxialLinearHardening) {
  const Linear m = plastic<Linear>();
  for (const int steps : {1, 10, 1000}) {
    const History end = pull(m, 0.5, steps, 0.0, [](double strain, double q, const History& history) {
      const double plastic_strain = std::max(0.0, (2.4 * strain - 0.01) / (2.4 + 0.05));
      EXPECT_NEAR(history.strain, plastic_strain, 1e-12);
      EXPECT_NEAR(q, 2.4 * (strain - plastic_strain), 1e-12);
    });
    const double e = end.strain;
    if (steps == 1000) {
      EXPECT_NEAR(end.work, 0.01 * e + 0.025 * e * e, 1e-5);
    }
  }
}

TEST(J2Reference, UniaxialPerfectPlasticityDissipatesYieldStressTimesStrain) {
  Linear m = plastic<Linear>();
  m.hardening.hardening_modulus = 0.0;
  const History end = pull(m, 0.3, 57, 0.0, [](double, double, const History&) {});
  EXPECT_NEAR(end.strain, 0.3 - 0.01 / 2.4, 1e-12);
  EXPECT_NEAR(end.work, 0.01 * end.strain, 1e-14);
}

/// Voce without its linear part: e_p solves a scalar equation, here by bisection.
TEST(J2Reference, UniaxialVoceHardening) {
  const Voce m = plastic<Voce>();
  pull(m, 0.5, 20, 0.0, [](double strain, double q, const History& history) {
    double low = 0.0, high = strain;
    for (int n = 0; n < 200; ++n) {
      const double e = 0.5 * (low + high);
      const double yield = 0.01 + 0.006 * (1.0 - std::exp(-8.0 * e)) + 0.01 * e;
      (2.4 * (strain - e) > yield ? low : high) = e;
    }
    EXPECT_NEAR(history.strain, low, 1e-13);
    EXPECT_NEAR(q, 2.4 * (strain - low), 1e-12);
  });
}

/// At a steady rate q is Johnson and Cook's formula with the strain, rate and temperature that the history tells; rates in fully plastic flow
/// differ from the strain rate by the elastic part only.
TEST(J2Reference, JohnsonCookFormula) {
  const JohnsonCook m = plastic<JohnsonCook>();
  const double dt = 1e-4, most = 0.4;
  const int steps = 4000;
  History last;
  pull(m, most, steps, dt, [&](double, double q, const History& history) {
    const double rate = (history.strain - last.strain) / dt;
    const double theta = 0.9 * last.work / (m.density * 2e-5) / 1000.0;
    if (history.strain > 0.01) {
      const double slow = 0.01 + 0.02 * std::pow(history.strain, 0.4), fast = 1.0 + 0.03 * std::log(rate / 0.1);
      EXPECT_NEAR(q, slow * fast * (1.0 - std::pow(theta, 1.1)), 1e-13);
      EXPECT_NEAR(rate, 1.0, 0.06);
    }
    last = history;
  });
  EXPECT_GT(m.temperature(last), 500.0);
  EXPECT_NEAR(m.temperature(last), 300.0 + 0.9 * last.work / 2e-5, 1e-9);
}

TEST(J2Reference, JohnsonCookWithoutRateAndHeatIsAPowerLaw) {
  JohnsonCook m = plastic<JohnsonCook>();
  m.hardening.rate_coefficient = 0.0, m.hardening.melting_temperature = infinity, m.hardening.specific_heat = infinity;
  pull(m, 0.5, 50, 1e-3, [](double strain, double q, const History& history) {
    EXPECT_NEAR(q, std::min(2.4 * strain, 0.01 + 0.02 * std::pow(history.strain, 0.4)), 1e-13);
  });
}

/// A strength that heat has used up: the metal flows without stress and does not fail.
TEST(J2Reference, MoltenMetalBearsNoShear) {
  JohnsonCook m = plastic<JohnsonCook>();
  m.hardening.specific_heat = 1e-7;
  History history;
  history.work = 1e-3;
  const Mat3<double> F = isochoric(0.2);
  EXPECT_NEAR(von_mises_of(kirchhoff(m.respond(F, history, 1e-3).P, F)), 0.0, 1e-12);
}

/// Simple shear by g from the virgin state in small steps: with a small yield stress the shear stress comes to sigma_y / sqrt(3) and the plastic strain
/// grows by dg / sqrt(3).
TEST(J2Reference, SimpleShear) {
  Linear m = plastic<Linear>();
  m.hardening = {1e-5, 0.0};
  History history;
  Mat3<double> F = Mat3<double>::identity(), tau;
  const int steps = 20000;
  double half_way = 0.0;
  for (int n = 1; n <= steps; ++n) {
    F[0][1] = 1.0 * n / steps;
    tau = kirchhoff(m.respond(F, history, 0.0).P, F);
    if (2 * n == steps) half_way = history.strain;
  }
  EXPECT_NEAR(tau[0][1], 1e-5 / std::sqrt(3.0), 1e-9);
  EXPECT_NEAR(history.strain - half_way, 0.5 / std::sqrt(3.0), 1e-4 * 0.5);
}

/// Elastic unloading after flow: back by the elastic strain there is no stress, and nothing flows.
TEST(J2Reference, UnloadsElastically) {
  const Linear m = plastic<Linear>();
  History history = pull(m, 0.1, 10, 0.0, [](double, double, const History&) {});
  const double plastic_strain = history.strain;
  const Mat3<double> F = isochoric(plastic_strain);
  EXPECT_LT(distance(m.respond(F, history, 0.0).P, Mat3<double>{}), 1e-13);
  EXPECT_EQ(history.strain, plastic_strain);
}

TEST(JohnsonCook, SaysWhatIsMissing) {
  JohnsonCookHardening h;
  EXPECT_EQ(h.complete(), std::nullopt);
  h.rate_coefficient = 0.1;
  EXPECT_TRUE(h.complete().value_or("").find("reference_rate") != std::string::npos);
  h = {};
  h.melting_temperature = 1300.0;
  EXPECT_TRUE(h.complete().value_or("").find("specific_heat") != std::string::npos);
  h.specific_heat = 400.0, h.melting_temperature = 200.0;
  EXPECT_TRUE(h.complete().value_or("").find("above reference_temperature") != std::string::npos);
}

}  // namespace
}  // namespace sinew
