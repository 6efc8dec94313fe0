#include <sinew/model/case.hpp>

#include <algorithm>
#include <filesystem>
#include <sinew/model/boundary_keys.hpp>
#include <sinew/model/read_case.hpp>

namespace sinew {

const std::vector<std::string>& top_level_keys() {
  static const std::vector<std::string> keys{"case",    "parameters", "body",       "material", "formulation", "region",
                                             "initial", "boundary",   "body_force", "contact",  "wall",        "solver",
                                             "stage",   "output",     "probe",      "expect",   "study"};
  return keys;
}

Node section_table(const CaseReader& reader, const std::string& key) {
  const Node* node = reader.root.find(key);
  if (!node) return Node::make_table(Place{reader.root.place.file});
  if (!node->is(Node::Kind::table))
    throw CaseError(node->place, "\"" + key + "\": expected a table, written as [" + key + "], found " + node->kind_name());
  return *node;
}

std::vector<Node> section_entries(const CaseReader& reader, const std::string& key) {
  const Node* node = reader.root.find(key);
  if (!node) return {};
  const auto is_table = [](const Node& item) { return item.is(Node::Kind::table); };
  if (!node->is(Node::Kind::array) || !std::all_of(node->items.begin(), node->items.end(), is_table))
    throw CaseError(node->place,
                    "\"" + key + "\": expected a list of tables, each written as [[" + key + "]], found " + node->kind_name());
  return node->items;
}

void add_resolved(CaseReader& reader, const std::string& key, Node value) {
  if (value.members.empty() && value.items.empty()) return;
  reader.result.resolved.members.push_back({key, value.place, std::move(value)});
}

void set_member(Node& table, const std::string& key, Node value) { table.at_or_insert(key, value.place) = std::move(value); }

void erase_member(Node& table, const std::string& key) {
  std::erase_if(table.members, [&](const Node::Member& member) { return member.key == key; });
}

void check_new_name(const std::string& name, const Place& place, const std::string& what, const std::vector<std::string>& taken) {
  if (name.empty()) throw CaseError(place, "the name of a " + what + " must not be empty");
  if (name == "all") throw CaseError(place, "a " + what + " cannot be called \"all\", which means all particles");
  if (name.find('.') != std::string::npos)
    throw CaseError(place, "the name of a " + what + " must not contain a dot, found \"" + name + "\"");
  if (std::find(taken.begin(), taken.end(), name) != taken.end())
    throw CaseError(place, "the name \"" + name + "\" of a " + what + " is already taken; choose another");
}

Case make_case(const Node& root, const std::string& folder) {
  CaseReader reader{root, {}, {}};
  reader.result.folder = std::filesystem::absolute(folder.empty() ? "." : folder).lexically_normal().string();
  reader.result.resolved = Node::make_table(root.place);
  reader.reading.folder = reader.result.folder;
  check_keys(root, "", top_level_keys());
  read_general(reader);
  read_materials_and_bodies(reader);
  read_formulation(reader);
  read_regions(reader);
  read_conditions(reader);
  read_contacts(reader);
  read_stages(reader);
  read_solver_and_output(reader);
  read_probes(reader);
  read_study_and_expects(reader);
  return std::move(reader.result);
}

namespace {
/// With the key that names the law.
std::vector<ParameterDoc> contact_docs() {
  std::vector<ParameterDoc> docs = parameter_docs<ContactCase>();
  docs.insert(docs.begin(), {"model", "name", "", "hertz", "\"hertz\"", "The law of contact.", false});
  return docs;
}
}  // namespace

std::vector<std::pair<std::string, std::vector<ParameterDoc>>> case_sections() {
  return {{"[case]", parameter_docs<GeneralCase>()},
          {"[parameters]", {}},
          {"[[body]]", parameter_docs<BodyCase>()},
          {"[material.NAME]",
           {{"model", "name", "", "", "", "The material model; its own parameters follow in the same table.", true}}},
          {"[formulation]", parameter_docs<FormulationCase>()},
          {"[region.NAME]", parameter_docs<RegionCase>()},
          {"[[initial]]", parameter_docs<InitialCase>()},
          {"[[boundary]]", parameter_docs<BoundaryKeys>()},
          {"[body_force]", parameter_docs<BodyForceCase>()},
          {"[[contact]]", contact_docs()},
          {"[[wall]]", parameter_docs<WallCase>()},
          {"[solver]", parameter_docs<SolverCase>()},
          {"[[stage]]", parameter_docs<StageCase>()},
          {"[output]", parameter_docs<OutputCase>()},
          {"[[probe]]", parameter_docs<ProbeCase>()},
          {"[[expect]]", parameter_docs<ExpectCase>()},
          {"[study]", parameter_docs<StudyCase>()}};
}

}  // namespace sinew
