#include <sinew/cli/measure.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace sinew {

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// Relative to the last time: an end time that is reached up to rounding is reached.
constexpr double time_rounding = 1e-9;

double interpolate(double a, double b, double share) { return a + share * (b - a); }

}  // namespace

double value_at(const Samples& samples, double time) {
  const std::vector<double>& t = samples.time;
  if (t.empty()) return not_a_number;
  const double slack = time_rounding * std::max(std::abs(t.front()), std::abs(t.back()));
  if (!(time >= t.front() - slack && time <= t.back() + slack)) return not_a_number;
  const std::size_t after = std::upper_bound(t.begin(), t.end(), time) - t.begin();
  if (after == 0) return samples.value.front();
  if (after == t.size()) return samples.value.back();
  return interpolate(samples.value[after - 1], samples.value[after], (time - t[after - 1]) / (t[after] - t[after - 1]));
}

double time_mean(const Samples& samples) {
  const auto& [t, v] = samples;
  if (t.empty()) return not_a_number;
  const double duration = t.back() - t.front();
  if (!(duration > 0.0)) return v.back();
  double integral = 0.0;
  for (std::size_t i = 1; i < t.size(); ++i) integral += 0.5 * (v[i - 1] + v[i]) * (t[i] - t[i - 1]);
  return integral / duration;
}

double mean_period(const Samples& samples) {
  const auto& [t, v] = samples;
  const double mean = time_mean(samples);
  double first = 0.0, last = 0.0;
  int crossings = 0;
  for (std::size_t i = 1; i < t.size(); ++i) {
    if (!(v[i - 1] < mean && v[i] >= mean)) continue;
    last = interpolate(t[i - 1], t[i], (mean - v[i - 1]) / (v[i] - v[i - 1]));
    if (crossings++ == 0) first = last;
  }
  return crossings < 2 ? not_a_number : (last - first) / (crossings - 1);
}

double relative_drift(const Samples& samples) {
  if (samples.value.empty()) return not_a_number;
  const double first = samples.value.front();
  double largest = 0.0;
  for (const double value : samples.value) largest = std::max(largest, std::abs(value - first));
  return largest / std::abs(first);
}

double convergence_rate(std::span<const double> parameter, std::span<const double> error) {
  const std::size_t count = parameter.size();
  double mean_x = 0.0, mean_y = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    if (!(parameter[i] > 0.0) || !(error[i] > 0.0)) return not_a_number;
    mean_x += std::log(parameter[i]) / static_cast<double>(count);
    mean_y += std::log(error[i]) / static_cast<double>(count);
  }
  double xx = 0.0, xy = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = std::log(parameter[i]) - mean_x;
    xx += x * x;
    xy += x * (std::log(error[i]) - mean_y);
  }
  return xx > 0.0 ? -xy / xx : not_a_number;
}

double measure(const Samples& samples, std::string_view reduction, double time) {
  if (samples.value.empty()) return not_a_number;
  const auto [min, max] = std::minmax_element(samples.value.begin(), samples.value.end());
  if (reduction == "final") return samples.value.back();
  if (reduction == "min") return *min;
  if (reduction == "max") return *max;
  if (reduction == "range") return *max - *min;
  if (reduction == "at") return value_at(samples, time);
  if (reduction == "period") return mean_period(samples);
  if (reduction == "frequency") return 1.0 / mean_period(samples);
  if (reduction == "drift") return relative_drift(samples);
  throw std::invalid_argument("measure: no reduction \"" + std::string(reduction) + "\"");
}

}  // namespace sinew
