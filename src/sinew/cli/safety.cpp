#include <sinew/cli/safety.hpp>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace sinew {

namespace {

SafetyRow row_of(const SafetyCase& safety, const FinishedRun& run) {
  SafetyRow row{run.parameters.front().second, run.stage_begin};
  row.completed = run.completed;
  const auto probe = run.probes.find(safety.probe);
  if (!run.completed || probe == run.probes.end() || probe->second.samples.value.empty()) {
    row.fails = true;
    return row;
  }
  const Samples& samples = probe->second.samples;
  const auto begin = std::lower_bound(samples.time.begin(), samples.time.end(), row.begin) - samples.time.begin();
  const double end = samples.time.back(), last = end - safety.last * (end - row.begin);
  double before = samples.value[begin], most = before;
  for (auto k = static_cast<std::size_t>(begin); k < samples.time.size(); ++k) {
    most = std::max(most, samples.value[k]);
    if (samples.time[k] <= last) before = most;
  }
  row.growth = most - samples.value[begin];
  row.share = row.growth > 0.0 ? (most - before) / row.growth : 0.0;
  row.fails = row.share > safety.share;
  return row;
}

}  // namespace

std::vector<SafetyRow> safety_rows(const SafetyCase& safety, std::span<const FinishedRun> runs) {
  std::vector<SafetyRow> rows;
  for (const FinishedRun& run : runs) rows.push_back(row_of(safety, run));
  std::sort(rows.begin(), rows.end(), [](const SafetyRow& a, const SafetyRow& b) { return a.factor < b.factor; });
  return rows;
}

double factor_of_safety(std::span<const SafetyRow> rows) {
  const auto first = std::find_if(rows.begin(), rows.end(), [](const SafetyRow& row) { return row.fails; });
  return first == rows.end() || first == rows.begin() ? std::numeric_limits<double>::quiet_NaN() : first->factor;
}

std::string safety_text(const SafetyCase& safety, std::span<const SafetyRow> rows) {
  std::string text = fmt::format("factor   growth of {}   of that in the last {:.3g} %\n", safety.probe, 100.0 * safety.last);
  for (const SafetyRow& row : rows)
    text += row.completed ? fmt::format("{:<6.4g}   {:.6g}   {:.3g} %   {}\n", row.factor, row.growth, 100.0 * row.share,
                                        row.fails ? "fails" : "stable")
                          : fmt::format("{:<6.4g}   did not reach its end: fails\n", row.factor);
  const double factor = factor_of_safety(rows);
  if (!std::isnan(factor)) {
    const auto at = std::find_if(rows.begin(), rows.end(), [&](const SafetyRow& row) { return row.factor == factor; });
    return text + fmt::format("factor of safety: {:.4g} (stable up to {:.4g})", factor, std::prev(at)->factor);
  }
  const bool none = std::none_of(rows.begin(), rows.end(), [](const SafetyRow& row) { return row.fails; });
  return text + (none ? "factor of safety: greater than all that were tried" : "factor of safety: less than all that were tried");
}

std::string safety_curves(const SafetyCase& safety, std::span<const FinishedRun> runs) {
  std::string text = "factor,time," + safety.probe + "\n";
  for (const FinishedRun& run : runs)
    if (const auto probe = run.probes.find(safety.probe); probe != run.probes.end()) {
      const Samples& samples = probe->second.samples;
      for (std::size_t k = 0; k < samples.time.size(); ++k)
        text += fmt::format("{},{},{}\n", run.parameters.front().second, samples.time[k], samples.value[k]);
    }
  return text;
}

}  // namespace sinew
