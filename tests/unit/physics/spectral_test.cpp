#include <gtest/gtest.h>

#include <sinew/core/spectral.hpp>
#include <unit/physics/random_states.hpp>

namespace sinew {
namespace {

using namespace testing_support;

Mat3<double> diagonal(const Vec3<double>& values) {
  Mat3<double> a;
  for (int k = 0; k < 3; ++k) a[k][k] = values[k];
  return a;
}

/// Directions are orthogonal and bring the matrix back.
void expect_spectrum(const Mat3<double>& a) {
  const Spectrum<Mat3<double>> s = spectrum(a);
  const double size = std::sqrt(double_dot(a, a));
  EXPECT_LE(distance(compose(s.directions, s.values), a), 4e-15 * size);
  EXPECT_LT(distance(s.directions * transpose(s.directions), Mat3<double>::identity()), 4e-15);
}

TEST(Spectrum, BringsTheMatrixBack) {
  std::mt19937_64 random(31);
  std::uniform_real_distribution<double> value(-1.0, 1.0), exponent(-12.0, 0.0);
  for (int trial = 0; trial < 1000; ++trial) {
    const Mat3<double> Q = random_rotation(random);
    const double gap = trial % 3 == 0 ? 0.0 : std::pow(10.0, exponent(random)), first = value(random);
    expect_spectrum(Q * diagonal({{first, first + gap, trial % 2 == 0 ? first - gap : value(random)}}) * transpose(Q));
  }
  expect_spectrum(Mat3<double>{});
  expect_spectrum(Mat3<double>::identity());
  expect_spectrum(Mat3<double>{{{0, 1, 0}, {1, 0, 0}, {0, 0, 0}}});
  expect_spectrum(Mat3<double>{{{1e200, 1e-200, 0}, {1e-200, 1, 0}, {0, 0, 1e-200}}});
}

TEST(Spectrum, PackGivesTheValuesOfItsLanes) {
  std::mt19937_64 random(32);
  for (int trial = 0; trial < 200; ++trial) {
    Mat3<Pack> packed;
    Mat3<double> single[lanes];
    for (int k = 0; k < lanes; ++k) {
      const Mat3<double> F = random_gradient(random, k == 0 ? 0.0 : 0.5);
      single[k] = F * transpose(F);
      for (int c = 0; c < 9; ++c) packed[c / 3][c % 3].set(k, single[k][c / 3][c % 3]);
    }
    const auto s = spectrum(packed);
    const Mat3<Pack> back = compose(s.directions, s.values);
    for (int k = 0; k < lanes; ++k) {
      const Vec3<double> values = spectrum(single[k]).values;
      for (int c = 0; c < 9; ++c) EXPECT_NEAR(back[c / 3][c % 3][k], single[k][c / 3][c % 3], 1e-14);
      for (int a = 0; a < 3; ++a) EXPECT_NEAR(s.values[a][k], values[a], 1e-14);
    }
  }
}

TEST(Spectrum, OfThePlaneIsThatOfTheWholeMatrix) {
  std::mt19937_64 random(33);
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  for (int trial = 0; trial < 500; ++trial) {
    const double mixed = trial == 0 ? 0.0 : value(random), first = value(random);
    const PlaneMatrix<double> a{{{{first, mixed}, {mixed, trial % 5 == 0 ? first : value(random)}}}, value(random)};
    const auto s = spectrum(a);
    const PlaneMatrix<double> back = compose(s.directions, s.values);
    EXPECT_LT(distance(back.in_plane, a.in_plane), 4e-15);
    EXPECT_EQ(back.out_of_plane, a.out_of_plane);
    const Mat3<double> whole = in_space(a);
    Vec3<double> v = s.values, w = spectrum(whole).values;
    std::sort(v.c, v.c + 3), std::sort(w.c, w.c + 3);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(v[k], w[k], 4e-15);
  }
}

}  // namespace
}  // namespace sinew
