#pragma once
/// The visitors of `describe`: one reads a table of the case file, one lists the keys, one documents them.

#include <sinew/core/node_text.hpp>
#include <sinew/model/default_node.hpp>
#include <sinew/model/value_reader.hpp>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace sinew {

/// One parameter, for `sinew describe`, the reference and the schema.
struct ParameterDoc {
  std::string name;          ///< the key
  std::string type;          ///< "number", "vector field", "name", ...
  std::string unit;          ///< in SI; empty if it has none
  std::string range;         ///< "greater than 0" or the allowed names; empty if everything is allowed
  std::string default_text;  ///< as in a case file; empty if there is none
  std::string sentence;
  bool required = false;
};

namespace detail {
inline void apply(FieldSpec& spec, const Range& range) { spec.range = range; }
inline void apply(FieldSpec& spec, Need need) { spec.need = need; }
inline void apply(FieldSpec& spec, const OneOf& names) { spec.allowed = names.names; }
inline void apply(FieldSpec& spec, const TypeText& type) { spec.type = type.text; }

template <class... Options>
FieldSpec make_spec(std::string owner, std::string_view key, std::string_view unit, const Options&... options) {
  FieldSpec spec;
  spec.owner = std::move(owner);
  spec.key = key;
  spec.unit = unit;
  (apply(spec, options), ...);
  return spec;
}
}  // namespace detail

/// Reads each described member from `table` and writes what was read, or the default, to `resolved`.
class FieldReader {
 public:
  FieldReader(const Node& table, std::string owner, const Reading& reading, Node& resolved)
      : table_(table),
        owner_(std::move(owner)),
        reading_(reading),
        resolved_(resolved) {}

  template <class T, class... Options>
  void operator()(std::string_view key, T& member, std::string_view unit, std::string_view sentence, const Options&... options) {
    const FieldSpec spec = detail::make_spec(owner_, key, unit, options...);
    if (const Node* node = table_.find(key)) {
      add(key, read_value(member, *node, spec, reading_));
    } else if (spec.need == required) {
      throw CaseError(table_.place, owner_ + ": \"" + spec.key + "\" is missing. " + std::string(sentence));
    } else if (const std::optional<Node> value = default_node(member)) {
      add(key, *value);
    }
  }

 private:
  void add(std::string_view key, const Node& value) { resolved_.members.push_back({std::string(key), value.place, value}); }

  const Node& table_;
  std::string owner_;
  const Reading& reading_;
  Node& resolved_;
};

/// The keys that `T` describes.
template <class T>
std::vector<std::string> described_keys() {
  std::vector<std::string> keys;
  T object{};
  T::describe([&](std::string_view key, auto&&...) { keys.emplace_back(key); }, object);
  return keys;
}

/// Reads `object` from `table`: unknown keys first, then each key's type, unit and range. `selectors`: further keys that are
/// allowed, such as `model`. Returns the table with the defaults filled in.
template <class T>
Node read_described(T& object, const Node& table, const std::string& owner, const Reading& reading,
                    const std::vector<std::string>& selectors = {}) {
  std::vector<std::string> known = selectors;
  for (std::string& key : described_keys<T>()) known.push_back(std::move(key));
  check_keys(table, owner, known);
  Node resolved = Node::make_table(table.place);
  for (const std::string& key : selectors) {
    const Node* selector = table.find(key);
    if (selector) resolved.members.push_back({key, selector->place, *selector});
  }
  T::describe(FieldReader(table, owner, reading, resolved), object);
  return resolved;
}

/// The documentation of every parameter that `T` describes.
template <class T>
std::vector<ParameterDoc> parameter_docs() {
  std::vector<ParameterDoc> docs;
  T object{};
  T::describe(
      [&]<class M, class... Options>(std::string_view key, M& member, std::string_view unit, std::string_view sentence,
                                     const Options&... options) {
        FieldSpec spec = detail::make_spec("", key, unit, options...);
        if constexpr (std::is_same_v<M, Choice>) spec.allowed.assign(member.allowed.begin(), member.allowed.end());
        ParameterDoc doc{spec.key,
                         spec.type.empty() ? TypeName<M>::text : spec.type,
                         "",
                         "",
                         "",
                         std::string(sentence),
                         spec.need == required};
        if (unit != no_unit) doc.unit = unit == any_unit ? "of the quantity" : unit;
        if (spec.range.text != any_number.text) doc.range = spec.range.text;
        for (const std::string& name : spec.allowed) doc.range += (doc.range.empty() ? "" : ", ") + name;
        const std::optional<Node> value = spec.need == required ? std::nullopt : default_node(member);
        if (value) doc.default_text = value_text(*value);
        docs.push_back(std::move(doc));
      },
      object);
  return docs;
}

}  // namespace sinew
