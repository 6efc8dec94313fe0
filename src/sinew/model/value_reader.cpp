#include <sinew/model/value_reader.hpp>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <limits>
#include <sinew/core/node_text.hpp>
#include <sinew/core/number_text.hpp>

namespace sinew {

void FieldSpec::fail(const Place& place, const std::string& message) const { throw CaseError(place, label() + message); }

void FieldSpec::wrong_kind(const Node& found, const std::string& expected) const {
  std::string what = found.kind_name();
  if (found.is(Node::Kind::string)) what += " (" + quoted_text(found.text) + ")";
  fail(found.place, ": expected " + expected + ", found " + what);
}

void check_keys(const Node& table, const std::string& owner, const std::vector<std::string>& known) {
  if (!table.is(Node::Kind::table)) throw CaseError(table.place, owner + ": expected a table, found " + table.kind_name());
  for (const Node::Member& member : table.members)
    if (std::find(known.begin(), known.end(), member.key) == known.end())
      throw CaseError(member.place, (owner.empty() ? "" : owner + ": ") + unknown_name_message("key", member.key, known));
}

std::optional<Quantity> split_quantity(const std::string& text) {
  const char* begin = text.data();
  const char* const end = begin + text.size();
  while (begin < end && *begin == ' ') ++begin;
  if (begin < end && *begin == '+') ++begin;
  const char* const digits = begin + (begin < end && *begin == '-' ? 1 : 0);
  if (digits == end || !(std::isdigit(static_cast<unsigned char>(*digits)) || *digits == '.')) return std::nullopt;
  Quantity quantity{};
  const auto [stop, error] = std::from_chars(begin, end, quantity.value);
  if (error != std::errc()) return std::nullopt;
  const char* unit = stop;
  while (unit < end && *unit == ' ') ++unit;
  if (unit == end) return std::nullopt;
  const bool letter =
      std::isalpha(static_cast<unsigned char>(*unit)) || *unit == '%' || static_cast<unsigned char>(*unit) >= 0x80;
  const bool reciprocal = unit > stop && end - unit > 1 && unit[0] == '1' && unit[1] == '/';
  if (!letter && !reciprocal) return std::nullopt;
  quantity.unit.assign(unit, end);
  while (quantity.unit.back() == ' ') quantity.unit.pop_back();
  return quantity;
}

namespace {

/// The value of "17 MPa" in the units of the case.
double convert(const Quantity& quantity, const Node& node, const FieldSpec& spec, const Reading& reading) {
  const std::string given = " = " + quoted_text(node.text) + ": ";
  const std::optional<Unit> unit = parse_unit(quantity.unit);
  if (!unit) {
    const std::vector<std::string> names = names_in_expression(quantity.unit);
    if (!names.empty() && (reading.constants.contains(names[0]) || is_reserved_name(names[0])))
      spec.fail(node.place, given + "an operator is missing after " + number_text(quantity.value) + "; to multiply, write \"" +
                                number_text(quantity.value) + "*" + quantity.unit + "\"");
    if (quantity.unit.find_first_of("()<>=+") != std::string::npos)
      spec.fail(node.place, given + "a formula takes no units. Write plain numbers in the units of the case");
    spec.fail(node.place,
              given + "unknown unit " + quoted_text(quantity.unit) +
                  ". Known units: m, kg, g, t, s, min, h, N, Pa, bar, psi, J, W, Hz, in, ft, lb, rad, deg, %, with the prefixes "
                  "n, u, m, c, k, M, G, and products such as kg/m^3");
  }
  double converted = quantity.value * unit->factor / reading.units.factor(unit->dimensions);
  if (spec.unit == "deg") converted /= parse_unit("deg")->factor;  // angles of plain numbers are in degrees
  if (spec.unit == any_unit) return converted;
  if (unit->dimensions != parse_unit(spec.unit).value().dimensions)
    spec.fail(node.place, given + (spec.unit == "1" ? "expected a number without a unit"
                                                    : "the unit " + quantity.unit + " does not fit, expected " +
                                                          reading.units.name_of(spec.unit) + " or a unit of the same kind"));
  return converted;
}

void check_range(double value, const Node& node, const FieldSpec& spec) {
  if (std::isfinite(value) && spec.range.contains(value)) return;
  std::string found = ", found " + number_text(value);
  if (node.is(Node::Kind::string)) found += " from " + quoted_text(node.text);
  spec.fail(node.place, " must be " + std::string(std::isfinite(value) ? spec.range.text : "a finite number") + found);
}

template <class Whole>
Node read_whole(Whole& value, const Node& node, const FieldSpec& spec, const Reading& reading) {
  const double number = read_number(node, spec, reading);
  const double limit = std::min(9007199254740992.0, static_cast<double>(std::numeric_limits<Whole>::max()));
  if (number != std::floor(number)) spec.fail(node.place, " must be a whole number, found " + number_text(number));
  if (std::abs(number) > limit)
    spec.fail(node.place, " must be at most " + number_text(limit) + ", found " + number_text(number));
  value = static_cast<Whole>(number);
  return node;
}

std::string component_name(const FieldSpec& spec, int i) { return spec.key + "[" + std::to_string(i) + "]"; }

/// Calls `read(component, item, spec of the component)` for each of the `dimension` items of a vector.
template <class Read>
void read_components(const Node& node, const FieldSpec& spec, const Reading& reading, Read&& read) {
  const std::string size = std::to_string(reading.dimension);
  if (!node.is(Node::Kind::array)) spec.wrong_kind(node, "an array of " + size + " components");
  if (static_cast<int>(node.items.size()) != reading.dimension)
    spec.fail(node.place,
              ": expected " + size + " components, since dimension = " + size + ", found " + std::to_string(node.items.size()));
  for (int i = 0; i < reading.dimension; ++i) {
    FieldSpec component = spec;
    component.key = component_name(spec, i);
    read(i, node.items[static_cast<std::size_t>(i)], component);
  }
}

}  // namespace

double read_number(const Node& node, const FieldSpec& spec, const Reading& reading) {
  const double value = read_expression(node, spec, reading, false)(0.0);
  check_range(value, node, spec);
  return value;
}

Expression read_expression(const Node& node, const FieldSpec& spec, const Reading& reading, bool fields) {
  if (node.is_numeric()) return Expression(node.number);
  if (!node.is(Node::Kind::string)) spec.wrong_kind(node, fields ? "a number or an expression" : "a number");
  if (const std::optional<Quantity> quantity = split_quantity(node.text))
    return Expression(convert(*quantity, node, spec, reading));
  if (fields && node.text == "free")
    spec.fail(node.place, ": \"free\" can only stand in a prescribed displacement or velocity; write 0 here");
  try {
    return Expression(node.text, reading.constants, Place{}, fields);
  } catch (const CaseError& error) {
    spec.fail(node.place, std::string(": expected ") + (fields ? "a number or an expression" : "a number") + "; " + error.what());
  }
}

Node read_value(double& value, const Node& node, const FieldSpec& spec, const Reading& reading) {
  value = read_number(node, spec, reading);
  return node;
}

Node read_value(int& value, const Node& node, const FieldSpec& spec, const Reading& reading) {
  return read_whole(value, node, spec, reading);
}
Node read_value(long& value, const Node& node, const FieldSpec& spec, const Reading& reading) {
  return read_whole(value, node, spec, reading);
}

Node read_value(bool& value, const Node& node, const FieldSpec& spec, const Reading&) {
  if (!node.is(Node::Kind::boolean)) spec.wrong_kind(node, "true or false");
  value = node.boolean;
  return node;
}

Node read_value(std::string& value, const Node& node, const FieldSpec& spec, const Reading& reading) {
  if (!node.is(Node::Kind::string)) spec.wrong_kind(node, "a " + (spec.type.empty() ? "string (text in quotes)" : spec.type));
  if (!spec.allowed.empty() && std::find(spec.allowed.begin(), spec.allowed.end(), node.text) == spec.allowed.end())
    spec.fail(node.place, ": " + unknown_name_message("name", node.text, spec.allowed));
  value = node.text;
  if (spec.key == "file") value = (std::filesystem::absolute(reading.folder) / value).lexically_normal().string();
  return Node::make_string(value, node.place);
}

Node read_value(Choice& value, const Node& node, const FieldSpec& spec, const Reading& reading) {
  FieldSpec names = spec;
  names.allowed.assign(value.allowed.begin(), value.allowed.end());
  return read_value(value.value, node, names, reading);
}

/// Arrays inside the array are laid out one after the other: [[0, 0], [1, 0]] is [0, 0, 1, 0].
Node read_value(std::vector<double>& value, const Node& node, const FieldSpec& spec, const Reading& reading) {
  if (!node.is(Node::Kind::array)) spec.wrong_kind(node, "an array of numbers");
  value.clear();
  int index = 0;
  for (const Node& item : node.items) {
    FieldSpec component = spec;
    component.key = component_name(spec, index++);
    if (item.is(Node::Kind::array)) {
      std::vector<double> inner;
      read_value(inner, item, component, reading);
      value.insert(value.end(), inner.begin(), inner.end());
    } else {
      value.push_back(read_number(item, component, reading));
    }
  }
  return node;
}

Node read_value(std::vector<std::string>& value, const Node& node, const FieldSpec& spec, const Reading& reading) {
  if (!node.is(Node::Kind::array)) spec.wrong_kind(node, "an array of strings");
  value.clear();
  for (const Node& item : node.items) read_value(value.emplace_back(), item, spec, reading);
  return node;
}

Node read_value(std::array<double, 3>& value, const Node& node, const FieldSpec& spec, const Reading& reading) {
  read_components(node, spec, reading, [&](int i, const Node& item, const FieldSpec& component) {
    value[static_cast<std::size_t>(i)] = read_number(item, component, reading);
  });
  return node;
}

Node read_value(Point& value, const Node& node, const FieldSpec& spec, const Reading& reading) {
  read_components(node, spec, reading,
                  [&](int i, const Node& item, const FieldSpec& component) { value[i] = read_number(item, component, reading); });
  return node;
}

Node read_value(std::array<Point, 2>& value, const Node& node, const FieldSpec& spec, const Reading& reading) {
  check_keys(node, spec.label(), {"low", "high"});
  const std::array<std::string, 2> corners{"low", "high"};
  for (std::size_t i = 0; i < 2; ++i) {
    const Node* corner = node.find(corners[i]);
    if (!corner) spec.fail(node.place, ": \"" + corners[i] + "\" is missing; a box is { low = [...], high = [...] }");
    FieldSpec inner = spec;
    inner.owner = spec.label();
    inner.key = corners[i];
    read_value(value[i], *corner, inner, reading);
  }
  for (int i = 0; i < reading.dimension; ++i)
    if (value[0][i] > value[1][i]) spec.fail(node.place, ": low must not be above high");
  return node;
}

Node read_value(Expression& value, const Node& node, const FieldSpec& spec, const Reading& reading) {
  value = read_expression(node, spec, reading, true);
  return node;
}

Node read_value(std::array<Expression, 3>& value, const Node& node, const FieldSpec& spec, const Reading& reading) {
  read_components(node, spec, reading, [&](int i, const Node& item, const FieldSpec& component) {
    value[static_cast<std::size_t>(i)] = read_expression(item, component, reading, true);
  });
  return node;
}

Node read_value(std::array<std::optional<Expression>, 3>& value, const Node& node, const FieldSpec& spec,
                const Reading& reading) {
  read_components(node, spec, reading, [&](int i, const Node& item, const FieldSpec& component) {
    if (item.is(Node::Kind::string) && item.text == "free") return;
    value[static_cast<std::size_t>(i)] = read_expression(item, component, reading, true);
  });
  return node;
}

}  // namespace sinew
