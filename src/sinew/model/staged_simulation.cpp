#include <sinew/model/staged_simulation.hpp>

#include <algorithm>
#include <limits>

namespace sinew {

StagedSimulation::StagedSimulation(const Case& c, const Comm& comm) : stages_(c.stages), folder_(c.folder), comm_(comm) {
  build();
}

/// The simulation of the present stage, in its initial state.
void StagedSimulation::build() {
  Case c;
  comm_.together([&] { c = make_case(current().root, folder_); });
  now_ = Simulation::build(c, comm_);
  now_->stop_when(stop_);
}

/// At the latest, as far as it is known.
double StagedSimulation::end_time() const {
  if (over_) return time();
  double end = stage_end();
  for (std::size_t later = number_ + 1; later < stages_.size(); ++later) end += stages_[later].duration;
  return end;
}

void StagedSimulation::step(double most) {
  now_->step(std::min(most, stage_end() - time()));
  if (!is_over()) return;
  if (is_last())
    over_ = true;
  else
    enter_next();
}

/// The balance is looked at from time to time.
bool StagedSimulation::is_over() {
  constexpr long steps_between_looks = 10;
  const double left = stage_end() - time();
  if (left <= std::max(1e-9 * stable_time_step(), 4.0 * std::numeric_limits<double>::epsilon() * stage_end())) return true;
  return current().residual && steps() % steps_between_looks == 0 && now_->imbalance() < *current().residual;
}

void StagedSimulation::enter_next() {
  const double balance = now_->energies().balance_error();
  const SavedState state = now_->save();
  const bool settled = current().settle;
  for (const auto& [pass, seconds] : now_->pass_seconds()) earlier_seconds_[pass] += seconds;
  now_.reset();
  ++number_;
  begin_ = state.time;
  build();
  now_->take_over(state, {balance, settled});
}

SavedState StagedSimulation::save() {
  SavedState state = now_->save();
  state.numbers["stage"] = static_cast<double>(number_);
  state.numbers["stage_begin"] = begin_;
  state.numbers["stages_over"] = over_ ? 1.0 : 0.0;
  return state;
}

void StagedSimulation::restore(const SavedState& state) {
  const auto number = state.numbers.find("stage");
  comm_.together([&] {
    if (number == state.numbers.end() || number->second >= static_cast<double>(stages_.size()))
      throw CaseError("the checkpoint was written with other stages than the case has now. Resume with the case that wrote it.");
  });
  number_ = static_cast<std::size_t>(number->second);
  begin_ = state.numbers.at("stage_begin");
  over_ = state.numbers.at("stages_over") > 0.0;
  if (number_ > 0) build();
  now_->restore(state);
}

std::map<std::string, double> StagedSimulation::pass_seconds() const {
  std::map<std::string, double> seconds = now_->pass_seconds();
  for (const auto& [pass, earlier] : earlier_seconds_) seconds[pass] += earlier;
  return seconds;
}

}  // namespace sinew
