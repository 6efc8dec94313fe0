#include <sinew/model/read_case.hpp>

#include <algorithm>

namespace sinew {
namespace {

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

const Place& place_of(const Node& entry, const std::string& key) {
  const Node* node = entry.find(key);
  return node ? node->place : entry.place;
}

void check_name(const CaseReader& reader, const ProbeCase& probe, const Node& entry, const std::vector<std::string>& taken) {
  const Place& place = place_of(entry, "name");
  check_new_name(probe.name, place, "probe", taken);
  const std::string start = "the probe name \"" + probe.name + "\" ";
  if (!is_identifier(probe.name))
    throw CaseError(place, start + "must consist of letters, digits and _, and begin with a letter");
  if (is_reserved_name(probe.name) || reader.result.parameters.contains(probe.name))
    throw CaseError(place, start + "already means something in expressions; choose another");
}

void check_component(const ProbeCase& probe, const QuantityInfo& quantity, const Node& entry, const std::string& owner,
                     int dimension) {
  const std::vector<std::string> known = component_names(quantity, dimension);
  if (probe.component.empty() && !known.empty())
    throw CaseError(entry.place, owner + ": \"component\" is missing; " + probe.quantity + " needs one of " + joined(known));
  if (!probe.component.empty() && known.empty())
    throw CaseError(place_of(entry, "component"), owner + ": " + probe.quantity + " is a scalar and has no component; remove it");
  if (!probe.component.empty() && std::find(known.begin(), known.end(), probe.component) == known.end())
    throw CaseError(place_of(entry, "component"),
                    owner + ": component of " + probe.quantity + ": " + unknown_name_message("name", probe.component, known));
}

void check_wall(const CaseReader& reader, const ProbeCase& probe, const Node& entry, const std::string& owner) {
  if (probe.quantity != "wall_force") {
    if (!probe.wall.empty()) throw CaseError(place_of(entry, "wall"), owner + ": \"wall\" belongs to wall_force only");
    return;
  }
  std::vector<std::string> known;
  for (const WallCase& wall : reader.result.walls) known.push_back(wall.name);
  if (probe.wall.empty()) throw CaseError(entry.place, owner + ": \"wall\" is missing; it says whose force is followed");
  if (std::find(known.begin(), known.end(), probe.wall) == known.end())
    throw CaseError(place_of(entry, "wall"), owner + ": " + unknown_name_message("wall", probe.wall, known));
}

void check_quantity(const CaseReader& reader, ProbeCase& probe, const Node& entry, const std::string& owner, int dimension,
                    Node& resolved) {
  const QuantityInfo& quantity = *find_quantity(probe.quantity);
  check_component(probe, quantity, entry, owner, dimension);
  if (probe.quantity == "thickness_stretch" && dimension == 3)
    throw CaseError(place_of(entry, "quantity"), owner + ": thickness_stretch exists in two dimensions only");
  if (probe.quantity == "hourglass_error" && reader.result.formulation.model == "updated_lagrangian")
    throw CaseError(place_of(entry, "quantity"), owner +
                                                     ": hourglass_error does not exist with \"updated_lagrangian\", whose "
                                                     "deformation gradient is not one of displacements");
  const bool counts_pieces = probe.quantity == "fragments" || probe.quantity == "largest_fragment" || probe.quantity == "debris";
  if (counts_pieces && reader.result.formulation.reference_update)
    throw CaseError(place_of(entry, "quantity"),
                    owner + ": " + probe.quantity + " does not go with reference_update, which joins anew what is near");
  if (probe.quantity == "reaction_force" && probe.region.empty())
    throw CaseError(entry.place, owner + ": \"region\" is missing; it says on which particles the reaction force is summed");
  check_wall(reader, probe, entry, owner);
  if (!quantity.is_total) return;
  if (probe.exact)
    throw CaseError(place_of(entry, "exact"),
                    owner + ": " + probe.quantity + " is one number already; subtract from it in a probe with \"expression\"");
  if (entry.find("reduce") && probe.reduce != "sum")
    throw CaseError(place_of(entry, "reduce"),
                    owner + ": " + probe.quantity + " is one number already, so reduce can only be \"sum\"");
  probe.reduce = "sum";
  set_member(resolved, "reduce", Node::make_string("sum"));
}

/// A formula over earlier probes takes none of the keys that pick particles.
void check_expression(const CaseReader& reader, const ProbeCase& probe, const Node& entry, const std::string& owner,
                      const std::vector<std::string>& earlier, Node& resolved) {
  for (const std::string key : {"quantity", "region", "reduce", "exact", "component", "wall"}) {
    if (entry.find(key))
      throw CaseError(place_of(entry, key),
                      owner + ": \"expression\" is a formula over other probes and cannot have \"" + key + "\"");
    erase_member(resolved, key);
  }
  std::vector<std::string> variables = earlier;
  variables.push_back("t");
  try {
    Expression::over(variables, probe.expression, reader.reading.constants, Place{});
  } catch (const CaseError& error) {
    throw CaseError(place_of(entry, "expression"), owner + ": " + error.what());
  }
}

}  // namespace

void read_probes(CaseReader& reader) {
  Node resolved = Node::make_array();
  std::vector<std::string> names;
  for (const Node& entry : section_entries(reader, "probe")) {
    ProbeCase probe;
    const Node* name = entry.find("name");
    const std::string owner =
        name && name->is(Node::Kind::string) ? "probe \"" + name->text + "\"" : "probe " + std::to_string(names.size() + 1);
    Node filled = read_with_region(reader, probe, entry, owner);
    check_name(reader, probe, entry, names);
    if (probe.quantity.empty() && probe.expression.empty())
      throw CaseError(entry.place, owner + ": nothing is measured; give \"quantity\" or \"expression\"");
    if (!probe.expression.empty())
      check_expression(reader, probe, entry, owner, names, filled);
    else
      check_quantity(reader, probe, entry, owner, reader.reading.dimension, filled);
    names.push_back(probe.name);
    resolved.items.push_back(std::move(filled));
    reader.result.probes.push_back(std::move(probe));
  }
  add_resolved(reader, "probe", std::move(resolved));
}

}  // namespace sinew
