#include <gtest/gtest.h>

#include <sinew/stabilization/registry.hpp>
#include <unit/physics/random_states.hpp>

namespace sinew {
namespace {

using testing_support::random_direction;
using testing_support::random_gradient;
using testing_support::random_rotation;

template <class T, int D>
Vec<T, D> pair_force(const Mat<T, D>& F, const Vec<T, D>& X, const Vec<T, D>& x, const T& weight) {
  return HourglassStiffness::central_share(F, X, x, weight).force;
}
template <int D>
double pair_energy(const Mat<double, D>& F, const Vec<double, D>& X, const Vec<double, D>& x, double weight) {
  return HourglassStiffness::central_share(F, X, x, weight).energy;
}

TEST(HourglassStiffness, VanishesForAffineMotion) {
  std::mt19937_64 random(5);
  for (int trial = 0; trial < 50; ++trial) {
    const Mat3<double> F = random_gradient(random);
    const Vec3<double> X = 0.01 * random_direction(random), x = F * X;
    EXPECT_LT(norm(pair_force(F, X, x, 1.0)), 1e-16);
    EXPECT_LT(pair_energy(F, X, x, 1.0), 1e-30);
  }
}

/// The published form with both particles: f_i = -(alpha/2) E_ij V_i V_j W_ij / r^2 (e.n) n, e = (F_i + F_j) X_ij / 2 - x_ij.
TEST(HourglassStiffness, SharesOfBothParticlesGiveThePublishedForce) {
  std::mt19937_64 random(6);
  HourglassStiffness stiffness;
  stiffness.normalization.value = "half";
  const double E = 3.0, volumes = 0.7, W = 2.0;
  for (int trial = 0; trial < 50; ++trial) {
    const Mat3<double> F_i = random_gradient(random), F_j = random_gradient(random);
    const Vec3<double> X = random_direction(random), x = 1.2 * random_direction(random);
    const double weight = stiffness.coefficient() * E * volumes * W / dot(X, X);
    const Vec3<double> force = pair_force(F_i, X, x, weight) - pair_force(F_j, -X, -x, weight);
    const Vec3<double> n = (1.0 / norm(x)) * x;
    const Vec3<double> e = 0.5 * (F_i * X + F_j * X) - x;
    const Vec3<double> published = (-0.5 * stiffness.alpha * E * volumes * W / dot(X, X) * dot(e, n)) * n;
    EXPECT_LT(norm(force - published), 1e-12 * norm(published) + 1e-13);
  }
}

TEST(HourglassStiffness, PullsAStretchedPairTogether) {
  const Mat<double, 2> I = Mat<double, 2>::identity();
  const Vec<double, 2> X{{1, 0}}, longer{{1.1, 0}}, shorter{{0.9, 0}};
  EXPECT_NEAR(pair_force(I, X, longer, 1.0)[0], 0.1, 1e-15);
  EXPECT_NEAR(pair_force(I, X, shorter, 1.0)[0], -0.1, 1e-15);
  EXPECT_NEAR(pair_energy(I, X, longer, 1.0), 0.25 * (1.0 - 1.0 / 1.1) * (1.21 - 1.0), 1e-15);
}

/// A small relative motion of the ends, the gradient following in proportion: the energy is the work of the force.
TEST(HourglassStiffness, EnergyIsTheWorkOfASmallProportionalMotion) {
  const Vec<double, 2> X{{0.6, 0.8}}, u{{0.3, -0.7}};
  const Mat<double, 2> gradient{{{0.1, 0.4}, {-0.2, 0.3}}}, I = Mat<double, 2>::identity();
  const double size = 1e-6;
  const auto force_along_u = [&](double s) {
    return dot(pair_force(I + (s * size) * gradient, X, X + (s * size) * u, 2.5), size * u);
  };
  const double work = (force_along_u(0.0) + 4.0 * force_along_u(0.5) + force_along_u(1.0)) / 6.0;
  const double energy = pair_energy(I + size * gradient, X, X + size * u, 2.5);
  EXPECT_NEAR(energy, work, 1e-5 * std::abs(work));
}

TEST(HourglassStiffness, IsFrameIndifferent) {
  std::mt19937_64 random(8);
  const Mat3<double> F = random_gradient(random), Q = random_rotation(random);
  const Vec3<double> X = random_direction(random), x = random_direction(random);
  const Vec3<double> turned = pair_force(Q * F, X, Q * x, 1.0);
  EXPECT_LT(norm(turned - Q * pair_force(F, X, x, 1.0)), 1e-14);
}

/// The conservative share with F held fixed is minus the derivative of its energy with respect to x; and F is the minimizer, see the
/// invariants of whole bodies.
TEST(HourglassStiffness, ConservativeShareIsTheGradientOfItsEnergy) {
  std::mt19937_64 random(10);
  const Mat3<double> F = random_gradient(random);
  const Vec3<double> X = random_direction(random), x = random_direction(random);
  const double weight = 2.5, step = 1e-5;
  const auto share = HourglassStiffness::conservative_share(F, X, x, weight);
  for (int c = 0; c < 3; ++c) {
    Vec3<double> after = x, before = x;
    after[c] += step;
    before[c] -= step;
    const double slope = (HourglassStiffness::conservative_share(F, X, after, weight).energy -
                          HourglassStiffness::conservative_share(F, X, before, weight).energy) /
                         (2.0 * step);
    EXPECT_NEAR(share.force[c], slope, 1e-9);
  }
  EXPECT_LT(norm(HourglassStiffness::conservative_share(F, X, F * X, weight).force), 1e-15);
}

TEST(HourglassStiffness, EmptyPairsGiveNothing) {
  const Vec3<double> zero{};
  EXPECT_EQ(norm(pair_force(Mat3<double>::identity(), zero, zero, 0.0)), 0.0);
  EXPECT_EQ(pair_energy(Mat3<double>::identity(), zero, zero, 0.0), 0.0);
}

TEST(HourglassStiffness, Normalizations) {
  HourglassStiffness stiffness;
  EXPECT_EQ(stiffness.coefficient(), 50.0 / 32.0);
  stiffness.normalization.value = "half";
  EXPECT_EQ(stiffness.coefficient(), 12.5);
  stiffness.normalization.value = "printed";
  EXPECT_EQ(stiffness.coefficient(), 25.0);
  EXPECT_EQ(Stabilizations::names(),
            (std::vector<std::string>{"hourglass_stiffness", "hourglass_energy", "artificial_viscosity", "jst",
                                      "artificial_pressure", "artificial_stress", "non_nested_shear"}));
}

TEST(HourglassStiffness, PackGivesTheValuesOfItsLanes) {
  std::mt19937_64 random(9);
  const Mat3<double> F = random_gradient(random);
  const Vec3<double> X = random_direction(random), x = random_direction(random);
  Mat3<Pack> packed_F;
  Vec3<Pack> packed_X, packed_x;
  for (int i = 0; i < 3; ++i) {
    packed_X[i] = Pack(X[i]);
    packed_x[i] = Pack(x[i]);
    for (int j = 0; j < 3; ++j) packed_F[i][j] = Pack(F[i][j]);
  }
  const Vec3<Pack> packed = pair_force(packed_F, packed_X, packed_x, Pack(1.5));
  const Vec3<double> single = pair_force(F, X, x, 1.5);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(packed[i][5], single[i], 1e-15);
}

}  // namespace
}  // namespace sinew
