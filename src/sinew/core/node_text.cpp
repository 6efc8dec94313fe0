#include <sinew/core/node_text.hpp>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <sinew/core/number_text.hpp>

namespace sinew {
namespace {

std::string float_text(double value) {
  const std::string text = number_text(value);
  return text.find_first_of(".ein") == std::string::npos ? text + ".0" : text;
}

std::string array_text(const std::vector<Node>& items) {
  std::string text = "[";
  for (const Node& item : items) text += (text.size() > 1 ? ", " : "") + value_text(item);
  return text + "]";
}

std::string table_text(const std::vector<Node::Member>& members) {
  if (members.empty()) return "{}";
  std::string text = "{ ";
  for (const Node::Member& member : members)
    text += (text.size() > 2 ? ", " : "") + key_text(member.key) + " = " + value_text(member.value);
  return text + " }";
}

}  // namespace

std::string quoted_text(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      result += std::string("\\") + c;
    } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
      char escape[8];
      std::snprintf(escape, sizeof(escape), "\\u%04X", static_cast<unsigned>(c));
      result += escape;
    } else {
      result += c;
    }
  }
  return result + "\"";
}

std::string key_text(const std::string& key) {
  const auto bare = [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-'; };
  return !key.empty() && std::all_of(key.begin(), key.end(), bare) ? key : quoted_text(key);
}

std::string value_text(const Node& value) {
  switch (value.kind) {
    case Node::Kind::table: return table_text(value.members);
    case Node::Kind::array: return array_text(value.items);
    case Node::Kind::string: return quoted_text(value.text);
    case Node::Kind::integer: return std::to_string(value.integer);
    case Node::Kind::number: return float_text(value.number);
    case Node::Kind::boolean: return value.boolean ? "true" : "false";
  }
  return {};
}

}  // namespace sinew
