#include <algorithm>
#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>
#include <sinew/cli/recorder.hpp>
#include <sinew/cli/schedule.hpp>
#include <sinew/io/file.hpp>

namespace sinew {
namespace {

/// A body whose only probe is the square of the time.
class FakeSimulation final : public Simulation {
 public:
  explicit FakeSimulation(double time_step_) : time_step(time_step_) {}
  const ModelFacts& facts() const override { return facts_; }
  double time() const override { return static_cast<double>(steps_) * time_step; }
  double end_time() const override { return 1.0; }
  long steps() const override { return steps_; }
  double stable_time_step() const override { return time_step; }
  void step(double) override { ++steps_; }
  void expect_record() override {}
  Energies energies() override { return {1.0, 0.5, 0.0, 0.0, 0.0, 1.0}; }
  Momenta momenta() override { return {}; }
  double imbalance() override { return 0.0; }
  bool probes_need_record() const override { return false; }
  std::vector<double> probe_values() override { return {time() * time()}; }
  std::vector<std::string> probe_units() const override { return {"m"}; }
  void fill_snapshot(const std::vector<std::string>&, Snapshot&) override {}
  Snapshot snapshot(const std::vector<std::string>&) override { return {}; }
  std::string state_hash() const override { return ""; }
  RanksPlan plan(int) const override { return {}; }
  SavedState save() override { return {time(), steps_, {}, {}, {}, {}}; }
  void restore(const SavedState& state) override { steps_ = state.step; }
  void take_over(SavedState state, const Handover&) override { steps_ = state.step; }
  std::map<std::string, double> pass_seconds() const override { return {}; }

 private:
  ModelFacts facts_;
  double time_step;
  long steps_ = 0;
};

class RecorderTest : public testing::Test {
 protected:
  RecorderTest() {
    std::filesystem::remove_all(path);
    c.probes.resize(1);
    c.probes[0].name = "square";
  }
  ~RecorderTest() override { std::filesystem::remove_all(path); }

  void advance(Recorder& recorder, long steps) {
    for (long i = 0; i < steps; ++i) {
      const double before = simulation.time();
      simulation.step(1.0);
      recorder.after_step(before);
    }
  }
  std::string history() const { return read_text(path + "/history.csv"); }
  long rows() const {
    const std::string text = history();
    return std::count(text.begin(), text.end(), '\n') - 1;
  }

  std::string path = testing::TempDir() + "sinew_recorder_" + testing::UnitTest::GetInstance()->current_test_info()->name();
  Case c;
  FakeSimulation simulation{0.001};
};

TEST(Schedule, MultiplesThatAreReachedOrPassed) {
  EXPECT_FALSE(multiple_reached(0.0, 0.9, 1.0));
  EXPECT_TRUE(multiple_reached(0.9, 1.0, 1.0));
  EXPECT_FALSE(multiple_reached(1.0, 1.9, 1.0));
  EXPECT_TRUE(multiple_reached(1.9, 5.2, 1.0));
  EXPECT_FALSE(multiple_reached(0.0, 10.0, 0.0)) << "0 means never";
  EXPECT_TRUE(multiple_reached(0.2, 0.1 + 0.2 - 1e-16, 0.1)) << "missed by rounding";
}

TEST_F(RecorderTest, EveryStepUntilThereAreTooManyRows) {
  const RunFolder folder = RunFolder::create(path, false);
  Recorder recorder(c, simulation, folder, Comm());
  recorder.begin();
  advance(recorder, 9998);
  recorder.flush();
  EXPECT_EQ(rows(), 9999);
  advance(recorder, 1);
  recorder.flush();
  EXPECT_EQ(rows(), 5000);
  advance(recorder, 30001);
  recorder.at_end();
  recorder.flush();
  EXPECT_LE(rows(), static_cast<long>(Recorder::most_rows));
  EXPECT_EQ(recorder.probes().at("square").samples.time.back(), 40.0);
}

TEST_F(RecorderTest, RowsAtMultiplesOfHistoryEvery) {
  c.output.history_every = 0.1;
  const RunFolder folder = RunFolder::create(path, false);
  Recorder recorder(c, simulation, folder, Comm());
  recorder.begin();
  advance(recorder, 1050);
  recorder.at_end();
  recorder.at_end();
  const Samples samples = recorder.probes().at("square").samples;
  ASSERT_EQ(samples.time.size(), 12U) << "first, ten multiples, last";
  EXPECT_DOUBLE_EQ(samples.time[1], 0.1);
  EXPECT_DOUBLE_EQ(samples.time[11], 1.05);
}

TEST_F(RecorderTest, ResumedHistoryIsThatOfAnUndisturbedRun) {
  std::string undisturbed;
  {
    const RunFolder folder = RunFolder::create(path, false);
    Recorder recorder(c, simulation, folder, Comm());
    recorder.begin();
    advance(recorder, 12345);
    recorder.flush();
    undisturbed = history();
  }
  const RunFolder folder = RunFolder::create(path + "/second", false);
  simulation.restore({});
  std::map<std::string, double> saved;
  {
    Recorder recorder(c, simulation, folder, Comm());
    recorder.begin();
    advance(recorder, 6001);
    recorder.save(saved);
    advance(recorder, 10);  // after the checkpoint, lost
    recorder.flush();
  }
  simulation.restore({0.0, 6001, {}, {}, {}, {}});
  Recorder recorder(c, simulation, folder, Comm());
  recorder.resume(saved);
  advance(recorder, 6344);
  recorder.flush();
  EXPECT_EQ(read_text(folder.history()), undisturbed);
  EXPECT_DOUBLE_EQ(recorder.probes().at("square").max, 12.344 * 12.344) << "of the last sample: every second step";
}

TEST(Recorder, BalanceErrorIsRelativeToTheLargestTerm) {
  EXPECT_DOUBLE_EQ(relative_balance_error({.kinetic = 1.0, .strain = 0.5, .initial = 1.0}), 0.5 / 1.5);
  EXPECT_EQ(relative_balance_error({}), 0.0);
}

}  // namespace
}  // namespace sinew
