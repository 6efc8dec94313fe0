#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fmt/format.h>
#include <limits>
#include <sinew/cli/case_input.hpp>
#include <sinew/cli/case_run.hpp>
#include <sinew/cli/facts_text.hpp>
#include <sinew/cli/number_format.hpp>
#include <sinew/cli/run.hpp>
#include <sinew/cli/threads.hpp>

namespace sinew {

namespace {

/// Steps that solve equations are timed once.
int timed_steps(const Case& c) { return c.solver.is_explicit() ? 3 : 1; }

/// Seconds of the fastest of a few steps.
double seconds_per_step(Simulation& simulation, int steps) {
  double fastest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < steps; ++i) {
    const auto start = std::chrono::steady_clock::now();
    simulation.step(std::numeric_limits<double>::infinity());
    fastest = std::min(fastest, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return fastest;
}

/// A table: what so many ranks would do and send, and how much faster a step would be by the model of the network.
void print_plan(const Simulation& simulation, const std::vector<int>& ranks, double seconds_per_step) {
  const Network network;
  const ModelFacts& facts = simulation.facts();
  const double seconds_a_pair = seconds_per_step / static_cast<double>(facts.pairs);
  fmt::print(
      "ranks  particles a rank  more pairs than the mean   copies  bytes a step  messages a rank  step [ms]  efficiency\n");
  for (const int count : ranks) {
    const RanksPlan plan = simulation.plan(count);
    const double step = network.step(plan, seconds_a_pair);
    fmt::print("{:5}  {:>16}  {:>22.1f} %  {:>5.0f} %  {:>12}  {:>15}  {:>9.3g}  {:>8.0f} %\n", count,
               count_text(plan.particles_most), 100.0 * plan.pairs_imbalance, 100.0 * plan.copies_share, bytes_text(plan.bytes),
               plan.messages_most, 1e3 * step, 100.0 * seconds_per_step / (step * count));
  }
  fmt::print(
      "counted from the decomposition; time: {:.3g} ns a pair, as timed here with the threads above for each rank, {:.2g} us a "
      "message and {:.3g} GB/s for each rank, nothing overlapped\n",
      1e9 * seconds_a_pair, 1e6 * network.latency, 1e-9 * network.bandwidth);
  if (const int most = *std::max_element(ranks.begin(), ranks.end()); most > facts.blocks)
    fmt::print(
        "the case has {} blocks: more ranks than that have nothing to do. A smaller [solver] block_size makes more of them.\n",
        facts.blocks);
}

/// What the first step has found out.
std::string equations_text(Simulation& simulation) {
  const std::map<std::string, double> counts = simulation.equation_counts();
  if (counts.empty()) return "";
  constexpr double bytes_an_entry = 12.0;
  return fmt::format("the first step: {} Newton iterations, {} linear ones, {} cut back; matrix {}, all memory {} so far\n",
                     counts.at("newton_iterations"), counts.at("linear_iterations"), counts.at("cut_backs"),
                     bytes_text(bytes_an_entry * counts.at("matrix_entries")),
                     bytes_text(static_cast<double>(peak_memory_bytes())));
}

/// Prints what one run would be; returns the seconds that it would take.
double check_one(const Case& c, const std::vector<int>& ranks) {
  const std::unique_ptr<Simulation> simulation = Simulation::build(c);
  fmt::print("{}\n", facts_text(c, simulation->facts()));
  const int steps = timed_steps(c);
  const double step = seconds_per_step(*simulation, steps);
  const double seconds = step * estimated_steps(c, simulation->facts());
  fmt::print("{}", equations_text(*simulation));
  fmt::print("estimated run time: {} (from timing {} step{}, without output; it grows if the time step shrinks)\n",
             duration_text(seconds), steps, steps == 1 ? "" : "s");
  if (!ranks.empty()) print_plan(*simulation, ranks, step);
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
    check_one(c, options.plan);
    return done;
  }
  double seconds = 0.0;
  const std::vector<StudyPoint> points = study_points(c, Tier::full);
  for (std::size_t i = 0; i < points.size(); ++i) {
    fmt::print("\nrun {} of {}: {}\n", i + 1, points.size(), parameters_text(points[i].values));
    seconds += check_one(make_case(study_member(input.root, points[i].values), input.folder), options.plan);
  }
  fmt::print("\nestimated run time of the study: {}\n", duration_text(seconds));
  return done;
}

}  // namespace sinew
