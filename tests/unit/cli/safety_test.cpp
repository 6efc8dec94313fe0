#include <gtest/gtest.h>

#include <cmath>

#include <sinew/cli/safety.hpp>

namespace sinew {
namespace {

/// A run with this factor whose probe follows value(t) from t = 0 to 4; the last stage begins at 1.
template <class Value>
FinishedRun run_with(double factor, const Value& value, bool completed = true) {
  FinishedRun run{completed, 4.0, {}, {{"parameters.f", factor}}, 1.0};
  Samples samples;
  for (int k = 0; k <= 400; ++k) {
    samples.time.push_back(0.01 * k);
    samples.value.push_back(value(0.01 * k));
  }
  run.probes["largest"] = {samples, 0.0, 1.0, "m"};
  return run;
}

double at_rest(double t) { return t < 1.0 ? 5.0 : 1.0 - std::exp(-4.0 * (t - 1.0)); }
double steady(double t) { return t < 1.0 ? 5.0 : t - 1.0; }

const SafetyCase safety{"largest"};

TEST(Safety, TheFirstThatGoesOnGrowing) {
  const std::vector<FinishedRun> runs{run_with(1.2, steady), run_with(1.0, at_rest), run_with(1.1, at_rest),
                                      run_with(1.3, steady, false)};
  const std::vector<SafetyRow> rows = safety_rows(safety, runs);
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[0].factor, 1.0);
  EXPECT_FALSE(rows[1].fails);
  EXPECT_LT(rows[1].share, 1e-3);
  EXPECT_NEAR(rows[1].growth, 1.0, 1e-4);
  EXPECT_TRUE(rows[2].fails);
  EXPECT_NEAR(rows[2].share, 0.25, 1e-12);
  EXPECT_TRUE(rows[3].fails);
  EXPECT_EQ(factor_of_safety(rows), 1.2);
  EXPECT_NE(safety_text(safety, rows).find("factor of safety: 1.2 (stable up to 1.1)"), std::string::npos);
}

TEST(Safety, SwingingIsNoGrowth) {
  const std::vector<FinishedRun> runs{run_with(1.0, [](double t) { return t < 1.0 ? 5.0 : 1.0 - std::cos(20.0 * (t - 1.0)); })};
  const SafetyRow row = safety_rows(safety, runs)[0];
  EXPECT_NEAR(row.growth, 2.0, 1e-2);
  EXPECT_LT(row.share, 1e-3);
  EXPECT_FALSE(row.fails);
}

TEST(Safety, UnknownIfAllFailOrNone) {
  for (const bool fails : {false, true}) {
    const std::vector<FinishedRun> runs{run_with(1.0, fails ? steady : at_rest), run_with(2.0, fails ? steady : at_rest)};
    const std::vector<SafetyRow> rows = safety_rows(safety, runs);
    EXPECT_TRUE(std::isnan(factor_of_safety(rows)));
    EXPECT_NE(safety_text(safety, rows).find(fails ? "less than all" : "greater than all"), std::string::npos);
  }
}

TEST(Safety, IsAnExpectedQuantity) {
  const std::vector<FinishedRun> runs{run_with(1.0, at_rest), run_with(1.1, steady)};
  ExpectCase expect;
  expect.quantity = "safety_factor";
  expect.value = 1.1;
  expect.absolute = 0.01;
  EXPECT_TRUE(check_study({expect}, runs, Tier::full, safety)[0].pass);
  expect.value = 1.2;
  EXPECT_FALSE(check_study({expect}, runs, Tier::full, safety)[0].pass);
}

TEST(Safety, CurvesOfAllRuns) {
  const std::vector<FinishedRun> runs{run_with(1.0, at_rest)};
  EXPECT_EQ(safety_curves(safety, runs).substr(0, 29), "factor,time,largest\n1,0,5\n1,0");
}

}  // namespace
}  // namespace sinew
