#include <sinew/model/read_case.hpp>

#include <algorithm>

namespace sinew {

const std::vector<std::string>& StageCase::own_sections() {
  static const std::vector<std::string> sections{"material", "formulation", "boundary", "body_force", "solver"};
  return sections;
}

namespace {

/// Tables take over the members of another one, table by table, unless that names a model; everything else is replaced.
void merge(Node& into, const Node& from) {
  for (const Node::Member& member : from.members) {
    Node& old = into.at_or_insert(member.key, member.place);
    if (old.is(Node::Kind::table) && member.value.is(Node::Kind::table) && !member.value.find("model"))
      merge(old, member.value);
    else
      old = member.value;
  }
}

/// Only materials that have a table of their own can be told what is different.
void check_named_materials(const Node& file, const Node& entry, const std::string& owner) {
  const Node* own = entry.find("material");
  if (!own) return;
  std::vector<std::string> names;
  if (const Node* all = file.find("material"))
    for (const Node::Member& member : all->members) names.push_back(member.key);
  for (const Node::Member& member : own->members)
    if (std::find(names.begin(), names.end(), member.key) == names.end())
      throw CaseError(member.place, owner + ": " + unknown_name_message("[material.NAME]", member.key, names));
}

/// The case file while a stage lasts, without what is about the whole run.
Node root_of(const Node& file, const Node& entry, const StageCase& stage) {
  Node root = file;
  std::erase_if(root.members, [](const Node::Member& m) { return m.key == "stage" || m.key == "study" || m.key == "expect"; });
  for (const std::string& section : StageCase::own_sections())
    if (const Node* own = entry.find(section)) {
      Node one = Node::make_table(entry.place);
      set_member(one, section, *own);
      merge(root, one);
    }
  Node& solver = root.at_or_insert("solver", entry.place);
  set_member(solver, "end_time", Node::make_number(stage.end, entry.place));
  if (const Node* mode = solver.find("mode"); mode && mode->is(Node::Kind::string) && mode->text == "static") {
    if (const Node* ramp = solver.find("ramp"))
      throw CaseError(ramp->place, "[solver]: ramp belongs to runs without [[stage]]; here, formulas with t say how loads grow");
    set_member(solver, "ramp", Node::make_boolean(false, entry.place));
  }
  erase_member(solver, "max_steps");
  return root;
}

void check_settle(const Case& c, const StageCase& stage) {
  for (const BodyCase& body : c.bodies) {
    const bool in_rates = std::visit(
        []<class M>(const M&) {
          return requires { M::in_rates; };
        },
        body.material);
    if (in_rates && !body.damage) continue;
    throw CaseError(stage.place,
                    "stage \"" + stage.name + "\": settle keeps the stress of particles that go back, which body \"" + body.name +
                        "\" cannot: only materials that are written in rates (hypoelastic, drucker_prager, mu_i_rheology), "
                        "without damage, do not need the deformation for it");
  }
}

/// Histories go on, so they have to be of the same kind.
void check_materials(const Case& before, const Case& now, const StageCase& stage) {
  for (std::size_t b = 0; b < now.bodies.size(); ++b) {
    const BodyCase &old = before.bodies[b], &body = now.bodies[b];
    if (old.material.index() == body.material.index() && old.damage.has_value() == body.damage.has_value()) continue;
    throw CaseError(stage.place, "stage \"" + stage.name + "\": the material of body \"" + body.name +
                                     "\" changes its model; stages may change its parameters only");
  }
}

void check_residual(const Case& c, const StageCase& stage) {
  if (!stage.residual) return;
  const bool constant =
      std::all_of(c.body_force.begin(), c.body_force.end(), [](const Expression& e) { return e.is_constant(); });
  const bool any =
      constant && std::any_of(c.body_force.begin(), c.body_force.end(), [](const Expression& e) { return e(0.0) != 0.0; });
  if (!any)
    throw CaseError(stage.place,
                    "stage \"" + stage.name + "\": residual is a part of the weight, and there is no constant [body_force]");
}

}  // namespace

/// Each stage is read as a case of its own, so that what is wrong in it is said before the run.
void read_stages(CaseReader& reader) {
  std::vector<std::string> taken;
  Node resolved = Node::make_array();
  double end = 0.0;
  std::optional<Case> before;
  for (const Node& entry : section_entries(reader, "stage")) {
    StageCase stage;
    const std::string owner = "stage " + std::to_string(taken.size() + 1);
    resolved.items.push_back(read_described(stage, entry, owner, reader.reading, StageCase::own_sections()));
    check_new_name(stage.name, entry.place, "stage", taken);
    check_named_materials(reader.root, entry, owner);
    taken.push_back(stage.name);
    stage.place = entry.place;
    stage.end = end += stage.duration;
    stage.root = root_of(reader.root, entry, stage);
    Case now = make_case(stage.root, reader.result.folder);
    if (stage.settle) check_settle(now, stage);
    check_residual(now, stage);
    if (before) check_materials(*before, now, stage);
    before = std::move(now);
    reader.result.stages.push_back(std::move(stage));
  }
  add_resolved(reader, "stage", std::move(resolved));
}

}  // namespace sinew
