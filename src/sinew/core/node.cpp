#include <sinew/core/node.hpp>

namespace sinew {

const Node* Node::find(std::string_view key) const {
  for (const Member& member : members)
    if (member.key == key) return &member.value;
  return nullptr;
}

Node* Node::find(std::string_view key) { return const_cast<Node*>(std::as_const(*this).find(key)); }

Node& Node::at_or_insert(std::string_view key, const Place& where) {
  if (Node* found = find(key)) return *found;
  members.push_back({std::string(key), where, make_table(where)});
  return members.back().value;
}

std::string Node::kind_name() const {
  switch (kind) {
    case Kind::table: return "a table";
    case Kind::array: return "an array";
    case Kind::string: return "a string";
    case Kind::integer: return "an integer";
    case Kind::number: return "a number";
    case Kind::boolean: return "true or false";
  }
  return "nothing";
}

namespace {
Node make(Node::Kind kind, Place place) {
  Node node;
  node.kind = kind;
  node.place = std::move(place);
  return node;
}
}  // namespace

Node Node::make_table(Place place) { return make(Kind::table, std::move(place)); }
Node Node::make_array(Place place) { return make(Kind::array, std::move(place)); }
Node Node::make_string(std::string text, Place place) {
  Node node = make(Kind::string, std::move(place));
  node.text = std::move(text);
  return node;
}
Node Node::make_number(double value, Place place) {
  Node node = make(Kind::number, std::move(place));
  node.number = value;
  return node;
}
Node Node::make_integer(long long value, Place place) {
  Node node = make(Kind::integer, std::move(place));
  node.integer = value;
  node.number = static_cast<double>(value);
  return node;
}
Node Node::make_boolean(bool value, Place place) {
  Node node = make(Kind::boolean, std::move(place));
  node.boolean = value;
  return node;
}

}  // namespace sinew
