#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <sinew/core/dual.hpp>
#include <sinew/kernels/registry.hpp>

namespace sinew {
namespace {

template <class Kernel>
class KernelContract : public ::testing::Test {};

template <class List>
struct AsTestTypes;
template <class... Ts>
struct AsTestTypes<TypeList<Ts...>> {
  using Type = ::testing::Types<Ts...>;
};
struct KernelNames {
  template <class Kernel>
  static std::string GetName(int) {
    return std::string(Kernel::name);
  }
};
TYPED_TEST_SUITE(KernelContract, AsTestTypes<Kernels>::Type, KernelNames);

/// Integral of f over [0, R] by five-point Gauss formulas on six intervals: exact for pieces up to degree 9 with joints at R k /
/// 6.
template <class F>
double integrate(double R, F f) {
  constexpr std::array place{-0.9061798459386640, -0.5384693101056831, 0.0, 0.5384693101056831, 0.9061798459386640};
  constexpr std::array weight{0.2369268850561891, 0.4786286704993665, 0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
  const double half = R / 12.0;
  double sum = 0.0;
  for (int interval = 0; interval < 6; ++interval)
    for (int k = 0; k < 5; ++k) sum += half * weight[k] * f(half * (2 * interval + 1 + place[k]));
  return sum;
}

/// Calls f with the number of dimensions as a compile-time constant.
template <class F>
void for_each_dimension(F f) {
  f.template operator()<1>();
  f.template operator()<2>();
  f.template operator()<3>();
}

TYPED_TEST(KernelContract, IntegralOverSpaceIsOne) {
  for_each_dimension([]<int D>() {
    for (const double R : {0.37, 1.0, 5.2}) {
      const double integral = integrate(R, [R](double r) {
        const double shell = D == 1 ? 2.0 : D == 2 ? 2.0 * std::numbers::pi * r : 4.0 * std::numbers::pi * r * r;
        return shell * TypeParam::template value<D>(r, R);
      });
      EXPECT_NEAR(integral, 1.0, 1e-13) << D << " dimensions, R = " << R;
    }
  });
}

TYPED_TEST(KernelContract, SlopeIsTheDerivativeOfTheValue) {
  for_each_dimension([]<int D>() {
    const double R = 1.3;
    for (double r = 0.0; r < 1.1 * R; r += 0.0137) {
      const double expected = TypeParam::template value<D>(Dual<double>(r, 1.0), R).slope;
      EXPECT_NEAR((TypeParam::template slope<D>(r, R)), expected, 1e-12) << D << " dimensions, r = " << r;
    }
  });
}

TYPED_TEST(KernelContract, VanishesFromTheSupportRadiusOn) {
  for_each_dimension([]<int D>() {
    for (const double r : {0.7, 0.7000001, 1.0, 40.0}) {
      EXPECT_NEAR((TypeParam::template value<D>(r, 0.7)), 0.0, 1e-15);
      EXPECT_NEAR((TypeParam::template slope<D>(r, 0.7)), 0.0, 1e-15);
    }
    EXPECT_GT((TypeParam::template value<D>(0.69, 0.7)), 0.0);
  });
}

TYPED_TEST(KernelContract, FallsMonotonicallyAndStaysPositive) {
  for_each_dimension([]<int D>() {
    double last = TypeParam::template value<D>(0.0, 1.0);
    for (int k = 1; k < 500; ++k) {
      const double r = k / 500.0, W = TypeParam::template value<D>(r, 1.0);
      EXPECT_GT(W, 0.0);
      EXPECT_LT(W, last);
      EXPECT_LT((TypeParam::template slope<D>(r, 1.0)), 0.0);
      last = W;
    }
  });
}

TYPED_TEST(KernelContract, PackGivesTheValuesOfItsLanes) {
  Pack r, R;
  for (int lane = 0; lane < lanes; ++lane) {
    r.set(lane, 0.17 * lane);
    R.set(lane, 0.8 + 0.05 * lane);
  }
  for_each_dimension([&]<int D>() {
    const Pack W = TypeParam::template value<D>(r, R), dW = TypeParam::template slope<D>(r, R);
    const Pack one_radius = TypeParam::template value<D>(r, 1.1);
    for (int lane = 0; lane < lanes; ++lane) {
      EXPECT_NEAR(W[lane], (TypeParam::template value<D>(r[lane], R[lane])), 1e-14);
      EXPECT_NEAR(dW[lane], (TypeParam::template slope<D>(r[lane], R[lane])), 1e-13);
      EXPECT_NEAR(one_radius[lane], (TypeParam::template value<D>(r[lane], 1.1)), 1e-14);
    }
  });
}

TYPED_TEST(KernelContract, SaysWhatItIs) {
  EXPECT_FALSE(TypeParam::name.empty() || TypeParam::summary.empty() || TypeParam::source.empty());
  EXPECT_GE(TypeParam::customary_h, 1.0);
}

/// Values at r = 0, 1/4, 1/2, 3/4 and slopes at r = 1/4, 1/2, 3/4 for R = 1, each to ten digits.
template <class Kernel, int D>
void expect_numbers(const std::array<double, 7>& expected) {
  for (int k = 0; k < 4; ++k) EXPECT_NEAR((Kernel::template value<D>(0.25 * k, 1.0)), expected[k], 6e-11) << Kernel::name;
  for (int k = 1; k < 4; ++k) EXPECT_NEAR((Kernel::template slope<D>(0.25 * k, 1.0)), expected[3 + k], 6e-11) << Kernel::name;
}

TEST(KernelNumbers, AgreeWithTheTable) {
  expect_numbers<Spiky, 2>({3.1830988618, 1.3428698323, 0.3978873577, 0.0497359197, -5.3714793294, -2.3873241464, -0.5968310366});
  expect_numbers<Spiky, 3>({4.7746482928, 2.0143047485, 0.5968310366, 0.0746038796, -8.0572189940, -3.5809862196, -0.8952465549});
  expect_numbers<CubicSpline, 2>(
      {1.8189136353, 1.3073441754, 0.4547284088, 0.0568410511, -3.4104630663, -2.7283704530, -0.6820926133});
  expect_numbers<CubicSpline, 3>(
      {2.5464790895, 1.8302818456, 0.6366197724, 0.0795774715, -4.7746482928, -3.8197186342, -0.9549296586});
  expect_numbers<QuinticSpline, 2>(
      {2.7688964576, 1.6516526366, 0.3107142332, 0.0099556380, -6.9468229663, -2.9498186694, -0.1991127602});
  expect_numbers<QuinticSpline, 3>(
      {4.7269018098, 2.8196070011, 0.5304335838, 0.0169956963, -11.8592192068, -5.0357618713, -0.3399139263});
  expect_numbers<WendlandC2, 2>(
      {2.2281692033, 1.4100133240, 0.4177817256, 0.0348151438, -4.7000444132, -2.7852115041, -0.5222271570});
  expect_numbers<WendlandC2, 3>(
      {3.3422538049, 2.1150199859, 0.6266725884, 0.0522227157, -7.0500666198, -4.1778172562, -0.7833407355});
}

TEST(Kernels, NamesAreTheAgreedOnes) {
  EXPECT_EQ(Kernels::names(), (std::vector<std::string>{"spiky", "cubic_spline", "quintic_spline", "wendland_c2"}));
}

}  // namespace
}  // namespace sinew
