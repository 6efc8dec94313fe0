#include <sinew/cli/expect.hpp>
#include <sinew/cli/safety.hpp>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace sinew {

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

bool about_the_run(const ExpectCase& expect) { return expect.quantity == "status" || expect.quantity == "end_time"; }

bool expects_status(const std::vector<ExpectCase>& expects) {
  return std::any_of(expects.begin(), expects.end(), [](const ExpectCase& e) { return e.quantity == "status"; });
}

ExpectSummary check_one(const ExpectCase& expect, const FinishedRun& run, bool may_stop) {
  ExpectSummary row = compare(expect, expected_quantity(expect, run));
  row.pass = row.pass && (run.completed || may_stop || about_the_run(expect));
  return row;
}

}  // namespace

bool included(const ExpectCase& expect, Tier tier) { return tier == Tier::full || expect.tier != "full"; }

bool matches(const ExpectCase& expect, const std::vector<std::pair<std::string, double>>& parameters) {
  return std::all_of(expect.with.begin(), expect.with.end(), [&](const std::pair<std::string, double>& wanted) {
    return std::find(parameters.begin(), parameters.end(), wanted) != parameters.end();
  });
}

double expected_quantity(const ExpectCase& expect, const FinishedRun& run) {
  if (expect.quantity == "status") return run.completed ? 1.0 : 0.0;
  if (expect.quantity == "end_time") return run.end_time;
  const auto found = run.probes.find(expect.probe);
  if (found == run.probes.end() || found->second.samples.value.empty()) return not_a_number;
  const ProbeRecord& probe = found->second;
  if (expect.reduction == "min") return probe.min;
  if (expect.reduction == "max") return probe.max;
  if (expect.reduction == "range") return probe.max - probe.min;
  return measure(probe.samples, expect.reduction, expect.time);
}

double expected_rate(const ExpectCase& expect, std::span<const FinishedRun> runs) {
  ExpectCase final_value = expect;
  final_value.reduction = "final";
  std::vector<double> parameter, error;
  for (const FinishedRun& run : runs) {
    if (!matches(expect, run.parameters)) continue;
    if (!run.completed || run.parameters.empty()) return not_a_number;
    parameter.push_back(run.parameters.front().second);
    error.push_back(std::abs(expected_quantity(final_value, run) - expect.exact.value_or(0.0)));
  }
  return convergence_rate(parameter, error);
}

ExpectSummary compare(const ExpectCase& expect, double computed) {
  ExpectSummary row;
  row.quantity = expect.quantity;
  row.value = computed;
  row.published = expect.value;
  row.tolerance = expect.tolerance;
  row.absolute = expect.absolute;
  row.why = expect.why;
  row.source = expect.source;
  row.note = expect.note;
  const double difference = std::abs(computed - expect.value);
  if (expect.absolute) row.pass = difference <= *expect.absolute;
  if (expect.tolerance) row.pass = row.pass || difference <= *expect.tolerance * std::abs(expect.value);
  return row;
}

std::vector<ExpectSummary> check_expects(const std::vector<ExpectCase>& expects, const FinishedRun& run, Tier tier) {
  std::vector<ExpectSummary> rows;
  for (const ExpectCase& expect : expects)
    if (included(expect, tier)) rows.push_back(check_one(expect, run, expects_status(expects)));
  return rows;
}

std::vector<ExpectSummary> check_study(const std::vector<ExpectCase>& expects, std::span<const FinishedRun> runs, Tier tier,
                                       const std::optional<SafetyCase>& safety) {
  std::vector<ExpectSummary> rows;
  for (const ExpectCase& expect : expects) {
    if (!included(expect, tier)) continue;
    if (expect.quantity == "safety_factor") {
      rows.push_back(compare(expect, factor_of_safety(safety_rows(*safety, runs))));
      continue;
    }
    if (expect.reduction == "rate") {
      rows.push_back(compare(expect, expected_rate(expect, runs)));
      if (!expect.with.empty()) rows.back().quantity += " (" + parameters_text(expect.with) + ")";
      continue;
    }
    for (const FinishedRun& run : runs) {
      if (!matches(expect, run.parameters)) continue;
      rows.push_back(check_one(expect, run, expects_status(expects)));
      rows.back().quantity += " (" + parameters_text(run.parameters) + ")";
    }
  }
  return rows;
}

std::string parameters_text(const std::vector<std::pair<std::string, double>>& parameters) {
  std::string text;
  for (const auto& [path, value] : parameters) text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", path, value);
  return text;
}

std::string difference_text(const ExpectSummary& row) {
  if (row.absolute) return fmt::format("{:.3g}", row.value - row.published);
  return fmt::format("{:.2f} %", 100.0 * (row.value / row.published - 1.0));
}

std::string allowed_text(const ExpectSummary& row) {
  if (row.absolute) return fmt::format("{:.3g}", *row.absolute);
  return fmt::format("{:.4g} %", 100.0 * row.tolerance.value_or(0.0));
}

std::string row_text(const ExpectSummary& row) {
  return fmt::format("  {}: published {:.6g}, computed {:.6g}, difference {}, allowed {}: {}", row.quantity, row.published,
                     row.value, difference_text(row), allowed_text(row), row.pass ? "ok" : "MISSED");
}

}  // namespace sinew
