#include <sinew/cli/case_run.hpp>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <sinew/cli/interruption.hpp>
#include <sinew/cli/number_format.hpp>
#include <sinew/cli/progress.hpp>
#include <sinew/cli/schedule.hpp>
#include <sinew/io/file.hpp>
#include <sinew/io/picture.hpp>
#include <sinew/io/write_toml.hpp>
#include <sinew/model/fields.hpp>

namespace sinew {

namespace {

using Seconds = std::chrono::duration<double>;

VtkReal real_of(const OutputCase& output) { return output.precision == "single" ? VtkReal::float32 : VtkReal::float64; }

}  // namespace

ExitCode exit_code(const std::string& status) {
  if (status == "completed") return done;
  return status == "interrupted" ? interrupted : simulation_failed;
}

CaseRun::CaseRun(const Case& case_, Simulation& simulation_, const RunFolder& folder_, Reporter& reporter_,
                 const RunControl& control_)
    : c(case_),
      simulation(simulation_),
      folder(folder_),
      reporter(reporter_),
      control(control_),
      recorder(case_, simulation_, folder_, control_.comm),
      case_text(toml_text(case_.resolved)),
      frames_need_record(std::any_of(case_.output.fields.begin(), case_.output.fields.end(),
                                     [](const std::string& field) { return needs_record(field); })) {
  simulation.stop_when([&comm = control.comm] { return comm.any(interruption_requested()); });
}

void CaseRun::begin() {
  control.comm.on_root([&] { write_atomically(folder.resolved_case(), case_text); });
  frames.emplace(folder, PvdSeries(folder.series()), real_of(c.output), control.comm);
  write_frame();
  recorder.begin();
}

void CaseRun::resume(const Checkpoint& checkpoint) {
  SavedState state{checkpoint.time, checkpoint.step, checkpoint.numbers, checkpoint.arrays, checkpoint.range, {}};
  for (const auto& [name, field] : checkpoint.fields) state.fields[name] = {field.width, field.rows};
  simulation.restore(state);
  std::optional<PvdSeries> series;
  control.comm.on_root([&] { write_atomically(folder.resolved_case(), case_text); });
  control.comm.together([&] { series = PvdSeries::resume(folder.series(), checkpoint.time); });
  control.comm.on_root([&] { series->rewrite(); });
  frames.emplace(folder, std::move(*series), real_of(c.output), control.comm);
  recorder.resume(checkpoint.numbers);
  if (const auto begin = checkpoint.numbers.find("run.stage_begin"); begin != checkpoint.numbers.end())
    stage_begin = begin->second;
  last_frame_step = static_cast<long>(checkpoint.numbers.at("run.last_frame_step"));
  earlier_seconds = checkpoint.numbers.at("run.wall_seconds");
  stepping_seconds = checkpoint.numbers.at("run.stepping_seconds");
}

bool CaseRun::at_end() const {
  if (c.solver.max_steps && simulation.steps() >= *c.solver.max_steps) return true;
  const double end = simulation.end_time(), left = end - simulation.time();
  if (std::isinf(end)) return false;
  return left <= std::max(1e-9 * simulation.stable_time_step(), 4.0 * std::numeric_limits<double>::epsilon() * end);
}

RunResult CaseRun::to_the_end() {
  attempt([&] { march(); });
  reporter.clear_bar();
  write_rest();
  FinishedRun finished{status == "completed", simulation.time(), recorder.probes(), {}, stage_begin};
  RunResult result{summarize(finished), std::move(finished)};
  attempt([&] { control.comm.on_root([&] { write_summary(folder.summary(), result.summary); }); });
  result.summary.status = status;
  say_end(result.summary);
  return result;
}

void CaseRun::march() {
  const auto state = [&] { return ProgressState{fraction(), simulation.time(), simulation.steps(), recorder.energy_drift()}; };
  Progress progress(reporter, simulation.facts().particles, c.general.units.name_of("s"), state());
  while (status == "completed" && !at_end()) {
    if (control.comm.any(interruption_requested())) {
      status = "interrupted";
      break;
    }
    const double before = simulation.time();
    const std::string stage = simulation.stage();
    if (!step()) continue;
    if (status != "completed") break;
    if (simulation.stage() != stage) say_stage();
    write_due(before);
    progress.update(state());
  }
}

void CaseRun::say_stage() {
  stage_begin = simulation.time();
  reporter.clear_bar();
  reporter.say(
      fmt::format("stage \"{}\" begins at t = {}", simulation.stage(), quantity_text(stage_begin, c.general.units.name_of("s"))));
}

/// Whether a frame or a row with F or stresses follows the step.
bool CaseRun::record_follows(double now, double next) const {
  return (frames_need_record && multiple_reached(now, next, c.output.every)) ||
         (simulation.probes_need_record() && recorder.is_due(now, next, simulation.steps() + 1));
}

/// Returns whether it was taken; not, if it was stopped on its way.
bool CaseRun::step() {
  const Clock::time_point start = Clock::now();
  try {
    const double now = simulation.time(), most = simulation.end_time() - now;
    const double next = now + std::min(simulation.stable_time_step(), most);
    if (record_follows(now, next)) simulation.expect_record();
    simulation.step(most);
  } catch (const StepStopped&) {
    stepping_seconds += Seconds(Clock::now() - start).count();
    return false;
  } catch (const NoBalance& error) {
    status = "no balance";
    message = error.what();
  } catch (const SimulationError& error) {
    status = "unstable";
    message = error.what();
  }
  stepping_seconds += Seconds(Clock::now() - start).count();
  return true;
}

void CaseRun::write_due(double time_before) {
  recorder.after_step(time_before);
  if (multiple_reached(time_before, simulation.time(), c.output.every)) write_frame();
  if (multiple_reached(time_before, simulation.time(), c.output.checkpoint_every)) write_state();
}

void CaseRun::write_frame() {
  Snapshot snapshot = frames->spent();
  simulation.fill_snapshot(c.output.fields, snapshot);
  frames->write(std::move(snapshot));
  last_frame_step = simulation.steps();
}

void CaseRun::write_state() {
  frames->drain();
  recorder.flush();
  SavedState state = simulation.save();
  recorder.save(state.numbers);
  state.numbers["run.stage_begin"] = stage_begin;
  state.numbers["run.last_frame_step"] = static_cast<double>(last_frame_step);
  state.numbers["run.wall_seconds"] = wall_seconds();
  state.numbers["run.stepping_seconds"] = stepping_seconds;
  Checkpoint checkpoint{state.time, state.step,  case_text, std::move(state.numbers), std::move(state.arrays),
                        {},         state.range, {}};
  for (auto& [name, field] : state.fields) checkpoint.fields[name] = {field.width, std::move(field.rows)};
  write_checkpoint(folder.checkpoint(), checkpoint, control.comm);
}

void CaseRun::write_pictures() {
  std::vector<std::string> files;
  if (!c.output.picture.empty()) files.push_back(folder.file(c.output.picture));
  if (!control.picture.empty()) files.push_back(control.picture);
  if (files.empty()) return;
  const Snapshot snapshot = simulation.snapshot({c.output.picture_field, "deformation_gradient"});
  PictureOptions options;
  options.field = c.output.picture_field;
  options.title = c.general.name;
  control.comm.on_root([&] {
    for (const std::string& file : files) write_picture(file, snapshot, options);
  });
}

/// Runs it; if it fails because of the disk or the state, that becomes the status, unless something failed before.
template <class Action>
void CaseRun::attempt(Action&& action) {
  try {
    action();
  } catch (const SimulationError& error) {
    if (status == "unstable" || status == "failed") return;
    status = "failed";
    message = error.what();
  }
}

void CaseRun::write_rest() {
  if (status == "completed") {
    attempt([&] { recorder.at_end(); });
    attempt([&] { write_pictures(); });
  }
  if (status != "interrupted" && last_frame_step != simulation.steps()) attempt([&] { write_frame(); });
  attempt([&] { frames->drain(); });
  if (status == "unstable")
    attempt([&] { recorder.flush(); });
  else
    attempt([&] { write_state(); });
}

double CaseRun::fraction() const {
  double share = simulation.time() / simulation.end_time();
  if (c.solver.max_steps)
    share = std::max(share, static_cast<double>(simulation.steps()) / static_cast<double>(*c.solver.max_steps));
  return std::min(share, 1.0);
}

double CaseRun::wall_seconds() const { return earlier_seconds + Seconds(Clock::now() - begin_time).count(); }

}  // namespace sinew
