/// Models of damage against closed forms.

#include <gtest/gtest.h>

#include <sinew/damage/registry.hpp>
#include <unit/physics/random_states.hpp>

namespace sinew {
namespace {

using namespace testing_support;

/// P of a symmetric Kirchhoff stress.
Mat3<double> with_kirchhoff(const Mat3<double>& tau, const Mat3<double>& F) { return tau * transpose(inverse(F)); }

TEST(DamagedStress, TakesItsShareOfThePull) {
  std::mt19937_64 random(5);
  for (int trial = 0; trial < 100; ++trial) {
    const Mat3<double> Q = random_rotation(random), F = random_gradient(random);
    Mat3<double> principal, left;
    const double values[] = {3.0, -2.0, 1.0};
    for (int a = 0; a < 3; ++a) principal[a][a] = values[a], left[a][a] = values[a] > 0.0 ? 0.3 * values[a] : values[a];
    const auto r = damaged(F, with_kirchhoff(Q * principal * transpose(Q), F), 0.7);
    EXPECT_LT(distance(r.P * transpose(F), Q * left * transpose(Q)), 1e-13);
    EXPECT_NEAR(r.pulling, 10.0 / 14.0, 1e-13);
    EXPECT_LT(distance(damaged(F, r.P, 0.0).P, r.P), 1e-13);
  }
}

TEST(DamagedStress, FailedParticleCarriesCompressionOnly) {
  const Mat3<double> I = Mat3<double>::identity(), push = -2.0 * I;
  EXPECT_LT(distance(damaged(I, push, 1.0).P, push), 1e-15);
  EXPECT_LT(distance(damaged(I, 2.0 * I, 1.0).P, Mat3<double>{}), 1e-15);
}

/// From 0 to 1 in 2.5 R / c with the published crack speed of 0.4, along a cubic parabola.
TEST(CrackGrowth, TakesTwoAndAHalfTransits) {
  const CrackGrowth growth;
  double root = 0.0;
  const int steps = 1000;
  const double c = 3.0, R = 0.7, dt = 2.5 * R / c / steps;
  for (int n = 1; n <= steps; ++n) {
    root = growth.grow(root, true, c * dt / R);
    EXPECT_NEAR(root, static_cast<double>(n) / steps, 1e-12);
  }
  EXPECT_EQ(growth.grow(0.999, true, 0.1), 1.0);
  EXPECT_EQ(growth.grow(0.2, false, 0.1), 0.2);
}

DamagePoint<Mat3<double>> at(const Mat3<double>& F) { return {F, {}, 0.0, 0.0, 0.0, 0.01}; }

TEST(PrincipalStrain, BeginsAboveTheThreshold) {
  PrincipalStrainDamage model;
  model.threshold = 0.08;
  std::mt19937_64 random(6);
  const Mat3<double> Q = random_rotation(random), R = random_rotation(random);
  const auto stretched = [&](double stretch) {
    Mat3<double> U = 0.8 * Mat3<double>::identity();  // pushed across
    U[0][0] = stretch;
    return R * Q * U * transpose(Q);
  };
  double unused = 0.0;
  EXPECT_FALSE(model.begins(at(stretched(std::sqrt(1.16) - 1e-9)), &unused));
  EXPECT_TRUE(model.begins(at(stretched(std::sqrt(1.16) + 1e-9)), &unused));
  EXPECT_FALSE(model.begins(at(stretched(0.3)), &unused)) << "compression does not count";
}

TEST(PlasticStrain, BeginsAboveTheLimit) {
  PlasticStrainDamage model;
  model.limit = 0.3;
  DamagePoint<Mat3<double>> point = at(Mat3<double>::identity());
  double unused = 0.0;
  point.plastic_strain = 0.3;
  EXPECT_FALSE(model.begins(point, &unused));
  point.plastic_strain = 0.301;
  EXPECT_TRUE(model.begins(point, &unused));
}

JohnsonCookFailure johnson_cook() {
  JohnsonCookFailure model;
  model.d1 = 0.05, model.d2 = 3.44, model.d3 = -2.12, model.d4 = 0.002, model.d5 = 0.61;
  model.reference_rate = 1.0, model.reference_temperature = 294.0, model.melting_temperature = 1793.0;
  return model;
}

/// 4340 steel: in uniaxial tension (triaxiality 1/3), shear (0) and compression (-1/3), slow and cold; then fast and hot.
TEST(JohnsonCookFailure, Formula) {
  const JohnsonCookFailure model = johnson_cook();
  EXPECT_NEAR(model.failure_strain(1.0 / 3.0, 1.0, 294.0), 0.05 + 3.44 * std::exp(-2.12 / 3.0), 1e-14);
  EXPECT_NEAR(model.failure_strain(0.0, 1e-9, 294.0), 3.49, 1e-14);
  EXPECT_NEAR(model.failure_strain(9.0, 1.0, 294.0), 0.05 + 3.44 * std::exp(-2.12 * 1.5), 1e-14);
  EXPECT_NEAR(model.failure_strain(0.0, 1e3, 1043.5), 3.49 * (1.0 + 0.002 * std::log(1e3)) * (1.0 + 0.61 * 0.5), 1e-13);
}

/// Steps of plastic strain in uniaxial tension add up to failure at the failure strain.
TEST(JohnsonCookFailure, AddsUp) {
  const JohnsonCookFailure model = johnson_cook();
  DamagePoint<Mat3<double>> point = at(Mat3<double>::identity());
  point.P[0][0] = 2.0;
  point.plastic_increment = 0.001;
  point.temperature = 294.0, point.dt = 1e-2;  // a rate of 0.1, below the reference
  const double limit = model.failure_strain(1.0 / 3.0, 1.0, 294.0);
  double sum = 0.0, strain = 0.0;
  while (!model.begins(point, &sum) && strain < 2.0 * limit) strain += 0.001;
  EXPECT_NEAR(strain, limit, 0.0011);
}

/// It takes the rate of the step, the temperature of the point, and the triaxiality of the Kirchhoff stress, whatever the deformation.
TEST(JohnsonCookFailure, SeesTheStateOfThePoint) {
  const JohnsonCookFailure model = johnson_cook();
  const Mat3<double> F{{{1.2, 0.3, -0.1}, {0.1, 0.9, 0.2}, {-0.2, 0.1, 1.1}}};
  DamagePoint<Mat3<double>> point = at(F);
  Mat3<double> tau;
  tau[0][0] = 2.0;
  point.P = tau * transpose(inverse(F));
  point.plastic_increment = 1e-3, point.dt = 1e-6, point.temperature = 1043.5;
  const double share = 1e-3 / model.failure_strain(1.0 / 3.0, 1e3, 1043.5);
  double sum = 0.0;
  for (int step = 1; step <= 2; ++step) {
    model.begins(point, &sum);
    EXPECT_NEAR(sum, step * share, 1e-12 * share);
  }
}

TEST(JohnsonCookFailure, SaysWhatIsMissing) {
  JohnsonCookFailure model;
  model.d4 = 0.1;
  EXPECT_TRUE(model.complete().value_or("").find("reference_rate") != std::string::npos);
  model.d4 = 0.0, model.d5 = 0.1;
  EXPECT_TRUE(model.complete().value_or("").find("melting_temperature") != std::string::npos);
}

}  // namespace
}  // namespace sinew
