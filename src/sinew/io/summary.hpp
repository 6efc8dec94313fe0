#pragma once
/// What a run was and what came out: summary.json.

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace sinew {

struct ProbeSummary {
  double final = 0.0, min = 0.0, max = 0.0;
  std::string unit;
};

/// One computed against one published value.
struct ExpectSummary {
  std::string quantity;
  double value = 0.0, published = 0.0;
  std::optional<double> tolerance;  ///< relative: |value - published| <= tolerance |published|
  std::optional<double> absolute;   ///< |value - published| <= absolute
  bool pass = false;
  std::string why, source, note;
};

struct Summary {
  std::string status = "completed";  ///< completed | interrupted | unstable | ...
  std::string message;               ///< why a run did not complete
  std::string version, commit, case_name;
  long particles = 0;
  double neighbors = 0.0;  ///< mean number per particle
  long steps = 0;
  double end_time = 0.0;  ///< reached, in the units of the case
  double wall_seconds = 0.0, stepping_seconds = 0.0, particle_steps_per_second = 0.0;
  int ranks = 1, threads = 1;
  long peak_memory_bytes = 0;
  std::string state_hash;                  ///< of positions and velocities, hexadecimal
  std::map<std::string, double> energy;    ///< e.g. kinetic, strain, total, drift
  std::map<std::string, double> momentum;  ///< balance of linear and angular momentum
  std::map<std::string, ProbeSummary> probes;
  std::vector<ExpectSummary> expect;
  std::map<std::string, double> exchange;      ///< between ranks: copies_share, bytes_per_step, messages_per_rank
  std::map<std::string, double> equations;     ///< newton_iterations, linear_iterations, ...; empty for explicit runs
  std::map<std::string, double> pass_timings;  ///< seconds spent in each pass
  std::vector<std::string> warnings;
};

/// As JSON, in the order above; numbers keep every bit; not-a-number and infinity become null.
std::string json_text(const Summary& summary);

/// Throws SimulationError with path and reason.
void write_summary(const std::string& path, const Summary& summary);

/// null becomes not-a-number, an absent key keeps its default. Throws CaseError if missing or not a summary.
Summary read_summary(const std::string& path);

}  // namespace sinew
