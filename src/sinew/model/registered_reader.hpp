#pragma once
/// Reading of the things that a registry offers: materials, kernels, corrections, stabilizations, geometries.

#include <algorithm>
#include <sinew/contact_laws/registry.hpp>
#include <sinew/corrections/registry.hpp>
#include <sinew/damage/registry.hpp>
#include <sinew/kernels/registry.hpp>
#include <sinew/materials/registry.hpp>
#include <sinew/model/field_reader.hpp>
#include <sinew/particles/generate/registry.hpp>
#include <sinew/stabilization/registry.hpp>
#include <variant>

namespace sinew {

/// What messages and case files call the members of a registry.
template <class Variant>
struct RegistryOf;
template <>
struct RegistryOf<AnyMaterial> : Materials {
  static constexpr const char *what = "material model", *selector = "model";
};
template <>
struct RegistryOf<AnyDamage> : DamageModels {
  static constexpr const char *what = "model of damage", *selector = "model";
};
template <>
struct RegistryOf<AnyKernel> : Kernels {
  static constexpr const char *what = "kernel", *selector = "model";
};
template <>
struct RegistryOf<AnyCorrection> : Corrections {
  static constexpr const char *what = "correction", *selector = "model";
};
template <>
struct RegistryOf<AnyStabilization> : Stabilizations {
  static constexpr const char *what = "stabilization", *selector = "model";
};
template <>
struct RegistryOf<AnyWallShape> : WallShapes {
  static constexpr const char *what = "wall shape", *selector = "shape";
};
template <>
struct RegistryOf<AnyGeometry> : Geometries {
  static constexpr const char *what = "shape", *selector = "shape";
};

template <class... Ts>
struct TypeName<std::variant<Ts...>> {
  static constexpr const char* text = "name, or table with its parameters";
};
template <class... Ts>
struct TypeName<std::vector<std::variant<Ts...>>> {
  static constexpr const char* text = "array of names or tables";
};

namespace detail {
/// What is left to do when all parameters of a model are read.
template <class T>
void complete(T& object, const Node& node, const std::string& owner) {
  if constexpr (requires { object.elastic.complete(); })
    if (const std::optional<std::string> problem = object.elastic.complete())
      throw CaseError(node.place, owner + ": " + *problem);
  if constexpr (requires { object.hardening.complete(); })
    if (const std::optional<std::string> problem = object.hardening.complete())
      throw CaseError(node.place, owner + ": " + *problem);
  if constexpr (requires { object.complete(); })
    if (const std::optional<std::string> problem = object.complete()) throw CaseError(node.place, owner + ": " + *problem);
}
}  // namespace detail

/// A name, or a table whose selector ("model", "shape") names the type. Returns the table with every default filled in.
template <class Variant>
Node read_registered(Variant& value, const Node& node, const std::string& owner, const Reading& reading) {
  using Registry = RegistryOf<Variant>;
  const std::string selector = Registry::selector, what = Registry::what;
  Node table = node;
  if (node.is(Node::Kind::string)) {
    table = Node::make_table(node.place);
    table.members.push_back({selector, node.place, node});
  } else if (!node.is(Node::Kind::table)) {
    throw CaseError(node.place, owner + ": expected a table with \"" + selector + "\", found " + node.kind_name());
  }
  const Node* name = table.find(selector);
  if (!name)
    throw CaseError(table.place, owner + ": \"" + selector + "\" is missing. It names the " + what + ", for example \"" +
                                     Registry::names().front() + "\"");
  if (!name->is(Node::Kind::string))
    throw CaseError(name->place, owner + ": " + selector + ": expected a name, found " + name->kind_name());
  Node resolved;
  const bool known = Registry::with_name(name->text, [&]<class T>() {
    T object{};
    resolved = read_described(object, table, owner, reading, {selector});
    detail::complete(object, table, owner);
    value = std::move(object);
  });
  if (!known) throw CaseError(name->place, owner + ": " + unknown_name_message(what, name->text, Registry::names()));
  return node.is(Node::Kind::string) && resolved.members.size() == 1 ? node : resolved;
}

template <class... Ts>
Node read_value(std::variant<Ts...>& value, const Node& node, const FieldSpec& spec, const Reading& reading) {
  return read_registered(value, node, spec.label(), reading);
}

/// A list of names or tables; "none" and [] are empty, a single one needs no brackets.
template <class... Ts>
Node read_value(std::vector<std::variant<Ts...>>& value, const Node& node, const FieldSpec& spec, const Reading& reading) {
  value.clear();
  Node resolved = Node::make_array(node.place);
  if (node.is(Node::Kind::string) && node.text == "none") return resolved;
  const std::vector<Node> items = node.is(Node::Kind::array) ? node.items : std::vector<Node>{node};
  for (const Node& item : items) {
    std::variant<Ts...> entry;
    resolved.items.push_back(read_registered(entry, item, spec.label() + " " + std::to_string(value.size() + 1), reading));
    for (const std::variant<Ts...>& earlier : value)
      if (earlier.index() == entry.index()) spec.fail(item.place, ": the same model is given twice");
    value.push_back(std::move(entry));
  }
  return resolved;
}

template <class... Ts>
std::optional<Node> default_node(const std::variant<Ts...>& value) {
  const auto make = []<class T>(const T& object) {
    Node table = Node::make_table();
    table.members.push_back({RegistryOf<std::variant<Ts...>>::selector, {}, Node::make_string(std::string(T::name))});
    const auto add = [&](std::string_view key, const auto& member, auto&&...) {
      if (const std::optional<Node> node = default_node(member)) table.members.push_back({std::string(key), {}, *node});
    };
    T::describe(add, object);
    return table.members.size() == 1 ? table.members[0].value : table;
  };
  return std::visit(make, value);
}

template <class... Ts>
std::optional<Node> default_node(const std::vector<std::variant<Ts...>>& value) {
  Node node = Node::make_array();
  for (const std::variant<Ts...>& entry : value) node.items.push_back(default_node(entry).value());
  return node;
}

}  // namespace sinew
