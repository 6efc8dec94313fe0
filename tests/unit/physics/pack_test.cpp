#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <sinew/core/dual.hpp>
#include <sinew/core/pack.hpp>
#include <sinew/particles/rows.hpp>

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

TEST(Pack, InverseSquareRootIsGoodToTwoUlps) {
  std::mt19937_64 random(12);
  std::uniform_real_distribution<double> exponent(-300.0, 300.0);
  for (int trial = 0; trial < 2000; ++trial) {
    Pack x;
    for (int k = 0; k < lanes; ++k) x.set(k, std::pow(10.0, exponent(random)));
    const Pack y = inverse_sqrt(x);
    for (int k = 0; k < lanes; ++k) EXPECT_NEAR(y[k] * std::sqrt(x[k]), 1.0, 5e-16) << x[k];
  }
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

TEST(Pack, ExponentialIsWithinTwoUnitsInTheLastPlace) {
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> small(-1e-3, 1e-3), large(-700.0, 700.0);
  double worst = 0.0;
  for (int trial = 0; trial < 20000; ++trial) {
    Pack x;
    for (int k = 0; k < lanes; ++k) x.set(k, k % 2 == 0 ? small(random) : large(random));
    const Pack y = exp(x);
    for (int k = 0; k < lanes; ++k) worst = std::max(worst, units_in_last_place(y[k], std::exp(x[k])));
  }
  EXPECT_LE(worst, 2.0);
}

TEST(Pack, ExponentialAtTheEdges) {
  Pack x(0.0);
  x.set(1, -1e300), x.set(2, 1e300), x.set(3, -INFINITY), x.set(4, INFINITY), x.set(5, std::nan(""));
  const Pack y = exp(x);
  EXPECT_EQ(y[0], 1.0);
  EXPECT_EQ(y[1], 0.0);
  EXPECT_EQ(y[2], INFINITY);
  EXPECT_EQ(y[3], 0.0);
  EXPECT_EQ(y[4], INFINITY);
  EXPECT_TRUE(std::isnan(y[5]));
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

/// Lane k is a + b k + c k^2: no two lanes alike.
Pack lanes_of(double a, double b, double c) {
  Pack p;
  for (int k = 0; k < lanes; ++k) p.set(k, a + b * k + c * k * k);
  return p;
}

TEST(Pack, EveryLaneIsTheSameOperationOnDoubles) {
  const Pack a = lanes_of(-1.3, 0.7, -0.11), b = lanes_of(0.9, -0.4, 0.03);
  const Pack sum_of = a + b, difference = a - b, product = a * b, quotient = a / b, negative = -a;
  Pack in_place = a;
  in_place += b;
  in_place -= Pack(1.0);
  in_place *= b;
  const PackMask less = a<b, greater = a> b, less_or_equal = a <= b, greater_or_equal = a >= b;
  const Pack chosen = select(less, a, b);
  for (int k = 0; k < lanes; ++k) {
    EXPECT_EQ(sum_of[k], a[k] + b[k]);
    EXPECT_EQ(difference[k], a[k] - b[k]);
    EXPECT_EQ(product[k], a[k] * b[k]);
    EXPECT_EQ(quotient[k], a[k] / b[k]);
    EXPECT_EQ(negative[k], -a[k]);
    EXPECT_EQ(in_place[k], (a[k] + b[k] - 1.0) * b[k]);
    EXPECT_EQ(less[k], a[k] < b[k]);
    EXPECT_EQ(greater[k], a[k] > b[k]);
    EXPECT_EQ(less_or_equal[k], a[k] <= b[k]);
    EXPECT_EQ(greater_or_equal[k], a[k] >= b[k]);
    EXPECT_EQ((less & less_or_equal)[k], a[k] < b[k]);
    EXPECT_EQ((less | greater)[k], a[k] != b[k]);
    EXPECT_EQ((!less)[k], !(a[k] < b[k]));
    EXPECT_EQ(chosen[k], std::min(a[k], b[k]));
  }
}

TEST(Pack, LoadsAndStoresAtAnyPlaceOfAnArray) {
  double numbers[3 * lanes];
  for (int i = 0; i < 3 * lanes; ++i) numbers[i] = 0.5 * i;
  for (int offset = 0; offset < lanes; ++offset) {
    const Pack p = Pack::load_unaligned(numbers + offset);
    for (int lane = 0; lane < lanes; ++lane) EXPECT_EQ(p[lane], 0.5 * (offset + lane));
    double out[3 * lanes] = {};
    p.store_unaligned(out + offset);
    for (int i = 0; i < 3 * lanes; ++i) EXPECT_EQ(out[i], i >= offset && i < offset + lanes ? numbers[i] : 0.0);
  }
}

TEST(Pack, LoadsFloatsAsDoubles) {
  alignas(32) float numbers[lanes];
  for (int lane = 0; lane < lanes; ++lane) numbers[lane] = 0.1f * static_cast<float>(lane) - 0.25f;
  const Pack p = Pack::load(numbers);
  for (int lane = 0; lane < lanes; ++lane) EXPECT_EQ(p[lane], static_cast<double>(numbers[lane]));
}

TEST(Pack, GathersByIndex) {
  double values[20];
  for (int i = 0; i < 20; ++i) values[i] = 1.5 * i;
  const int index[lanes] = {19, 0, 3, 3, 7, 12, 1, 18};
  const Pack p = Pack::gather(values, index);
  for (int lane = 0; lane < lanes; ++lane) EXPECT_EQ(p[lane], 1.5 * index[lane]);
}

TEST(Pack, MaskFromEveryPatternOfBits) {
  for (int bits = 0; bits < 256; ++bits) {
    const PackMask mask = PackMask::from_bits(static_cast<unsigned char>(bits));
    const Pack chosen = select(mask, Pack(1.0), Pack(2.0));
    for (int lane = 0; lane < lanes; ++lane) {
      EXPECT_EQ(mask[lane], (bits >> lane & 1) != 0);
      EXPECT_EQ(chosen[lane], (bits >> lane & 1) != 0 ? 1.0 : 2.0);
    }
    EXPECT_EQ(any(mask), bits != 0);
    EXPECT_EQ(all(mask), bits == 255);
  }
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

template <int D>
void expect_places_of_rows() {
  constexpr int rows = 11, width = place_width<D>;
  alignas(64) double row[rows * width];
  for (int i = 0; i < rows * width; ++i) row[i] = 100.0 + i;
  const int index[lanes] = {10, 0, 7, 7, 2, 9, 1, 4};
  const PlacePack<D> p = load_places<D>(row, index);
  for (int k = 0; k < lanes; ++k)
    for (int c = 0; c < D; ++c) {
      EXPECT_EQ(p.u[c][k], row[width * index[k] + c]);
      EXPECT_EQ(p.X[c][k], row[width * index[k] + vector_width<D> + c]);
    }
}

TEST(Rows, PlacesAreTransposed) {
  expect_places_of_rows<2>();
  expect_places_of_rows<3>();
}

template <int D>
void expect_subtraction_from_rows() {
  constexpr int rows = 9, width = vector_width<D>;
  alignas(64) double row[rows * width], expected[rows * width];
  for (int i = 0; i < rows * width; ++i) row[i] = expected[i] = 3.0 * i;
  const int index[lanes] = {8, 3, 3, 0, 5, 3, 8, 7};  // equal ones in the same half and in both
  Vec<Pack, D> t;
  for (int c = 0; c < D; ++c) t[c] = lanes_of(c + 1.0, 0.5, 0.25);
  subtract_rows(row, index, t);
  for (int k = 0; k < lanes; ++k)
    for (int c = 0; c < D; ++c) expected[width * index[k] + c] -= t[c][k];
  for (int i = 0; i < rows * width; ++i) EXPECT_EQ(row[i], expected[i]);
}

TEST(Rows, EqualIndicesAddUpInASubtraction) {
  expect_subtraction_from_rows<2>();
  expect_subtraction_from_rows<3>();
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
