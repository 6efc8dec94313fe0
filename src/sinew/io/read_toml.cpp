#include <sinew/io/read_toml.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sinew/core/node_text.hpp>
#include <sstream>
#include <toml++/toml.h>

namespace sinew {
namespace {

class Conversion {
 public:
  explicit Conversion(const std::string& file) : file_(file) {}

  Node convert(const toml::node& node) const {
    const Place place = place_of(node.source());
    switch (node.type()) {
      case toml::node_type::table: return convert_table(*node.as_table());
      case toml::node_type::array: return convert_array(*node.as_array());
      case toml::node_type::string: return Node::make_string(**node.as_string(), place);
      case toml::node_type::integer: return Node::make_integer(**node.as_integer(), place);
      case toml::node_type::floating_point: return Node::make_number(**node.as_floating_point(), place);
      case toml::node_type::boolean: return Node::make_boolean(**node.as_boolean(), place);
      default: throw CaseError(place, "dates and times are not used in a case; put the value in quotes");
    }
  }

  Place place_of(const toml::source_region& source) const {
    return {file_, static_cast<int>(source.begin.line), static_cast<int>(source.begin.column)};
  }

 private:
  /// toml++ sorts keys by name; the places bring back the order of the text.
  Node convert_table(const toml::table& table) const {
    Node node = Node::make_table(place_of(table.source()));
    for (const auto& [key, value] : table)
      node.members.push_back({std::string(key.str()), place_of(key.source()), convert(value)});
    const auto position = [](const Node::Member& member) { return std::pair(member.place.line, member.place.column); };
    std::stable_sort(node.members.begin(), node.members.end(),
                     [&](const Node::Member& a, const Node::Member& b) { return position(a) < position(b); });
    return node;
  }

  Node convert_array(const toml::array& array) const {
    Node node = Node::make_array(place_of(array.source()));
    for (const toml::node& item : array) node.items.push_back(convert(item));
    return node;
  }

  std::string file_;
};

/// toml++ says "Error while parsing key-value pair: ...": the rest is what a user can act on.
std::string problem_of(const toml::parse_error& error) {
  std::string text(error.description());
  const std::size_t colon = text.find(": ");
  if (text.starts_with("Error while parsing ") && colon != std::string::npos) text = text.substr(colon + 2);
  if (text.find("unescaped control characters") != std::string::npos)
    return "the closing quote of a string is missing on this line";
  if (text.find("could not determine value type") != std::string::npos) return "this is no value; text needs quotes around it";
  const std::string newline = "'\\n'";
  if (const std::size_t at = text.find(newline); at != std::string::npos) text.replace(at, newline.size(), "the end of the line");
  return text;
}

void set_place(Node& node, const Place& place) {
  node.place = place;
  for (Node::Member& member : node.members) {
    member.place = place;
    set_place(member.value, place);
  }
  for (Node& item : node.items) set_place(item, place);
}

}  // namespace

Node read_toml_text(const std::string& text, const std::string& name) {
  const Conversion conversion(name);
  try {
    Node root = conversion.convert(toml::parse(text, name));
    root.place = Place{name};
    return root;
  } catch (const toml::parse_error& error) {
    throw CaseError(conversion.place_of(error.source()), "not valid TOML: " + problem_of(error));
  }
}

Node read_toml_file(const std::string& path) {
  if (std::filesystem::is_directory(path)) throw CaseError("\"" + path + "\" is a folder; give the case file in it");
  std::ifstream file(path, std::ios::binary);
  if (!file)
    throw CaseError("cannot open the case file \"" + path + "\"" +
                    (std::filesystem::exists(path) ? "" : ": there is no such file"));
  std::ostringstream text;
  text << file.rdbuf();
  return read_toml_text(text.str(), path);
}

Node read_toml_value(const std::string& text, const Place& place) {
  Node value = Node::make_string(text);
  const bool structured = !text.empty() && std::string("[{\"'").find(text.front()) != std::string::npos;
  try {
    const Node root = read_toml_text("value = " + text, place.file);
    if (root.members.size() == 1 && root.members[0].key == "value") value = root.members[0].value;
  } catch (const CaseError&) {
    if (structured) throw CaseError(place, text + " is not a valid TOML value");
  }
  set_place(value, place);
  return value;
}

}  // namespace sinew
