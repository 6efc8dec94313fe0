#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sinew/core/error.hpp>
#include <sinew/io/picture/scalar.hpp>
#include <sinew/io/picture/ticks.hpp>
#include <sstream>
#include <string_view>

namespace sinew {

namespace {

constexpr std::array<std::string_view, 7> proper_names{"mises", "cauchy", "kirchhoff", "piola", "green", "lagrange", "almansi"};
/// A spread below this part of the largest value is rounding: the field is shown as constant.
constexpr double rounding_spread = 1e-9;

const FieldData& find_field(const Snapshot& snapshot, const std::string& name) {
  std::vector<std::string> known;
  for (const FieldData& field : snapshot.fields) {
    if (field.name == name) return field;
    known.push_back(field.name);
  }
  throw CaseError("picture: " + unknown_name_message("field", name, known));
}

std::vector<std::string> component_names(int components) {
  switch (components) {
    case 3: return {"x", "y", "z"};
    case 6: return {"xx", "yy", "zz", "xy", "yz", "xz"};
    case 9: return {"xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"};
    default: return {};
  }
}

/// The place of a component, or -1 for the magnitude (of a scalar: its value).
int find_component(const FieldData& field, const std::string& name) {
  if (name.empty() || (name == "magnitude" && field.components > 1)) return field.components == 1 ? 0 : -1;
  std::vector<std::string> known = component_names(field.components);
  for (const std::string& alias : {name, std::string(name.rbegin(), name.rend())}) {  // a symmetric tensor has no yx of its own
    const auto found = std::find(known.begin(), known.end(), alias);
    if (found != known.end()) return static_cast<int>(found - known.begin());
  }
  if (known.empty()) throw CaseError("picture: field \"" + field.name + "\" is a scalar; it has no component \"" + name + "\".");
  known.push_back("magnitude");
  throw CaseError("picture: field \"" + field.name + "\": " + unknown_name_message("component", name, known));
}

/// Euclidean length of a vector, Frobenius norm of a tensor (the off-diagonal of a symmetric one counts twice).
double magnitude(const double* value, int components) {
  double sum = 0.0;
  for (int c = 0; c < components; ++c) sum += (components == 6 && c >= 3 ? 2.0 : 1.0) * value[c] * value[c];
  return std::sqrt(sum);
}

std::vector<double> extract(const FieldData& field, int component) {
  const std::size_t count = field.values.size() / static_cast<std::size_t>(field.components);
  std::vector<double> values(count);
  for (std::size_t p = 0; p < count; ++p) {
    const double* value = field.values.data() + p * static_cast<std::size_t>(field.components);
    values[p] = component < 0 ? magnitude(value, field.components) : value[component];
    if (!std::isfinite(values[p])) values[p] = std::numeric_limits<double>::quiet_NaN();
  }
  return values;
}

struct Range {
  double low = 0.0, high = 0.0;
};

Range data_range(const std::vector<double>& values) {
  Range range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const double value : values)
    if (!std::isnan(value)) range = {std::min(range.low, value), std::max(range.high, value)};
  return range.low > range.high ? Range{} : range;
}

bool is_tension_like(const FieldData& field, int component) {
  const bool is_tensor_component = component >= 0 && field.components >= 6;
  return field.name.find("pressure") != std::string::npos ||
         (is_tensor_component &&
          (field.name.find("stress") != std::string::npos || field.name.find("strain") != std::string::npos));
}

/// Positive values start at zero unless they vary little about something else (a density, a stretch).
Range sequential_range(Range data) {
  if (data.low >= 0.0 && data.low < 0.3 * data.high) data.low = 0.0;
  return data;
}

/// Widened to half steps of the ticks, so that the color bar ends at round numbers.
Range rounded_range(const Range& range) {
  const Ticks ticks = nice_ticks(range.low, range.high, most_color_ticks);
  if (ticks.at.size() < 2) return range;
  const double step = 0.5 * (ticks.at[1] - ticks.at[0]), slack = 1e-6;
  return {step * std::floor(range.low / step + slack), step * std::ceil(range.high / step - slack)};
}

void choose_range(PictureScalar& scalar, Range data, const PictureOptions& options, double factor) {
  Range range = data;
  if (scalar.map == ColorMap::diverging) {
    const double largest = std::max(std::abs(data.low), std::abs(data.high));
    range = {-largest, largest};
  } else {
    range = sequential_range(data);
  }
  if (range.high - range.low > rounding_spread * std::max(std::abs(range.low), std::abs(range.high)))
    range = rounded_range(range);
  if (options.low) range.low = *options.low * factor;
  if (options.high) range.high = *options.high * factor;
  const double size = std::max(std::abs(range.low), std::abs(range.high));
  if (!(range.high - range.low > rounding_spread * size)) {
    const double middle = 0.5 * (range.low + range.high), half = size > 0.0 ? 0.1 * size : 1.0;
    range = scalar.map == ColorMap::sequential && size == 0.0 ? Range{0.0, 1.0} : Range{middle - half, middle + half};
  }
  scalar.low = range.low;
  scalar.high = range.high;
  const double slack = rounding_spread * (range.high - range.low);
  scalar.below = data.low < range.low - slack;
  scalar.above = data.high > range.high + slack;
}

std::string label_of(const FieldData& field, int component, const std::string& unit) {
  std::string label = plain_words(field.name);
  if (component < 0)
    label += " magnitude";
  else if (field.components > 1)
    label += " " + component_names(field.components)[static_cast<std::size_t>(component)];
  return unit.empty() ? label : label + " [" + unit + "]";
}

}  // namespace

std::string plain_words(const std::string& name) {
  std::string spaced = name, text;
  std::replace(spaced.begin(), spaced.end(), '_', ' ');
  std::istringstream words(spaced);
  for (std::string word; words >> word;) {
    if (std::find(proper_names.begin(), proper_names.end(), word) != proper_names.end())
      word[0] = static_cast<char>(word[0] - 'a' + 'A');
    text += (text.empty() ? "" : " ") + word;
  }
  return text;
}

PictureScalar select_scalar(const Snapshot& snapshot, const PictureOptions& options) {
  const FieldData& field = find_field(snapshot, options.field);
  const int component = find_component(field, options.component);
  PictureScalar scalar;
  scalar.values = extract(field, component);
  Range data = data_range(scalar.values);
  const double largest = std::max(
      {std::abs(data.low), std::abs(data.high), std::abs(options.low.value_or(0.0)), std::abs(options.high.value_or(0.0))});
  const DisplayUnit unit = display_unit(field.unit, largest);
  for (double& value : scalar.values) value *= unit.factor;
  data = {data.low * unit.factor, data.high * unit.factor};
  scalar.label = label_of(field, component, unit.name);
  const bool has_negative = data.low < -rounding_spread * std::abs(data.high);
  scalar.map = has_negative || is_tension_like(field, component) ? ColorMap::diverging : ColorMap::sequential;
  choose_range(scalar, data, options, unit.factor);
  return scalar;
}

}  // namespace sinew
