#pragma once
/// The factor of safety of a strength reduction: the least factor with which the largest displacement does not come to rest. Islam & Peng (2019), sec. 5.2.

#include <sinew/cli/expect.hpp>

namespace sinew {

/// A run with one factor.
struct SafetyRow {
  double factor = 0.0;
  double begin = 0.0;   ///< from where on it is looked at: of the last stage [time]
  double growth = 0.0;  ///< of the largest value of the probe since then, so that swinging does not count
  double share = 0.0;   ///< of that, in the last part
  bool completed = false;
  bool fails = false;  ///< it goes on growing, or the run has ended early
};

/// By factor.
std::vector<SafetyRow> safety_rows(const SafetyCase& safety, std::span<const FinishedRun> runs);

/// The least factor of a run that fails although all with smaller ones are stable. Not-a-number if none fails, or the first one does.
double factor_of_safety(std::span<const SafetyRow> rows);

/// The rows and what follows from them, for the terminal.
std::string safety_text(const SafetyCase& safety, std::span<const SafetyRow> rows);

/// factor,time,value of the probe, for plots.
std::string safety_curves(const SafetyCase& safety, std::span<const FinishedRun> runs);

}  // namespace sinew
