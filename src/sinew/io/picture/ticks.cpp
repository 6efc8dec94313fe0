#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <sinew/io/picture/ticks.hpp>
#include <string_view>

namespace sinew {

namespace {

constexpr std::string_view minus_sign = "\u2212";
constexpr std::array<std::string_view, 10> superscripts{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};

struct Prefix {
  std::string_view name;
  int exponent;
};
constexpr std::array<Prefix, 7> prefixes{{{"n", -9}, {"µ", -6}, {"m", -3}, {"", 0}, {"k", 3}, {"M", 6}, {"G", 9}}};
constexpr std::array<std::string_view, 6> prefixed_units{"Pa", "J", "N", "W", "m", "s"};

std::string with_true_minus(std::string text) {
  if (text.starts_with('-')) text.replace(0, 1, minus_sign);
  return text;
}

std::string superscript(int value) {
  std::string out = value < 0 ? "⁻" : "";
  for (const char digit : std::to_string(std::abs(value))) out += superscripts[static_cast<std::size_t>(digit - '0')];
  return out;
}

/// "kg/m^3" -> "kg/m³"; spaces between factors become middle dots.
std::string readable(const std::string& unit) {
  std::string out;
  for (std::size_t i = 0; i < unit.size(); ++i) {
    if (unit[i] == '^' && i + 1 < unit.size()) {
      const bool negative = unit[i + 1] == '-';
      std::size_t end = i + 1 + negative;
      while (end < unit.size() && unit[end] >= '0' && unit[end] <= '9') ++end;
      if (end > i + 1 + negative) {
        out += superscript(std::stoi(unit.substr(i + 1, end - i - 1)));
        i = end - 1;
        continue;
      }
    }
    if (unit[i] == ' ')
      out += "·";
    else
      out += unit[i];
  }
  return out;
}

struct PrefixedUnit {
  int exponent;
  std::string_view base;
};

std::optional<PrefixedUnit> split_prefix(const std::string& unit) {
  for (const std::string_view base : prefixed_units)
    for (const Prefix& prefix : prefixes)
      if (unit == std::string(prefix.name) + std::string(base) || (prefix.exponent == -6 && unit == "u" + std::string(base)))
        return PrefixedUnit{prefix.exponent, base};
  return std::nullopt;
}

/// Prefixes that people use: seconds and meters are not counted in thousands or millions.
bool in_use(std::string_view base, int exponent) {
  if (base == "s") return exponent <= 0;
  if (base == "m") return exponent <= 3;
  if (base == "Pa") return exponent >= 0;
  return true;
}

}  // namespace

Ticks nice_ticks(double low, double high, int most) {
  if (!(high > low)) return {};
  const double raw = (high - low) / std::max(1, most - 1);
  const int power = static_cast<int>(std::floor(std::log10(raw)));
  Ticks ticks;
  for (int attempt = 0; attempt < 8; ++attempt) {
    constexpr std::array<double, 4> factors{1.0, 2.0, 2.5, 5.0};
    const double factor = factors[static_cast<std::size_t>(attempt % 4)];
    const int exponent = power + attempt / 4;
    const double step = factor * std::pow(10.0, exponent);
    const double slack = 1e-9 * (high - low);
    const double first = std::ceil((low - slack) / step), last = std::floor((high + slack) / step);
    if (last - first + 1 > most) continue;
    const int decimals = std::max(0, -exponent + (factor == 2.5 ? 1 : 0));
    for (int i = 0; first + i <= last && i < most; ++i) {
      const double at = first + i == 0.0 ? 0.0 : (first + i) * step;
      ticks.at.push_back(at);
      ticks.text.push_back(with_true_minus(fmt::format("{:.{}f}", at, decimals)));
    }
    return ticks;
  }
  return ticks;
}

double round_down_nicely(double limit) {
  const double power = std::pow(10.0, std::floor(std::log10(limit)));
  return (limit >= 5.0 * power ? 5.0 : limit >= 2.0 * power ? 2.0 : 1.0) * power;
}

std::string drawn_number(double value) { return with_true_minus(fmt::format("{:.4g}", value)); }

DisplayUnit display_unit(const std::string& unit, double largest) {
  const bool pure = unit.empty() || unit == "1";
  const std::string name = pure ? "" : readable(unit);
  if (!(largest > 0.0) || !std::isfinite(largest) || (largest >= 0.1 && largest < 900.0)) return {1.0, name};
  if (const auto split = split_prefix(unit)) {
    std::optional<DisplayUnit> best;
    for (const Prefix& prefix : prefixes) {
      if (!in_use(split->base, prefix.exponent)) continue;
      const double factor = std::pow(10.0, split->exponent - prefix.exponent);
      if (!best || largest * factor >= 0.9) best = {factor, std::string(prefix.name) + std::string(split->base)};
    }
    const double shown = largest * best->factor;
    if (shown >= 0.1 && shown < 1e4) return *best;
  }
  if (largest >= 0.01 && largest < 1e4) return {1.0, name};
  const int exponent = 3 * static_cast<int>(std::floor(std::log10(largest) / 3.0));
  return {std::pow(10.0, -exponent), "10" + superscript(exponent) + (pure ? "" : " " + name)};
}

}  // namespace sinew
