#include <sinew/cli/number_format.hpp>

#include <array>
#include <cmath>
#include <fmt/format.h>

namespace sinew {

std::string count_text(long count) {
  std::string text = std::to_string(count);
  for (std::size_t i = text.size(); i > 3; i -= 3)
    if (text[i - 4] != '-') text.insert(i - 3, " ");
  return text;
}

std::string bytes_text(double bytes) {
  constexpr std::array units{"B", "kB", "MB", "GB", "TB"};
  std::size_t i = 0;
  for (; bytes >= 1000.0 && i + 1 < units.size(); ++i) bytes /= 1000.0;
  return fmt::format("{:.3g} {}", bytes, units[i]);
}

std::string duration_text(double seconds) {
  if (!std::isfinite(seconds)) return "unknown";
  if (seconds < 60.0) return fmt::format("{:.3g} s", seconds);
  const long whole = std::lround(seconds);
  if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} h {} min", count_text(whole / 3600), whole % 3600 / 60);
}

std::string quantity_text(double value, const std::string& unit) {
  if (unit.empty() || unit == "1") return fmt::format("{:.6g}", value);
  return fmt::format("{:.6g} {}", value, unit);
}

}  // namespace sinew
