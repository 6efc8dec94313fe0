#include <sinew/model/read_case.hpp>

#include <algorithm>

namespace sinew {
namespace {

const std::vector<std::string>& reductions() {
  static const std::vector<std::string> names{"final", "min", "max", "at(t)", "range", "drift", "period", "frequency", "rate"};
  return names;
}

[[noreturn]] void fail_reduction(const Node& node, const std::string& owner, const std::string& reduction) {
  throw CaseError(node.place, owner + ": " + unknown_name_message("reduction", reduction, reductions()));
}

/// Takes "probe.NAME.REDUCTION" apart.
void parse_quantity(const CaseReader& reader, ExpectCase& expect, const Node& node, const std::string& owner) {
  const std::string& text = expect.quantity;
  if (text == "status" || text == "end_time") return;  // of the run itself
  if (text == "safety_factor") {
    if (!reader.result.study.safety)
      throw CaseError(node.place, owner + ": safety_factor needs a [study] with safety = { probe = ... }");
    return;
  }
  const std::size_t dot = text.find('.', 6);
  if (!text.starts_with("probe.") || dot == std::string::npos)
    throw CaseError(node.place, owner + ": quantity must look like probe.NAME.final, found \"" + text + "\"");
  expect.probe = text.substr(6, dot - 6);
  const std::string reduction = text.substr(dot + 1);
  std::vector<std::string> probes;
  for (const ProbeCase& probe : reader.result.probes) probes.push_back(probe.name);
  if (std::find(probes.begin(), probes.end(), expect.probe) == probes.end())
    throw CaseError(node.place, owner + ": " + unknown_name_message("probe", expect.probe, probes));
  if (reduction.starts_with("at(") && reduction.ends_with(")")) {
    expect.reduction = "at";
    FieldSpec spec;
    spec.owner = owner;
    spec.key = "quantity";
    spec.unit = "s";
    spec.range = non_negative;
    expect.time = read_number(Node::make_string(reduction.substr(3, reduction.size() - 4), node.place), spec, reader.reading);
    if (expect.time > reader.result.solver.end_time)
      throw CaseError(node.place, owner + ": \"" + text + "\" is later than end_time, the end of the run");
    return;
  }
  if (reduction == "at(t)" || std::find(reductions().begin(), reductions().end(), reduction) == reductions().end())
    fail_reduction(node, owner, reduction);
  expect.reduction = reduction;
}

void check_tolerance(const ExpectCase& expect, const Node& entry, const std::string& owner) {
  if (expect.tolerance && expect.absolute)
    throw CaseError(entry.find("absolute")->place,
                    owner + ": \"tolerance\" (relative) and \"absolute\" are both given; give only one of them");
  if (!expect.tolerance && !expect.absolute)
    throw CaseError(entry.place, owner + ": \"tolerance\" (relative) or \"absolute\" is missing");
  if (expect.tolerance && expect.value == 0.0)
    throw CaseError(entry.find("tolerance")->place,
                    owner + ": a relative tolerance means nothing for value = 0; give \"absolute\"");
}

void check_study_keys(const CaseReader& reader, const ExpectCase& expect, const Node& entry, const std::string& owner) {
  std::vector<std::string> varied;
  for (const auto& [path, values] : reader.result.study.vary) varied.push_back(path);
  if (expect.reduction == "rate" && varied.empty())
    throw CaseError(entry.find("quantity")->place, owner + ": a rate needs several runs; add [study] with vary");
  if (expect.exact && expect.reduction != "rate")
    throw CaseError(entry.find("exact")->place, owner + ": \"exact\" belongs to rate only");
  for (const auto& [path, value] : expect.with)
    if (std::find(varied.begin(), varied.end(), path) == varied.end())
      throw CaseError(entry.find("with")->place, owner + ": with: " + unknown_name_message("key", path, varied));
}

void check_safety(const CaseReader& reader, const Node& table) {
  const StudyCase& study = reader.result.study;
  std::vector<std::string> probes;
  for (const ProbeCase& probe : reader.result.probes) probes.push_back(probe.name);
  const Node& safety = *table.find("safety");
  if (std::find(probes.begin(), probes.end(), study.safety->probe) == probes.end())
    throw CaseError(safety.find("probe")->place,
                    "[study]: safety: " + unknown_name_message("probe", study.safety->probe, probes));
  if (study.vary.size() != 1)
    throw CaseError(safety.place, "[study]: safety: vary must have one key, the factor that reduces the strength");
}

void read_study(CaseReader& reader) {
  if (!reader.root.find("study")) return;
  const Node table = section_table(reader, "study");
  StudyCase& study = reader.result.study;
  Node resolved = read_described(study, table, "[study]", reader.reading);
  const Node& vary = *table.find("vary");
  if (study.vary.empty())
    throw CaseError(vary.place, "[study]: vary must not be empty; for example { \"parameters.n\" = [4, 8] }");
  for (const Node::Member& member : vary.members) {
    try {
      Node copy = reader.root;
      override_value(copy, member.key, Node::make_number(0.0));
      check_keys(copy, "", top_level_keys());
    } catch (const CaseError& error) {
      throw CaseError(member.place, std::string("[study]: vary: ") + error.what());
    }
  }
  if (study.safety) check_safety(reader, table);
  add_resolved(reader, "study", std::move(resolved));
}

}  // namespace

void read_study_and_expects(CaseReader& reader) {
  read_study(reader);
  Node resolved = Node::make_array();
  for (const Node& entry : section_entries(reader, "expect")) {
    ExpectCase expect;
    const std::string owner = "expect " + std::to_string(resolved.items.size() + 1);
    resolved.items.push_back(read_described(expect, entry, owner, reader.reading));
    expect.place = entry.place;
    parse_quantity(reader, expect, *entry.find("quantity"), owner);
    check_tolerance(expect, entry, owner);
    check_study_keys(reader, expect, entry, owner);
    reader.result.expects.push_back(std::move(expect));
  }
  add_resolved(reader, "expect", std::move(resolved));
}

}  // namespace sinew
