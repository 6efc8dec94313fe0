#include <algorithm>
#include <fmt/format.h>
#include <optional>
#include <sinew/cli/interruption.hpp>
#include <sinew/cli/number_format.hpp>
#include <sinew/cli/run.hpp>
#include <sinew/cli/safety.hpp>
#include <sinew/cli/version.hpp>
#include <sinew/io/file.hpp>
#include <sinew/io/write_toml.hpp>

namespace sinew {

namespace {

using Values = std::vector<std::pair<std::string, double>>;

/// Last part of a key path.
std::string short_name(const std::string& path) { return path.substr(path.rfind('.') + 1); }

std::string folder_name(std::size_t number, const Values& values) {
  std::string name = fmt::format("{:03d}", number);
  for (const auto& [path, value] : values) name += fmt::format("_{}={}", short_name(path), value);
  std::replace(name.begin(), name.end(), '/', '-');
  return name;
}

bool is_needed(const Case& c, const Values& values, Tier tier) {
  if (tier == Tier::full) return true;
  return std::any_of(c.expects.begin(), c.expects.end(),
                     [&](const ExpectCase& expect) { return included(expect, tier) && matches(expect, values); });
}

/// The table of the study while it grows.
class StudyTable {
 public:
  StudyTable(std::string path_, const Case& c) : path(std::move(path_)) {
    text = "run,folder,status";
    for (const auto& [key, values] : c.study.vary) text += "," + key;
    for (const ProbeCase& probe : c.probes) text += "," + probe.name;
    text += '\n';
  }

  void add(std::size_t number, const StudyPoint& point, const Summary& summary, const Case& c) {
    text += fmt::format("{},{},{}", number, point.folder_name, summary.status);
    for (const auto& [key, value] : point.values) text += fmt::format(",{}", value);
    for (const ProbeCase& probe : c.probes) {
      const auto found = summary.probes.find(probe.name);
      text += found == summary.probes.end() ? "," : fmt::format(",{}", found->second.final);
    }
    write_atomically(path, text += '\n');
  }

 private:
  std::string path, text;
};

/// The summary of the whole study: sums of the runs, and the rows.
Summary study_summary(const Case& c, const RunControl& control, const std::vector<Summary>& runs) {
  Summary total;
  total.version = program_version();
  total.commit = program_commit();
  total.case_name = c.general.name;
  total.ranks = control.comm.size();
  total.threads = control.threads;
  double particle_steps = 0.0;
  for (const Summary& run : runs) {
    if (run.status != "completed" && total.status == "completed") {
      total.status = run.status;
      total.message = run.message;
    }
    total.particles = std::max(total.particles, run.particles);
    total.peak_memory_bytes = std::max(total.peak_memory_bytes, run.peak_memory_bytes);
    total.steps += run.steps;
    total.wall_seconds += run.wall_seconds;
    total.stepping_seconds += run.stepping_seconds;
    total.end_time = run.end_time;
    particle_steps += static_cast<double>(run.particles) * static_cast<double>(run.steps);
  }
  if (total.stepping_seconds > 0.0) total.particle_steps_per_second = particle_steps / total.stepping_seconds;
  return total;
}

void say_study_end(Reporter& reporter, const Summary& total, std::size_t count, const std::string& folder) {
  if (!total.expect.empty()) reporter.say("expected values");
  for (const ExpectSummary& row : total.expect) reporter.say(row_text(row));
  reporter.say(fmt::format("study {}: {} runs in {}, results in {} (study.csv, summary.json)", total.status, count,
                           duration_text(total.wall_seconds), folder));
}

/// One run of the study; a simulation that cannot be written counts as failed.
RunResult run_point(const CaseInput& input, const StudyPoint& point, const RunPlan& plan) {
  try {
    return run_case(make_case(study_member(input.root, point.values), input.folder), plan);
  } catch (const SimulationError& error) {
    RunResult failed;
    failed.summary.status = "failed";
    failed.summary.message = error.what();
    return failed;
  }
}

}  // namespace

std::vector<StudyPoint> study_points(const Case& c, Tier tier) {
  std::vector<Values> combinations(1);
  for (const auto& [path, choices] : c.study.vary) {
    std::vector<Values> longer;
    for (const Values& values : combinations)
      for (const double choice : choices) {
        longer.push_back(values);
        longer.back().emplace_back(path, choice);
      }
    combinations = std::move(longer);
  }
  std::vector<StudyPoint> points;
  for (std::size_t i = 0; i < combinations.size(); ++i)
    if (is_needed(c, combinations[i], tier)) points.push_back({combinations[i], folder_name(i + 1, combinations[i])});
  return points;
}

int run_study(const CaseInput& input, const Case& c, const RunPlan& plan) {
  const std::vector<StudyPoint> points = study_points(c, plan.control.tier);
  const Comm& comm = plan.control.comm;
  comm.together([&] {
    for (const StudyPoint& point : points) make_case(study_member(input.root, point.values), input.folder);
  });
  comm.on_root([&] { RunFolder::create(plan.folder, plan.force); });
  const RunFolder folder = RunFolder::at(plan.folder);
  const auto reporter = make_reporter(comm, folder, plan.quiet);
  comm.on_root([&] { write_atomically(folder.resolved_case(), toml_text(c.resolved)); });
  StudyTable table(folder.file("study.csv"), c);
  std::vector<FinishedRun> finished;
  std::vector<Summary> summaries;
  for (std::size_t i = 0; i < points.size() && !comm.any(interruption_requested()); ++i) {
    RunPlan point_plan = plan;
    point_plan.folder = folder.file(points[i].folder_name);
    point_plan.label = fmt::format("run {} of {}", i + 1, points.size());
    reporter->say(point_plan.label + ": " + parameters_text(points[i].values));
    RunResult result = run_point(input, points[i], point_plan);
    result.finished.parameters = points[i].values;
    comm.on_root([&] { table.add(i + 1, points[i], result.summary, c); });
    finished.push_back(std::move(result.finished));
    summaries.push_back(std::move(result.summary));
  }
  Summary total = study_summary(c, plan.control, summaries);
  if (comm.any(interruption_requested()))
    total.status = "interrupted";
  else
    total.expect = check_study(c.expects, finished, plan.control.tier, c.study.safety);
  comm.on_root([&] { write_summary(folder.summary(), total); });
  if (c.study.safety) {
    reporter->say(safety_text(*c.study.safety, safety_rows(*c.study.safety, finished)));
    comm.on_root([&] { write_atomically(folder.file("safety.csv"), safety_curves(*c.study.safety, finished)); });
  }
  say_study_end(*reporter, total, summaries.size(), folder.path());
  return exit_code(total.status);
}

}  // namespace sinew
