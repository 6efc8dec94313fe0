#include <sinew/model/case.hpp>

#include <algorithm>
#include <charconv>

namespace sinew {
namespace {

std::vector<std::string> segments_of(const std::string& path, const Place& place) {
  std::vector<std::string> segments(1);
  for (const char c : path) {
    if (c == '.')
      segments.emplace_back();
    else
      segments.back() += c;
  }
  for (const std::string& segment : segments)
    if (segment.empty())
      throw CaseError(place, "\"" + path + "\" is not a key path; it looks like parameters.n or body.0.material");
  return segments;
}

/// The entry of a list, by number from 0 or by the `name` of a table in it.
Node& entry_of(Node& list, const std::string& segment, const std::string& where, const Place& place) {
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(segment.data(), segment.data() + segment.size(), index);
  if (error == std::errc() && end == segment.data() + segment.size()) {
    if (index < list.items.size()) return list.items[index];
    throw CaseError(place, "\"" + where + "\" has no entry " + segment + "; it has " + std::to_string(list.items.size()) +
                               ", counted from 0");
  }
  std::vector<std::string> names;
  for (Node& item : list.items) {
    const Node* name = item.find("name");
    if (!name || !name->is(Node::Kind::string)) continue;
    if (name->text == segment) return item;
    names.push_back(name->text);
  }
  throw CaseError(place, "\"" + where + "\": " + unknown_name_message("name", segment, names));
}

void check_parameter(const Node& root, const std::string& name, const Place& place) {
  std::vector<std::string> names;
  if (const Node* table = root.find("parameters"))
    for (const Node::Member& member : table->members) names.push_back(member.key);
  if (std::find(names.begin(), names.end(), name) == names.end())
    throw CaseError(place, unknown_name_message("parameter", name, names));
}

}  // namespace

void override_value(Node& root, const std::string& path, const Node& value) {
  const std::vector<std::string> segments = segments_of(path, value.place);
  if (segments.size() == 2 && segments[0] == "parameters") check_parameter(root, segments[1], value.place);
  Node* node = &root;
  std::string where;
  for (const std::string& segment : segments) {
    if (node->is(Node::Kind::array)) {
      node = &entry_of(*node, segment, where, value.place);
    } else if (node->is(Node::Kind::table)) {
      node = &node->at_or_insert(segment, value.place);
    } else {
      throw CaseError(value.place,
                      "\"" + where + "\" is " + node->kind_name() + " and has nothing inside, so there is no \"" + path + "\"");
    }
    where += (where.empty() ? "" : ".") + segment;
  }
  *node = value;
}

}  // namespace sinew
