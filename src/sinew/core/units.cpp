#include <sinew/core/units.hpp>

#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>

namespace sinew {
namespace {

struct NamedUnit {
  std::string_view name;
  double factor;
  Dimensions dimensions;
  bool takes_prefix;
};

constexpr std::array<NamedUnit, 21> named_units{{
    {"m", 1.0, {1, 0, 0}, true},
    {"g", 1e-3, {0, 1, 0}, true},
    {"s", 1.0, {0, 0, 1}, true},
    {"N", 1.0, {1, 1, -2}, true},
    {"Pa", 1.0, {-1, 1, -2}, true},
    {"J", 1.0, {2, 1, -2}, true},
    {"W", 1.0, {2, 1, -3}, true},
    {"Hz", 1.0, {0, 0, -1}, true},
    {"kg", 1.0, {0, 1, 0}, false},
    {"K", 1.0, {0, 0, 0, 1}, false},
    {"t", 1e3, {0, 1, 0}, false},
    {"min", 60.0, {0, 0, 1}, false},
    {"h", 3600.0, {0, 0, 1}, false},
    {"bar", 1e5, {-1, 1, -2}, false},
    {"psi", 6894.757293168361, {-1, 1, -2}, false},
    {"in", 0.0254, {1, 0, 0}, false},
    {"ft", 0.3048, {1, 0, 0}, false},
    {"lb", 0.45359237, {0, 1, 0}, false},
    {"rad", 1.0, {}, false},
    {"deg", std::numbers::pi / 180.0, {}, false},
    {"%", 0.01, {}, false},
}};

struct Prefix {
  std::string_view name;
  double factor;
};
constexpr std::array<Prefix, 9> prefixes{
    {{"n", 1e-9}, {"u", 1e-6}, {"\u00b5", 1e-6}, {"m", 1e-3}, {"c", 1e-2}, {"k", 1e3}, {"M", 1e6}, {"G", 1e9}, {"", 1.0}}};

double integer_power(double base, int exponent) {
  double p = 1.0;
  for (int i = 0; i < std::abs(exponent); ++i) p *= base;
  return exponent < 0 ? 1.0 / p : p;
}

Unit power(const Unit& u, int n) {
  const Dimensions& d = u.dimensions;
  return {integer_power(u.factor, n), {d.length * n, d.mass * n, d.time * n, d.temperature * n}};
}

Unit product(const Unit& a, const Unit& b) {
  const Dimensions& p = a.dimensions;
  const Dimensions& q = b.dimensions;
  return {a.factor * b.factor, {p.length + q.length, p.mass + q.mass, p.time + q.time, p.temperature + q.temperature}};
}

/// Division of the factors, not multiplication by an inverse: mm/ms is then exactly 1 m/s.
Unit quotient(const Unit& a, const Unit& b) {
  Unit u = product(a, power(b, -1));
  u.factor = a.factor / b.factor;
  return u;
}

std::optional<Unit> single_unit(std::string_view name) {
  for (const NamedUnit& unit : named_units)
    if (unit.name == name) return Unit{unit.factor, unit.dimensions};
  for (const Prefix& prefix : prefixes)
    for (const NamedUnit& unit : named_units)
      if (unit.takes_prefix && name.starts_with(prefix.name) && name.substr(prefix.name.size()) == unit.name)
        return Unit{prefix.factor * unit.factor, unit.dimensions};
  return std::nullopt;
}

/// product := factor { ("*" | "/" | space) factor };  factor := ( "1" | name | "(" product ")" ) [ "^" whole number ]
class UnitParser {
 public:
  explicit UnitParser(std::string_view text) : rest_(text) {}

  std::optional<Unit> parse() {
    const std::optional<Unit> unit = parse_product();
    return rest_.empty() ? unit : std::nullopt;
  }

 private:
  std::optional<Unit> parse_product() {
    std::optional<Unit> unit = parse_factor();
    while (unit) {
      skip_spaces();
      if (rest_.empty() || rest_.front() == ')') break;
      const bool divide = rest_.front() == '/';
      if (divide || rest_.front() == '*') rest_.remove_prefix(1);
      const std::optional<Unit> next = parse_factor();
      if (!next) return std::nullopt;
      unit = divide ? quotient(*unit, *next) : product(*unit, *next);
    }
    return unit;
  }

