#pragma once
/// Member types of the case as the reference calls them, and their default values as nodes of a case file.

#include <array>
#include <cmath>
#include <optional>
#include <sinew/core/node.hpp>
#include <sinew/core/params.hpp>
#include <sinew/core/units.hpp>
#include <sinew/core/vec.hpp>
#include <sinew/model/expression.hpp>
#include <string>
#include <utility>
#include <vector>

namespace sinew {

template <class T>
struct TypeName;
template <>
struct TypeName<double> {
  static constexpr const char* text = "number";
};
template <>
struct TypeName<int> {
  static constexpr const char* text = "whole number";
};
template <>
struct TypeName<long> {
  static constexpr const char* text = "whole number";
};
template <>
struct TypeName<bool> {
  static constexpr const char* text = "true or false";
};
template <>
struct TypeName<std::string> {
  static constexpr const char* text = "string";
};
template <>
struct TypeName<Choice> {
  static constexpr const char* text = "name";
};
template <>
struct TypeName<std::vector<double>> {
  static constexpr const char* text = "array of numbers";
};
template <>
struct TypeName<std::vector<std::string>> {
  static constexpr const char* text = "array of strings";
};
template <>
struct TypeName<std::array<double, 3>> {
  static constexpr const char* text = "vector";
};
template <>
struct TypeName<Point> {
  static constexpr const char* text = "vector";
};
template <>
struct TypeName<std::array<Point, 2>> {
  static constexpr const char* text = "{ low, high }";
};
template <>
struct TypeName<Expression> {
  static constexpr const char* text = "field";
};
template <>
struct TypeName<std::array<Expression, 3>> {
  static constexpr const char* text = "vector field";
};
template <>
struct TypeName<std::array<std::optional<Expression>, 3>> {
  static constexpr const char* text = "vector field or \"free\"";
};
template <>
struct TypeName<UnitSystem> {
  static constexpr const char* text = "\"SI\" or { length, mass, time }";
};
template <>
struct TypeName<std::vector<std::pair<std::string, double>>> {
  static constexpr const char* text = "table of numbers";
};
template <>
struct TypeName<std::vector<std::pair<std::string, std::vector<double>>>> {
  static constexpr const char* text = "table of arrays";
};
template <class T>
struct TypeName<std::optional<T>> : TypeName<T> {};

/// What to write into the resolved case for a key that was not given; nothing where "not given" itself is the value.
inline std::optional<Node> default_node(double value) {
  if (!std::isfinite(value)) return std::nullopt;
  return Node::make_number(value);
}
inline std::optional<Node> default_node(int value) { return Node::make_integer(value); }
inline std::optional<Node> default_node(bool value) { return Node::make_boolean(value); }
inline std::optional<Node> default_node(const std::string& value) {
  if (value.empty()) return std::nullopt;
  return Node::make_string(value);
}
inline std::optional<Node> default_node(const Choice& value) { return Node::make_string(value.value); }
inline std::optional<Node> default_node(const UnitSystem&) { return Node::make_string("SI"); }
inline std::optional<Node> default_node(const std::vector<std::string>& value) {
  Node node = Node::make_array();
  for (const std::string& text : value) node.items.push_back(Node::make_string(text));
  return node;
}
inline std::optional<Node> default_node(const std::vector<double>& value) {
  if (value.empty()) return std::nullopt;
  Node node = Node::make_array();
  for (const double number : value) node.items.push_back(Node::make_number(number));
  return node;
}
inline std::optional<Node> default_node(const std::array<double, 3>&) { return std::nullopt; }
inline std::optional<Node> default_node(const Point&) { return std::nullopt; }
inline std::optional<Node> default_node(const std::array<Point, 2>&) { return std::nullopt; }
inline std::optional<Node> default_node(const Expression&) { return std::nullopt; }
template <class T>
std::optional<Node> default_node(const std::array<T, 3>&) {
  return std::nullopt;
}
template <class T>
std::optional<Node> default_node(const std::optional<T>&) {
  return std::nullopt;
}
template <class T>
std::optional<Node> default_node(const std::vector<std::pair<std::string, T>>&) {
  return std::nullopt;
}

}  // namespace sinew
