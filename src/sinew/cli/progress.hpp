#pragma once
/// How far a run is, a few times a second on a terminal, now and then elsewhere.

#include <chrono>
#include <sinew/cli/reporter.hpp>
#include <string>

namespace sinew {

struct ProgressState {
  double fraction = 0.0;  ///< of the run, from 0 to 1
  double time = 0.0;      ///< simulated
  long steps = 0;
  double energy_drift = 0.0;
};

class Progress {
 public:
  /// `start`: the state in which this process began.
  Progress(Reporter& reporter, long particles, std::string time_unit, const ProgressState& start);
  /// To be called after every step; mostly does nothing. A log line at each 10 % and after 30 s, the bar five times a second.
  void update(const ProgressState& state);

 private:
  using Clock = std::chrono::steady_clock;

  std::string text(const ProgressState& state, double seconds) const;

  Reporter& reporter;
  double particles;
  std::string time_unit;
  ProgressState start;
  Clock::time_point begin = Clock::now(), last_bar = begin, last_line = begin;
  int last_tenth;
};

}  // namespace sinew
