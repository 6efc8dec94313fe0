#include <sinew/model/parameters.hpp>

#include <algorithm>

namespace sinew {
namespace {

class Evaluation {
 public:
  Evaluation(const Node& table, const Reading& reading) : table_(table), reading_(reading) { reading_.constants.clear(); }

  Constants run() {
    for (const Node::Member& member : table_.members) check_name(member);
    for (const Node::Member& member : table_.members) evaluate(member);
    return reading_.constants;
  }

 private:
  void check_name(const Node::Member& member) const {
    const std::string start = "[parameters]: the name \"" + member.key + "\" ";
    if (!is_identifier(member.key))
      throw CaseError(member.place, start + "cannot be used in expressions; use letters, digits and _, and begin with a letter");
    if (is_reserved_name(member.key) || member.key == "end_time")
      throw CaseError(member.place, start + "already means something in expressions; choose another");
  }

  void evaluate(const Node::Member& member) {
    if (reading_.constants.contains(member.key)) return;
    if (std::find(open_.begin(), open_.end(), member.key) != open_.end()) fail_cycle(member);
    open_.push_back(member.key);
    if (member.value.is(Node::Kind::string) && !split_quantity(member.value.text))
      for (const std::string& name : names_in_expression(member.value.text)) evaluate_if_parameter(name);
    FieldSpec spec;
    spec.owner = "[parameters]";
    spec.key = member.key;
    spec.unit = any_unit;
    reading_.constants[member.key] = read_number(member.value, spec, reading_);
    open_.pop_back();
  }

  void evaluate_if_parameter(const std::string& name) {
    for (const Node::Member& member : table_.members)
      if (member.key == name) evaluate(member);
  }

  [[noreturn]] void fail_cycle(const Node::Member& member) const {
    std::string chain;
    for (auto name = std::find(open_.begin(), open_.end(), member.key); name != open_.end(); ++name) chain += *name + " -> ";
    throw CaseError(member.value.place, "[parameters]: \"" + member.key + "\" depends on itself: " + chain + member.key);
  }

  const Node& table_;
  Reading reading_;
  std::vector<std::string> open_;  ///< the parameters that wait for one another
};

}  // namespace

Constants evaluate_parameters(const Node& table, const Reading& reading) {
  if (!table.is(Node::Kind::table)) throw CaseError(table.place, "[parameters]: expected a table, found " + table.kind_name());
  return Evaluation(table, reading).run();
}

}  // namespace sinew
