#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <sinew/cli/measure.hpp>

namespace sinew {
namespace {

/// f over [0, duration], with steps that are not all the same.
template <class F>
Samples sampled(F&& f, double duration, int steps) {
  Samples samples;
  for (int i = 0; i <= steps; ++i) {
    const double s = static_cast<double>(i) / steps, t = duration * (s + 0.1 * s * (1.0 - s));
    samples.time.push_back(t);
    samples.value.push_back(f(t));
  }
  return samples;
}

TEST(Measure, ExtremesAndEnd) {
  const Samples samples{{0.0, 1.0, 2.0, 3.0}, {1.0, -4.0, 5.0, 2.0}};
  EXPECT_EQ(measure(samples, "final"), 2.0);
  EXPECT_EQ(measure(samples, "min"), -4.0);
  EXPECT_EQ(measure(samples, "max"), 5.0);
  EXPECT_EQ(measure(samples, "range"), 9.0);
  EXPECT_TRUE(std::isnan(measure({}, "final")));
  EXPECT_THROW(measure(samples, "rate"), std::invalid_argument);
}

TEST(Measure, ValueBetweenSamples) {
  const Samples samples{{0.0, 1.0, 3.0}, {1.0, 2.0, 6.0}};
  EXPECT_DOUBLE_EQ(measure(samples, "at", 0.0), 1.0);
  EXPECT_DOUBLE_EQ(measure(samples, "at", 0.25), 1.25);
  EXPECT_DOUBLE_EQ(measure(samples, "at", 2.0), 4.0);
  EXPECT_DOUBLE_EQ(measure(samples, "at", 3.0), 6.0);
  EXPECT_DOUBLE_EQ(measure(samples, "at", 3.0 * (1.0 + 1e-12)), 6.0) << "the end is reached up to rounding";
  EXPECT_TRUE(std::isnan(measure(samples, "at", 3.1)));
  EXPECT_TRUE(std::isnan(measure(samples, "at", -0.1)));
}

TEST(Measure, TimeMeanWeighsWithTheSteps) {
  EXPECT_DOUBLE_EQ(time_mean({{0.0, 1.0, 4.0}, {2.0, 2.0, 8.0}}), 17.0 / 4.0);
  EXPECT_DOUBLE_EQ(time_mean({{1.0}, {5.0}}), 5.0);
}

TEST(Measure, PeriodOfAShiftedSine) {
  const double period = 0.31;
  const auto wave = [&](double t) { return 7.0 + 0.5 * std::sin(2.0 * std::numbers::pi * (t / period - 0.1)); };
  const Samples samples = sampled(wave, 10.0 * period, 2000);
  EXPECT_NEAR(measure(samples, "period"), period, 1e-5 * period);
  EXPECT_NEAR(measure(samples, "frequency"), 1.0 / period, 1e-5 / period);
}

TEST(Measure, NoPeriodWithoutTwoCrossings) {
  EXPECT_TRUE(std::isnan(measure(sampled([](double t) { return t; }, 1.0, 10), "period")));
  EXPECT_TRUE(std::isnan(measure(sampled([](double) { return 3.0; }, 1.0, 10), "period")));
}

TEST(Measure, DriftIsRelativeToTheStart) {
  EXPECT_DOUBLE_EQ(measure({{0.0, 1.0, 2.0}, {-4.0, -5.0, -3.5}}, "drift"), 0.25);
  EXPECT_FALSE(std::isfinite(measure({{0.0, 1.0}, {0.0, 1.0}}, "drift")));
}

TEST(Measure, RateOfAPowerLaw) {
  std::vector<double> n, error;
  for (const double value : {4.0, 7.0, 13.0, 40.0}) {
    n.push_back(value);
    error.push_back(3.0 * std::pow(value, -1.7));
  }
  EXPECT_NEAR(convergence_rate(n, error), 1.7, 1e-12);
  error[0] = 0.0;
  EXPECT_TRUE(std::isnan(convergence_rate(n, error)));
  EXPECT_TRUE(std::isnan(convergence_rate(std::vector{4.0}, std::vector{1.0})));
}

TEST(Measure, RateIsTheLeastSquaresSlope) {
  // log2: x = 1, 2, 3; y = 0, -1, -3: slope -1.5
  EXPECT_NEAR(convergence_rate(std::vector{2.0, 4.0, 8.0}, std::vector{1.0, 0.5, 0.125}), 1.5, 1e-12);
}

}  // namespace
}  // namespace sinew
