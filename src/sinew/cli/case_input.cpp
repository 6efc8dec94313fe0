#include <sinew/cli/case_input.hpp>

#include <cmath>
#include <filesystem>
#include <sinew/core/error.hpp>
#include <sinew/io/read_toml.hpp>
#include <sinew/model/case.hpp>

namespace sinew {

namespace {

void apply_override(Node& root, const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0)
    throw CaseError("--set: expected key.path=value, for example parameters.n=16, found \"" + text + "\"");
  const Place place{"--set " + text};
  override_value(root, text.substr(0, equals), read_toml_value(text.substr(equals + 1), place));
}

Node number_node(double value, const Place& place) {
  constexpr double exact_integers = 1e15;
  if (value == std::round(value) && std::abs(value) < exact_integers)
    return Node::make_integer(static_cast<long long>(value), place);
  return Node::make_number(value, place);
}

}  // namespace

CaseInput read_case_input(const std::string& path, const std::vector<std::string>& overrides) {
  CaseInput input{read_toml_file(path), std::filesystem::path(path).parent_path().string()};
  for (const std::string& text : overrides) apply_override(input.root, text);
  return input;
}

Node study_member(const Node& root, const std::vector<std::pair<std::string, double>>& values) {
  Node member = root;
  std::erase_if(member.members, [](const Node::Member& m) { return m.key == "study" || m.key == "expect"; });
  for (const auto& [path, value] : values) override_value(member, path, number_node(value, Place{"[study] " + path}));
  return member;
}

}  // namespace sinew
