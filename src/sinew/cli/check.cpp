#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fmt/format.h>
#include <limits>
#include <sinew/cli/case_input.hpp>
#include <sinew/cli/facts_text.hpp>
#include <sinew/cli/number_format.hpp>
#include <sinew/cli/run.hpp>
#include <sinew/cli/threads.hpp>

namespace sinew {

namespace {

constexpr int timed_steps = 3;

/// Seconds of the fastest of a few steps.
double seconds_per_step(Simulation& simulation) {
  double fastest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < timed_steps; ++i) {
    const auto start = std::chrono::steady_clock::now();
    simulation.step(std::numeric_limits<double>::infinity());
    fastest = std::min(fastest, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return fastest;
}

/// Prints what one run would be; returns the seconds that it would take.
double check_one(const Case& c) {
  const std::unique_ptr<Simulation> simulation = Simulation::build(c);
  fmt::print("{}\n", facts_text(c, simulation->facts()));
  const double seconds = seconds_per_step(*simulation) * estimated_steps(c, simulation->facts());
  fmt::print("estimated run time: {} (from timing {} steps, without output; it grows if the time step shrinks)\n",
             duration_text(seconds), timed_steps);
  std::fflush(stdout);
  return seconds;
}

}  // namespace

int check_verb(const CheckOptions& options) {
  const int threads = use_threads(options, Comm());
  const CaseInput input = read_case_input(options.case_path, options.overrides);
  const Case c = make_case(input.root, input.folder);
  fmt::print("{} thread{}\n", threads, threads == 1 ? "" : "s");
  if (c.study.vary.empty()) {
    check_one(c);
    return done;
  }
  double seconds = 0.0;
  const std::vector<StudyPoint> points = study_points(c, Tier::full);
  for (std::size_t i = 0; i < points.size(); ++i) {
    fmt::print("\nrun {} of {}: {}\n", i + 1, points.size(), parameters_text(points[i].values));
    seconds += check_one(make_case(study_member(input.root, points[i].values), input.folder));
  }
  fmt::print("\nestimated run time of the study: {}\n", duration_text(seconds));
  return done;
}

}  // namespace sinew
