#include <chrono>
#include <filesystem>
#include <fmt/format.h>
#include <map>
#include <sinew/cli/child_process.hpp>
#include <sinew/cli/interruption.hpp>
#include <sinew/cli/number_format.hpp>
#include <sinew/cli/options.hpp>
#include <sinew/cli/threads.hpp>
#include <sinew/cli/verify_cases.hpp>
#include <sinew/io/file.hpp>

namespace sinew {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

/// Runs the cases as processes of their own, a few at a time.
class VerifyRuns {
 public:
  VerifyRuns(const VerifyOptions& options_, const std::vector<VerifyCase>& cases_, int threads_)
      : options(options_),
        cases(cases_),
        threads(threads_),
        results(cases_.size()) {}

  std::vector<VerifyResult> run() {
    for (std::size_t next = 0; next < cases.size() || !running.empty();) {
      if (interruption_requested()) return stop();
      if (next < cases.size() && static_cast<int>(running.size()) < options.jobs) {
        start(next++);
      } else if (!running.empty()) {
        const ChildEnd end = wait_for_child();
        if (end.process >= 0) collect(end);
      }
    }
    return std::move(results);
  }

 private:
  struct Running {
    std::size_t index;
    Clock::time_point start;
  };

  std::string folder(std::size_t i) const { return options.folder + "/" + cases[i].name; }
  std::string output(std::size_t i) const { return folder(i) + ".txt"; }

  void start(std::size_t i) {
    results[i].problem = cases[i].problem;
    if (cases[i].skipped || !cases[i].problem.empty()) return;
    const std::vector<std::string> arguments{"run",
                                             "--quiet",
                                             "--force",
                                             "-o",
                                             folder(i),
                                             "-t",
                                             std::to_string(threads),
                                             "--tier",
                                             options.tier == Tier::full ? "full" : "quick",
                                             cases[i].path};
    fs::remove(folder(i) + "/summary.json");
    running[start_child(arguments, output(i))] = {i, Clock::now()};
  }

  void collect(const ChildEnd& end) {
    const auto found = running.find(end.process);
    if (found == running.end()) return;
    const std::size_t i = found->second.index;
    results[i].seconds = Seconds(Clock::now() - found->second.start).count();
    running.erase(found);
    try {
      if (end.exit_code != done && end.exit_code != simulation_failed)
        results[i].problem = fmt::format("exit code {}: {}", end.exit_code, read_text(output(i)));
      else
        results[i].rows = read_summary(folder(i) + "/summary.json").expect;
    } catch (const CaseError&) {
      results[i].problem = "no summary.json was written: " + read_text(output(i));
    }
    if (results[i].problem.empty()) fs::remove(output(i));
    while (results[i].problem.ends_with('\n')) results[i].problem.pop_back();
  }

  std::vector<VerifyResult> stop() {
    for (const auto& [process, run] : running) stop_child(process);
    while (!running.empty()) {
      const ChildEnd end = wait_for_child();
      running.erase(end.process);
    }
    return std::move(results);
  }

  const VerifyOptions& options;
  const std::vector<VerifyCase>& cases;
  int threads;
  std::vector<VerifyResult> results;
  std::map<int, Running> running;
};

}  // namespace

int verify_verb(const VerifyOptions& options) {
  const Clock::time_point start = Clock::now();
  if (Comm::launched())
    throw CaseError("verify starts processes of its own: leave out mpiexec, and choose with -j how many cases run at a time.");
  const int all_threads = use_threads(options, Comm());
  if (options.jobs < 1) throw CaseError("-j: at least 1 case has to run at a time, found " + std::to_string(options.jobs));
  const int threads = options.threads > 0 ? options.threads : std::max(1, all_threads / options.jobs);
  const std::vector<VerifyCase> cases = find_verify_cases(options.paths, options.tier);
  std::error_code error;
  fs::create_directories(options.folder, error);
  if (error) throw CaseError("cannot make the folder " + options.folder + ": " + error.message() + ". Choose another with -o.");
  listen_for_interruption();
  const std::vector<VerifyResult> results = VerifyRuns(options, cases, threads).run();
  if (interruption_requested()) {
    fmt::print(stderr, "verify: interrupted\n");
    return interrupted;
  }
  if (!options.json.empty()) write_atomically(options.json, verify_json(cases, results));
  const VerifyCounts counts = count_rows(cases, results);
  fmt::print("{}{} rows passed, {} failed, {} skipped in {}\n", verify_table(cases, results), counts.passed, counts.failed,
             counts.skipped, duration_text(Seconds(Clock::now() - start).count()));
  return counts.failed > 0 ? verification_failed : done;
}

}  // namespace sinew
