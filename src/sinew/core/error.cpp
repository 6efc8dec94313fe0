#include <sinew/core/error.hpp>

#include <algorithm>

namespace sinew {

std::string Place::text() const {
  if (line == 0) return file;
  return file + ":" + std::to_string(line) + ":" + std::to_string(column);
}

CaseError::CaseError(const Place& place, const std::string& message)
    : std::runtime_error(place.text().empty() ? message : place.text() + ": " + message) {}
CaseError::CaseError(const std::string& message) : std::runtime_error(message) {}

namespace {

/// Edit distance with insertions, deletions, substitutions and swaps of neighbors (optimal string alignment).
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i)
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t change = a[i - 1] == b[j - 1] ? 0 : 1;
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + change});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[a.size()][b.size()];
}

/// bodies, but keys.
std::string plural(std::string_view what) {
  if (what.ends_with("y") && !what.ends_with("key")) return std::string(what.substr(0, what.size() - 1)) + "ies";
  return std::string(what) + "s";
}

}  // namespace

std::string nearest_name(std::string_view wrong, std::span<const std::string> known) {
  std::string best;
  std::size_t best_distance = std::max<std::size_t>(1, wrong.size() / 3) + 1;
  for (const std::string& name : known) {
    const std::size_t distance = edit_distance(wrong, name);
    if (distance < best_distance) {
      best_distance = distance;
      best = name;
    }
  }
  if (!best.empty() || wrong.size() < 3) return best;
  for (const std::string& name : known)
    if (name.size() >= 3 && (name.find(wrong) != std::string::npos || wrong.find(name) != std::string_view::npos)) return name;
  return best;
}

std::string unknown_name_message(std::string_view what, std::string_view wrong, std::span<const std::string> known) {
  std::string message = "unknown " + std::string(what) + " \"" + std::string(wrong) + "\".";
  const std::string near = nearest_name(wrong, known);
  if (!near.empty()) message += " Did you mean \"" + near + "\"?";
  message += " Known " + plural(what) + ": ";
  for (std::size_t i = 0; i < known.size(); ++i) message += (i ? ", " : "") + known[i];
  if (known.empty()) message += "none";
  return message + ".";
}

}  // namespace sinew
