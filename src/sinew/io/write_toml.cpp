#include <sinew/io/write_toml.hpp>

#include <algorithm>
#include <sinew/core/node_text.hpp>

namespace sinew {
namespace {

bool is_table(const Node& node) { return node.is(Node::Kind::table); }

bool is_list_of_tables(const Node& node) {
  return node.is(Node::Kind::array) && !node.items.empty() && std::all_of(node.items.begin(), node.items.end(), is_table);
}

std::string key_values(const Node& table) {
  std::string text;
  for (const Node::Member& member : table.members) text += key_text(member.key) + " = " + value_text(member.value) + "\n";
  return text;
}

/// [name], or [name.a], [name.b] for a table of nothing but tables.
std::string section(const std::string& name, const Node& table) {
  const auto holds_table = [](const Node::Member& member) { return is_table(member.value); };
  if (table.members.empty() || !std::all_of(table.members.begin(), table.members.end(), holds_table))
    return "\n[" + name + "]\n" + key_values(table);
  std::string text;
  for (const Node::Member& member : table.members)
    text += "\n[" + name + "." + key_text(member.key) + "]\n" + key_values(member.value);
  return text;
}

}  // namespace

std::string toml_text(const Node& root) {
  std::string plain, sections;
  for (const Node::Member& member : root.members) {
    const std::string name = key_text(member.key);
    if (is_table(member.value)) {
      sections += section(name, member.value);
    } else if (is_list_of_tables(member.value)) {
      for (const Node& item : member.value.items) sections += "\n[[" + name + "]]\n" + key_values(item);
    } else {
      plain += name + " = " + value_text(member.value) + "\n";
    }
  }
  return plain.empty() && !sections.empty() ? sections.substr(1) : plain + sections;
}

}  // namespace sinew
