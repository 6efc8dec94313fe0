#include <gtest/gtest.h>
#include <sinew/cli/expect.hpp>
#include <sinew/cli/run.hpp>

namespace sinew {
namespace {

ExpectCase expected(const std::string& quantity, double value, double tolerance) {
  ExpectCase expect;
  expect.quantity = quantity;
  expect.value = value;
  expect.tolerance = tolerance;
  if (quantity.starts_with("probe.")) {
    expect.probe = quantity.substr(6, quantity.rfind('.') - 6);
    expect.reduction = quantity.substr(quantity.rfind('.') + 1);
  }
  return expect;
}

/// A run of a study over n whose probe "tip" ends at `final`.
FinishedRun finished(double n, double final) {
  FinishedRun run{true, 2.0, {}, {{"parameters.n", n}}};
  run.probes["tip"] = {{{0.0, 1.0, 2.0}, {0.0, 0.5, final}}, -1.0, 3.0, "m"};
  return run;
}

TEST(Expect, RelativeToleranceOfANegativeValue) {
  EXPECT_TRUE(compare(expected("probe.tip.final", -2.0, 0.05), -2.099).pass);
  EXPECT_TRUE(compare(expected("probe.tip.final", -2.0, 0.05), -1.901).pass);
  EXPECT_FALSE(compare(expected("probe.tip.final", -2.0, 0.05), -2.11).pass);
  EXPECT_FALSE(compare(expected("probe.tip.final", -2.0, 0.05), 2.0).pass);
  EXPECT_FALSE(compare(expected("probe.tip.final", -2.0, 0.05), std::nan("")).pass);
}

TEST(Expect, AbsoluteTolerance) {
  ExpectCase expect = expected("probe.tip.final", 0.0, 0.0);
  expect.tolerance.reset();
  expect.absolute = 0.1;
  EXPECT_TRUE(compare(expect, -0.1).pass);
  EXPECT_FALSE(compare(expect, 0.11).pass);
  EXPECT_EQ(difference_text(compare(expect, 0.11)), "0.11");
  EXPECT_EQ(allowed_text(compare(expect, 0.11)), "0.1");
}

TEST(Expect, ExtremesAreThoseOfAllSamples) {
  const FinishedRun run = finished(4.0, 1.0);
  EXPECT_EQ(expected_quantity(expected("probe.tip.min", 0, 1), run), -1.0);
  EXPECT_EQ(expected_quantity(expected("probe.tip.max", 0, 1), run), 3.0);
  EXPECT_EQ(expected_quantity(expected("probe.tip.range", 0, 1), run), 4.0);
  EXPECT_EQ(expected_quantity(expected("probe.tip.final", 0, 1), run), 1.0);
  EXPECT_EQ(expected_quantity(expected("end_time", 0, 1), run), 2.0);
}

TEST(Expect, AStoppedRunPassesOnlyIfThatIsExpected) {
  FinishedRun run = finished(4.0, 1.0);
  run.completed = false;
  const ExpectCase final_row = expected("probe.tip.final", 1.0, 0.1);
  EXPECT_FALSE(check_expects({final_row}, run, Tier::full)[0].pass);
  ExpectCase status = expected("status", 0.0, 0.0);
  status.absolute = 0.5;
  const std::vector<ExpectSummary> rows = check_expects({final_row, status}, run, Tier::full);
  EXPECT_TRUE(rows[0].pass);
  EXPECT_TRUE(rows[1].pass);
}

TEST(Expect, QuickTierLeavesOutFullRows) {
  ExpectCase full = expected("probe.tip.final", 1.0, 0.1);
  full.tier = "full";
  const std::vector<ExpectCase> expects{full, expected("probe.tip.max", 3.0, 0.1)};
  EXPECT_EQ(check_expects(expects, finished(4.0, 1.0), Tier::full).size(), 2U);
  EXPECT_EQ(check_expects(expects, finished(4.0, 1.0), Tier::quick).size(), 1U);
}

TEST(Expect, RateTowardsTheExactValue) {
  std::vector<FinishedRun> runs;
  for (const double n : {4.0, 8.0, 16.0}) runs.push_back(finished(n, 5.0 - 2.0 / (n * n)));
  ExpectCase rate = expected("probe.tip.rate", 2.0, 0.01);
  rate.exact = 5.0;
  const std::vector<ExpectSummary> rows = check_study({rate}, runs, Tier::full);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_NEAR(rows[0].value, 2.0, 1e-10);
  EXPECT_TRUE(rows[0].pass);
  runs[1].completed = false;
  EXPECT_FALSE(check_study({rate}, runs, Tier::full)[0].pass);
}

TEST(Expect, WithChoosesRunsOfTheStudy) {
  const std::vector<FinishedRun> runs{finished(4.0, 1.0), finished(8.0, 2.0)};
  ExpectCase expect = expected("probe.tip.final", 2.0, 0.01);
  EXPECT_EQ(check_study({expect}, runs, Tier::full).size(), 2U);
  expect.with = {{"parameters.n", 8.0}};
  const std::vector<ExpectSummary> rows = check_study({expect}, runs, Tier::full);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_TRUE(rows[0].pass);
  EXPECT_EQ(rows[0].quantity, "probe.tip.final (parameters.n = 8)");
}

TEST(Study, AllCombinationsTheFirstKeySlowest) {
  Case c;
  c.study.vary = {{"parameters.n", {4.0, 8.0}}, {"solver.cfl", {0.1, 0.2}}};
  const std::vector<StudyPoint> points = study_points(c, Tier::full);
  ASSERT_EQ(points.size(), 4U);
  EXPECT_EQ(points[0].folder_name, "001_n=4_cfl=0.1");
  EXPECT_EQ(points[1].folder_name, "002_n=4_cfl=0.2");
  EXPECT_EQ(points[3].folder_name, "004_n=8_cfl=0.2");
}

TEST(Study, QuickTierRunsOnlyWhatItsRowsNeed) {
  Case c;
  c.study.vary = {{"parameters.n", {4.0, 8.0, 16.0}}};
  ExpectCase quick = expected("probe.tip.final", 1.0, 0.1), full = quick;
  quick.with = {{"parameters.n", 8.0}};
  full.tier = "full";
  c.expects = {quick, full};
  const std::vector<StudyPoint> points = study_points(c, Tier::quick);
  ASSERT_EQ(points.size(), 1U);
  EXPECT_EQ(points[0].folder_name, "002_n=8");
  EXPECT_EQ(study_points(c, Tier::full).size(), 3U);
}

}  // namespace
}  // namespace sinew
