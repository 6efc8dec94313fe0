#include <sinew/model/read_case.hpp>

namespace sinew {
namespace {

struct MaterialCase {
  AnyMaterial material;
  std::optional<AnyDamage> damage;
};
using NamedMaterials = std::map<std::string, MaterialCase>;

bool has_history(const AnyMaterial& any) {
  return std::visit([]<class Material>(const Material&) { return HasHistory<Material>; }, any);
}

std::string name_of(const AnyMaterial& any) {
  return std::visit([](const auto& material) { return std::string(material.name); }, any);
}

/// A material with its damage. Returns the table with the defaults filled in.
Node read_material(CaseReader& reader, MaterialCase& material, const Node& entry, const std::string& owner) {
  Node table = entry;
  const Node* damage = entry.find("damage");
  if (damage) erase_member(table, "damage");
  Node resolved = read_registered(material.material, table, owner, reader.reading);
  if (!damage) return resolved;
  Node filled = read_registered(material.damage.emplace(), *damage, owner + ": damage", reader.reading);
  if (std::holds_alternative<Rigid>(material.material))
    throw CaseError(damage->place, owner + ": damage: a rigid material has no stress that damage could take");
  const bool needs_flow = std::visit([](const auto& model) { return model.needs_flow; }, *material.damage);
  if (needs_flow && !has_history(material.material))
    throw CaseError(damage->place, owner + ": damage: this model follows plastic strain, of which \"" +
                                       name_of(material.material) + "\" has none");
  set_member(resolved, "damage", std::move(filled));
  return resolved;
}

NamedMaterials read_materials(CaseReader& reader) {
  NamedMaterials materials;
  const Node table = section_table(reader, "material");
  Node resolved = Node::make_table(table.place);
  for (const Node::Member& member : table.members) {
    const std::string owner = "material \"" + member.key + "\"";
    if (!member.value.is(Node::Kind::table))
      throw CaseError(member.place, owner + ": expected a table, written as [material." + key_text(member.key) + "], found " +
                                        member.value.kind_name());
    Node filled = read_material(reader, materials[member.key], member.value, owner);
    resolved.members.push_back({member.key, member.place, std::move(filled)});
  }
  add_resolved(reader, "material", std::move(resolved));
  return materials;
}

std::vector<std::string> names_of(const NamedMaterials& materials) {
  std::vector<std::string> names;
  for (const auto& [name, material] : materials) names.push_back(name);
  return names;
}

std::string owner_of(const Node& entry, std::size_t number) {
  const Node* name = entry.find("name");
  return name && name->is(Node::Kind::string) ? "body \"" + name->text + "\"" : "body " + std::to_string(number);
}

/// Reads one [[body]]; an inline material is put among the named ones.
Node read_body(CaseReader& reader, BodyCase& body, const Node& entry, const std::string& owner, NamedMaterials& materials) {
  Node table = entry;
  Node* material = table.find("material");
  std::optional<Node> inline_material;
  if (material && material->is(Node::Kind::table)) {
    const std::string name = "of " + owner;
    inline_material = read_material(reader, materials[name], *material, owner + ": material");
    *material = Node::make_string(name, material->place);
  }
  Node resolved = read_described(body, table, owner, reader.reading);
  if (inline_material) set_member(resolved, "material", *inline_material);
  const auto found = materials.find(body.material_name);
  if (found == materials.end()) {
    const std::string how =
        materials.empty() ? " A material is defined by a table [material." + key_text(body.material_name) + "]." : "";
    throw CaseError(material->place,
                    owner + ": " + unknown_name_message("material", body.material_name, names_of(materials)) + how);
  }
  body.material = found->second.material;
  body.damage = found->second.damage;
  if (reader.result.general.dimension == 2 && reader.result.general.plane == PlaneState::stress &&
      (has_history(body.material) || body.damage))
    throw CaseError(material->place, owner + ": material model \"" + name_of(body.material) +
                                         "\" knows no plane stress; use plane = \"strain\" or three dimensions");
  body.place = entry.place;
  body.geometry_place = table.find("geometry")->place;
  return resolved;
}

}  // namespace

void read_materials_and_bodies(CaseReader& reader) {
  const std::vector<Node> entries = section_entries(reader, "body");
  if (entries.empty())
    throw CaseError(reader.root.place, "there is no body; a case needs at least one [[body]] with name, geometry and material");
  const std::size_t position = reader.result.resolved.members.size();
  NamedMaterials materials = read_materials(reader);
  Node resolved = Node::make_array(entries[0].place);
  std::vector<std::string> names;
  for (const Node& entry : entries) {
    BodyCase body;
    const std::string owner = owner_of(entry, names.size() + 1);
    resolved.items.push_back(read_body(reader, body, entry, owner, materials));
    check_new_name(body.name, entry.find("name")->place, "body", names);
    names.push_back(body.name);
    reader.result.bodies.push_back(std::move(body));
  }
  std::vector<Node::Member>& members = reader.result.resolved.members;
  members.insert(members.begin() + static_cast<std::ptrdiff_t>(position), {"body", resolved.place, std::move(resolved)});
}

}  // namespace sinew
