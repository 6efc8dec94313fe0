#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <sinew/core/dual.hpp>
#include <sinew/core/pack.hpp>

namespace sinew {
namespace {

/// Distance of two doubles of the same sign in units of the last place.
double units_in_last_place(double a, double b) {
  return std::abs(static_cast<double>(std::bit_cast<std::int64_t>(a) - std::bit_cast<std::int64_t>(b)));
}

/// The largest distance between `packed` and `reference` over 1e5 random values, half of them near 1, half over 100 decades.
template <class Packed, class Reference>
double largest_distance(Packed packed, Reference reference) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> near_one(0.3, 3.0), exponent(-50.0, 50.0);
  double worst = 0.0;
  for (int i = 0; i < 100000 / lanes; ++i) {
    Pack x;
    for (int lane = 0; lane < lanes; ++lane) x.set(lane, lane % 2 == 0 ? near_one(random) : std::pow(10.0, exponent(random)));
    const Pack y = packed(x);
    for (int lane = 0; lane < lanes; ++lane) worst = std::max(worst, units_in_last_place(y[lane], reference(x[lane])));
  }
  return worst;
}

TEST(Pack, SquareRootIsThatOfTheStandardLibrary) {
  EXPECT_EQ(largest_distance([](Pack x) { return sqrt(x); }, [](double x) { return std::sqrt(x); }), 0.0);
}
TEST(Pack, LogarithmIsWithinTwoUnitsInTheLastPlace) {
  EXPECT_LE(largest_distance([](Pack x) { return log(x); }, [](double x) { return std::log(x); }), 2.0);
}
TEST(Pack, CubeRootIsWithinTwoUnitsInTheLastPlace) {
  // The standard library's own double cube root is not exact enough to compare with.
  const auto exact = [](double x) { return static_cast<double>(std::cbrt(static_cast<long double>(x))); };
  EXPECT_LE(largest_distance([](Pack x) { return cbrt(x); }, exact), 2.0);
}

TEST(Pack, LogarithmAtTheEdges) {
  Pack x(1.0);
  x.set(1, 0.0);
  x.set(2, -1.0);
  x.set(3, std::numeric_limits<double>::quiet_NaN());
  x.set(4, 1.0 + std::numeric_limits<double>::epsilon());
  const Pack y = log(x);
  EXPECT_EQ(y[0], 0.0);
  EXPECT_TRUE(std::isinf(y[1]) && y[1] < 0.0);
  EXPECT_TRUE(std::isnan(y[2]));
  EXPECT_TRUE(std::isnan(y[3]));
  EXPECT_DOUBLE_EQ(y[4], std::numeric_limits<double>::epsilon());
}

TEST(Pack, SelectMinimumMaximumAndReductions) {
  Pack ramp;
  for (int lane = 0; lane < lanes; ++lane) ramp.set(lane, lane - 3.0);
  const Pack chosen = select(ramp < Pack(0.0), Pack(10.0), ramp);
  EXPECT_EQ(chosen[0], 10.0);
  EXPECT_EQ(chosen[3], 0.0);
  EXPECT_EQ(max(ramp, Pack(0.0))[1], 0.0);
  EXPECT_EQ(min(ramp, Pack(0.0))[7], 0.0);
  EXPECT_EQ(abs(ramp)[0], 3.0);
  EXPECT_EQ(smallest(ramp), -3.0);
  EXPECT_EQ(largest(ramp), 4.0);
  EXPECT_EQ(sum(ramp), 4.0);
  EXPECT_TRUE(any(ramp > Pack(3.5)));
  EXPECT_FALSE(any(ramp > Pack(4.5)));
  EXPECT_FALSE(all(ramp > Pack(-3.0)));
  EXPECT_TRUE(all(ramp >= Pack(-3.0)));
}

template <class F>
void expect_derivative(F f, double x) {
  const double step = 1e-5 * x;
  const double expected = (f(x + step) - f(x - step)) / (2.0 * step);
  EXPECT_NEAR(f(Dual<double>(x, 1.0)).slope, expected, 1e-8 * std::abs(expected) + 1e-9);
}

TEST(Dual, DerivativesOfTheFunctions) {
  for (const double x : {0.4, 1.7, 23.0}) {
    expect_derivative(
        [](auto y) {
          using std::sqrt;
          return sqrt(y) * y - y / (y + 2.0);
        },
        x);
    expect_derivative(
        [](auto y) {
          using std::log;
          return log(y) * 3.0 - (-y);
        },
        x);
    expect_derivative([](auto y) { return 1.0 / cbrt(y); }, x);
    expect_derivative([](auto y) { return max(y * y, decltype(y)(1.0)) + min(y, decltype(y)(2.0)); }, x);
  }
}

TEST(Dual, OfPackEqualsDualOfEachLane) {
  Pack x;
  for (int lane = 0; lane < lanes; ++lane) x.set(lane, 0.3 + 0.7 * lane);
  const auto f = [](auto y) {
    using std::log;
    return log(y) / cbrt(y) - y;
  };
  const Dual<Pack> packed = f(Dual<Pack>(x, Pack(1.0)));
  for (int lane = 0; lane < lanes; ++lane) {
    const Dual<double> single = f(Dual<double>(x[lane], 1.0));
    EXPECT_NEAR(packed.value[lane], single.value, 1e-14);
    EXPECT_NEAR(packed.slope[lane], single.slope, 1e-13);
  }
}

}  // namespace
}  // namespace sinew
