#pragma once
/// A case file after reading and before understanding: tables, arrays and plain values, each with its place in the text.

#include <sinew/core/error.hpp>
#include <string>
#include <utility>
#include <vector>

namespace sinew {

class Node {
 public:
  enum class Kind { table, array, string, integer, number, boolean };
  struct Member;

  Kind kind = Kind::table;
  Place place;                  ///< where the value begins
  std::vector<Member> members;  ///< of a table, in the order of the text
  std::vector<Node> items;      ///< of an array
  std::string text;             ///< of a string
  double number = 0.0;          ///< of a number or an integer
  long long integer = 0;        ///< of an integer
  bool boolean = false;         ///< of a boolean

  bool is(Kind k) const { return kind == k; }
  bool is_numeric() const { return kind == Kind::number || kind == Kind::integer; }
  const Node* find(std::string_view key) const;  ///< nullptr if a table has no such key
  Node* find(std::string_view key);
  /// The member of that key, made (as an empty table) if it is not there.
  Node& at_or_insert(std::string_view key, const Place& place);
  std::string kind_name() const;  ///< "a table", "an array", "a string", "an integer", "a number", "true or false"

  static Node make_table(Place place = {});
  static Node make_array(Place place = {});
  static Node make_string(std::string text, Place place = {});
  static Node make_number(double value, Place place = {});
  static Node make_integer(long long value, Place place = {});
  static Node make_boolean(bool value, Place place = {});
};

struct Node::Member {
  std::string key;
  Place place;  ///< where the key stands
  Node value;
};

}  // namespace sinew
