#pragma once
/// Reading of single values: numbers with units and expressions, names, vectors and fields. Each function checks type, unit and
/// range, throws CaseError at the place of the value, and returns the node to be written into the resolved case.

#include <array>
#include <map>
#include <optional>
#include <sinew/core/node.hpp>
#include <sinew/core/params.hpp>
#include <sinew/core/units.hpp>
#include <sinew/model/expression.hpp>
#include <sinew/model/field_options.hpp>
#include <string>
#include <utility>
#include <vector>

namespace sinew {

/// What the meaning of a value depends on.
struct Reading {
  int dimension = 3;
  UnitSystem units;
  Constants constants;  ///< the parameters; in [solver] and [output] also end_time
  std::string folder;   ///< file names are relative to it
};

/// What is said about one key.
struct FieldSpec {
  std::string owner, key;  ///< `material "rubber"`, `density`
  std::string unit = "1";
  Range range = any_number;
  Need need = required;
  std::vector<std::string> allowed;  ///< names; empty: any
  std::string type;                  ///< see TypeText

  std::string label() const { return owner.empty() ? key : owner + ": " + key; }
  [[noreturn]] void fail(const Place& place, const std::string& message) const;        ///< "label message"
  [[noreturn]] void wrong_kind(const Node& found, const std::string& expected) const;  ///< "label: expected a, found b"
};

double read_number(const Node& node, const FieldSpec& spec, const Reading& reading);
/// A number or a formula; `fields`: in X Y Z x y z t.
Expression read_expression(const Node& node, const FieldSpec& spec, const Reading& reading, bool fields);

Node read_value(double& value, const Node& node, const FieldSpec& spec, const Reading& reading);
Node read_value(int& value, const Node& node, const FieldSpec& spec, const Reading& reading);
Node read_value(long& value, const Node& node, const FieldSpec& spec, const Reading& reading);
Node read_value(bool& value, const Node& node, const FieldSpec& spec, const Reading& reading);
Node read_value(std::string& value, const Node& node, const FieldSpec& spec, const Reading& reading);
Node read_value(Choice& value, const Node& node, const FieldSpec& spec, const Reading& reading);
Node read_value(std::vector<double>& value, const Node& node, const FieldSpec& spec, const Reading& reading);
Node read_value(std::vector<std::string>& value, const Node& node, const FieldSpec& spec, const Reading& reading);
/// A vector of as many numbers as dimensions; the third keeps its value in two dimensions.
Node read_value(std::array<double, 3>& value, const Node& node, const FieldSpec& spec, const Reading& reading);
Node read_value(Point& value, const Node& node, const FieldSpec& spec, const Reading& reading);
/// { low = [...], high = [...] }
Node read_value(std::array<Point, 2>& value, const Node& node, const FieldSpec& spec, const Reading& reading);
Node read_value(Expression& value, const Node& node, const FieldSpec& spec, const Reading& reading);
Node read_value(std::array<Expression, 3>& value, const Node& node, const FieldSpec& spec, const Reading& reading);
/// The same with "free" for components that are left alone.
Node read_value(std::array<std::optional<Expression>, 3>& value, const Node& node, const FieldSpec& spec, const Reading& reading);
/// "SI" or { length = "mm", mass = "kg", time = "ms" }
Node read_value(UnitSystem& value, const Node& node, const FieldSpec& spec, const Reading& reading);
/// { "parameters.n" = 4 } and { "parameters.n" = [4, 8] }
Node read_value(std::vector<std::pair<std::string, double>>& value, const Node& node, const FieldSpec& spec,
                const Reading& reading);
Node read_value(std::vector<std::pair<std::string, std::vector<double>>>& value, const Node& node, const FieldSpec& spec,
                const Reading& reading);

template <class T>
Node read_value(std::optional<T>& value, const Node& node, const FieldSpec& spec, const Reading& reading) {
  return read_value(value.emplace(), node, spec, reading);
}

/// CaseError unless `node` is a table and all its keys are known.
void check_keys(const Node& table, const std::string& owner, const std::vector<std::string>& known);

/// "17 MPa" as number and unit; nothing if the text is no number followed by letters.
struct Quantity {
  double value;
  std::string unit;
};
std::optional<Quantity> split_quantity(const std::string& text);

}  // namespace sinew
