/// Values that are small tables of their own.

#include <sinew/core/node_text.hpp>
#include <sinew/model/value_reader.hpp>

namespace sinew {
namespace {

/// Size in SI of the unit called `key` ("length") of a case's system; `wanted` is its dimension.
double base_unit(const Node& table, const std::string& key, const Dimensions& wanted, std::string& name, const FieldSpec& spec) {
  const Node* node = table.find(key);
  if (!node)
    spec.fail(table.place,
              ": \"" + key + "\" is missing; a system of units is { length = \"mm\", mass = \"kg\", time = \"ms\" }");
  FieldSpec inner = spec;
  inner.owner = spec.label();
  inner.key = key;
  if (!node->is(Node::Kind::string)) inner.wrong_kind(*node, "the name of a unit");
  const std::optional<Unit> unit = parse_unit(node->text);
  if (!unit || unit->dimensions != wanted)
    inner.fail(node->place, " must be a unit of " + key + ", found " + quoted_text(node->text));
  name = node->text;
  return unit->factor;
}

const Node& checked_table(const Node& node, const FieldSpec& spec, const std::string& example) {
  if (!node.is(Node::Kind::table)) spec.wrong_kind(node, "a table such as " + example);
  return node;
}

}  // namespace

Node read_value(UnitSystem& value, const Node& node, const FieldSpec& spec, const Reading&) {
  if (node.is(Node::Kind::string)) {
    if (node.text != "SI")
      spec.fail(node.place,
                " must be \"SI\" or { length = \"mm\", mass = \"kg\", time = \"ms\" }, found " + quoted_text(node.text));
    value = UnitSystem{};
    return node;
  }
  if (!node.is(Node::Kind::table)) spec.wrong_kind(node, "\"SI\" or a table");
  check_keys(node, spec.label(), {"length", "mass", "time"});
  value.length_factor = base_unit(node, "length", {1, 0, 0}, value.length, spec);
  value.mass_factor = base_unit(node, "mass", {0, 1, 0}, value.mass, spec);
  value.time_factor = base_unit(node, "time", {0, 0, 1}, value.time, spec);
  return node;
}

Node read_value(std::vector<std::pair<std::string, double>>& value, const Node& node, const FieldSpec& spec,
                const Reading& reading) {
  value.clear();
  for (const Node::Member& member : checked_table(node, spec, "{ \"parameters.n\" = 8 }").members) {
    FieldSpec inner = spec;
    inner.owner = spec.label();
    inner.key = member.key;
    value.emplace_back(member.key, read_number(member.value, inner, reading));
  }
  return node;
}

Node read_value(std::vector<std::pair<std::string, std::vector<double>>>& value, const Node& node, const FieldSpec& spec,
                const Reading& reading) {
  value.clear();
  for (const Node::Member& member : checked_table(node, spec, "{ \"parameters.n\" = [4, 8] }").members) {
    FieldSpec inner = spec;
    inner.owner = spec.label();
    inner.key = member.key;
    std::vector<double> numbers;
    read_value(numbers, member.value, inner, reading);
    if (numbers.empty()) inner.fail(member.value.place, ": at least one value is needed");
    value.emplace_back(member.key, std::move(numbers));
  }
  return node;
}

}  // namespace sinew
