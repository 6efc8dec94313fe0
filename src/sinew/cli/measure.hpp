#pragma once
/// Numbers out of a curve: what `[[expect]]` compares with published values.

#include <span>
#include <string_view>
#include <vector>

namespace sinew {

/// A quantity over time; times never decrease.
struct Samples {
  std::vector<double> time, value;
};

/// Linear interpolation; not-a-number before the first and after the last time (beyond a rounding).
double value_at(const Samples& samples, double time);

/// Mean over time (trapezoidal rule) of the whole record.
double time_mean(const Samples& samples);

/// Mean distance between upward crossings of the time mean, each found by linear interpolation; not-a-number with less than two.
double mean_period(const Samples& samples);

/// max |q(t) - q(0)| / |q(0)|, for quantities that should be constant.
double relative_drift(const Samples& samples);

/// Minus the least-squares slope of log(error) over log(parameter): p where error ~ parameter^-p. Not-a-number with less than two
/// different parameters or an error that is not positive.
double convergence_rate(std::span<const double> parameter, std::span<const double> error);

/// One of final, min, max, range (max - min), at (the given time), period, frequency (1 / period) and drift. Not-a-number where
/// the record is empty.
double measure(const Samples& samples, std::string_view reduction, double time = 0.0);

}  // namespace sinew
