#pragma once
/// Published against computed: the rows of `[[expect]]`.

#include <map>
#include <sinew/cli/measure.hpp>
#include <sinew/io/summary.hpp>
#include <sinew/model/case.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace sinew {

/// What a run leaves behind of one probe. The extremes are those of all samples, also of those that the thinned history lacks.
struct ProbeRecord {
  Samples samples;
  double min = 0.0, max = 0.0;
  std::string unit;
};

/// What the expectations need to know of a run.
struct FinishedRun {
  bool completed = false;
  double end_time = 0.0;  ///< reached
  std::map<std::string, ProbeRecord> probes;
  std::vector<std::pair<std::string, double>> parameters;  ///< of the study: key path and value
  double stage_begin = 0.0;                                ///< when the last stage began that was reached
};

/// Which rows are asked for.
enum class Tier { quick, full };

/// Whether the tier includes the row: quick leaves out those marked "full".
bool included(const ExpectCase& expect, Tier tier);

/// Whether the run has the values that `with` asks for.
bool matches(const ExpectCase& expect, const std::vector<std::pair<std::string, double>>& parameters);

/// The computed value: `status` (1 completed, 0 not), `end_time` (reached), or probe.NAME.REDUCTION except rate.
double expected_quantity(const ExpectCase& expect, const FinishedRun& run);

/// probe.NAME.rate: the convergence rate of |final - exact| over the first varied parameter of the runs that match. The runs
/// must all be completed; otherwise not-a-number.
double expected_rate(const ExpectCase& expect, std::span<const FinishedRun> runs);

/// The row of the table: |computed / published - 1| <= tolerance or |computed - published| <= absolute.
ExpectSummary compare(const ExpectCase& expect, double computed);

/// All rows of one run. Those of a run that did not complete only pass if the case expects just that by a row on `status`;
/// the rows on `status` and `end_time` always count.
std::vector<ExpectSummary> check_expects(const std::vector<ExpectCase>& expects, const FinishedRun& run, Tier tier);

/// All rows of a study: one a matching run (its parameters in the name of the quantity), and one for each rate.
std::vector<ExpectSummary> check_study(const std::vector<ExpectCase>& expects, std::span<const FinishedRun> runs, Tier tier,
                                       const std::optional<SafetyCase>& safety = {});

/// "parameters.n = 4, solver.cfl = 0.3".
std::string parameters_text(const std::vector<std::pair<std::string, double>>& parameters);

/// "  probe.tip.max  published 0.1  computed 0.102  difference 2 % of at most 5 %  ok".
std::string row_text(const ExpectSummary& row);
/// The difference as the row judges it: "2.00 %" or "1.3e-05"; and what is allowed.
std::string difference_text(const ExpectSummary& row);
std::string allowed_text(const ExpectSummary& row);

}  // namespace sinew