  std::optional<Unit> parse_factor() {
    skip_spaces();
    std::optional<Unit> unit;
    if (take('(')) {
      unit = parse_product();
      if (!take(')')) return std::nullopt;
    } else if (take('1')) {
      unit = Unit{};
    } else {
      unit = single_unit(take_name());
    }
    if (!unit || !take('^')) return unit;
    int exponent = 0;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), exponent);
    if (error != std::errc() || std::abs(exponent) > 9) return std::nullopt;
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return power(*unit, exponent);
  }

  std::string_view take_name() {
    std::size_t n = 0;
    while (n < rest_.size() && is_name_character(rest_[n])) ++n;
    const std::string_view name = rest_.substr(0, n);
    rest_.remove_prefix(n);
    return name;
  }
  static bool is_name_character(char c) {
    const auto u = static_cast<unsigned char>(c);
    return std::isalpha(u) || c == '%' || u >= 0x80;
  }
  bool take(char c) {
    if (rest_.empty() || rest_.front() != c) return false;
    rest_.remove_prefix(1);
    return true;
  }
  void skip_spaces() {
    while (!rest_.empty() && rest_.front() == ' ') rest_.remove_prefix(1);
  }

  std::string_view rest_;
};

bool nearly_equal(double a, double b) { return std::abs(a - b) <= 1e-12 * std::abs(b); }

/// The system's name of one named unit: m, kg, s are replaced, Pa, N, J, W, Hz get the prefix that fits. Nothing if none does.
std::optional<std::string> name_in_system(std::string_view name, const UnitSystem& system) {
  if (name == "m") return system.length;
  if (name == "kg") return system.mass;
  if (name == "s") return system.time;
  if (name == "K") return "K";
  const std::optional<Unit> unit = single_unit(name);
  if (!unit) return std::nullopt;
  if (unit->dimensions == Dimensions{}) return std::string(name);
  const double wanted = system.factor(unit->dimensions) / unit->factor;
  for (const Prefix& prefix : prefixes)
    if (nearly_equal(prefix.factor, wanted) && prefix.name != "c") return std::string(prefix.name) + std::string(name);
  return std::nullopt;
}

/// "length^a mass^b/time^c" of a dimension, as a last resort.
std::string product_name(const Dimensions& d, const UnitSystem& system) {
  const std::array<std::pair<std::string, int>, 4> parts{
      {{system.mass, d.mass}, {system.length, d.length}, {system.time, d.time}, {"K", d.temperature}}};
  std::string above, below;
  for (const auto& [name, exponent] : parts) {
    if (exponent == 0) continue;
    std::string& side = exponent > 0 ? above : below;
    side += (side.empty() ? "" : " ") + name + (std::abs(exponent) > 1 ? "^" + std::to_string(std::abs(exponent)) : "");
  }
  if (above.empty()) above = "1";
  if (below.empty()) return above;
  return above + "/" + (below.find(' ') == std::string::npos ? below : "(" + below + ")");
}

}  // namespace

std::optional<Unit> parse_unit(std::string_view text) { return UnitParser(text).parse(); }

double UnitSystem::factor(const Dimensions& d) const {
  const std::array<std::pair<double, int>, 3> parts{{{length_factor, d.length}, {mass_factor, d.mass}, {time_factor, d.time}}};
  double above = 1.0, below = 1.0;
  for (const auto& [size, exponent] : parts) (exponent > 0 ? above : below) *= integer_power(size, std::abs(exponent));
  return above / below;
}

std::string UnitSystem::name_of(std::string_view si_name) const {
  const std::optional<Unit> unit = parse_unit(si_name);
  if (!unit || (length == "m" && mass == "kg" && time == "s")) return std::string(si_name);
  std::string result;
  for (std::size_t i = 0; i < si_name.size();) {
    std::size_t n = i;
    while (n < si_name.size() && std::isalpha(static_cast<unsigned char>(si_name[n]))) ++n;
    if (n == i) {
      result += si_name[i++];
      continue;
    }
    const std::optional<std::string> name = name_in_system(si_name.substr(i, n - i), *this);
    if (!name) return product_name(unit->dimensions, *this);
    result += *name;
    i = n;
  }
  return result;
}

}  // namespace sinew
