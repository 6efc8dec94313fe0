#pragma once

#include <sinew/model/default_node.hpp>
#include <sinew/model/value_reader.hpp>

namespace sinew {

/// What holds across the plane of a two-dimensional case: no strain or no stress.
enum class PlaneState { strain, stress };

template <>
struct TypeName<PlaneState> {
  static constexpr const char* text = "name";
};

inline std::optional<Node> default_node(PlaneState value) {
  return Node::make_string(value == PlaneState::strain ? "strain" : "stress");
}

inline Node read_value(PlaneState& value, const Node& node, const FieldSpec& spec, const Reading& reading) {
  std::string name;
  Node resolved = read_value(name, node, spec, reading);
  value = name == "strain" ? PlaneState::strain : PlaneState::stress;
  return resolved;
}

}  // namespace sinew
