#pragma once
/// A run in stages: one simulation after the other, each of which takes over the state of the one before.

#include <sinew/model/simulation.hpp>

namespace sinew {

class StagedSimulation final : public Simulation {
 public:
  StagedSimulation(const Case& c, const Comm& comm);

  const ModelFacts& facts() const override { return now_->facts(); }
  double time() const override { return now_->time(); }
  double end_time() const override;
  std::string stage() const override { return current().name; }
  long steps() const override { return now_->steps(); }
  double stable_time_step() const override { return now_->stable_time_step(); }
  void step(double most) override;
  void stop_when(const std::function<bool()>& stop) override {
    stop_ = stop;
    now_->stop_when(stop_);
  }
  void expect_record() override { now_->expect_record(); }

  Energies energies() override { return now_->energies(); }
  Momenta momenta() override { return now_->momenta(); }
  double imbalance() override { return now_->imbalance(); }
  bool probes_need_record() const override { return now_->probes_need_record(); }
  std::vector<double> probe_values() override { return now_->probe_values(); }
  std::vector<std::string> probe_units() const override { return now_->probe_units(); }
  void fill_snapshot(const std::vector<std::string>& fields, Snapshot& snapshot) override {
    now_->fill_snapshot(fields, snapshot);
  }
  Snapshot snapshot(const std::vector<std::string>& fields) override { return now_->snapshot(fields); }

  std::string state_hash() const override { return now_->state_hash(); }
  SavedState save() override;
  void restore(const SavedState& state) override;
  void take_over(SavedState state, const Handover& handover) override { now_->take_over(std::move(state), handover); }
  RanksPlan plan(int ranks) const override { return now_->plan(ranks); }
  std::map<std::string, double> pass_seconds() const override;
  std::map<std::string, double> equation_counts() override { return now_->equation_counts(); }

 private:
  const StageCase& current() const { return stages_[number_]; }
  bool is_last() const { return number_ + 1 == stages_.size(); }
  double stage_end() const { return begin_ + current().duration; }
  void build();
  bool is_over();
  void enter_next();

  std::vector<StageCase> stages_;
  std::string folder_;
  Comm comm_;
  std::size_t number_ = 0;  ///< of the stage
  double begin_ = 0.0;      ///< when it began
  bool over_ = false;       ///< whether the last one has ended
  std::function<bool()> stop_;
  std::unique_ptr<Simulation> now_;
  std::map<std::string, double> earlier_seconds_;
};

}  // namespace sinew
