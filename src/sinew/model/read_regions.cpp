#include <sinew/model/read_case.hpp>

#include <algorithm>

namespace sinew {
namespace {

std::vector<std::string> body_names(const CaseReader& reader) {
  std::vector<std::string> names;
  for (const BodyCase& body : reader.result.bodies) names.push_back(body.name);
  return names;
}

RegionCase read_region(const CaseReader& reader, const Node& table, const std::string& name, const std::string& owner,
                       Node& resolved) {
  RegionCase region;
  resolved = read_described(region, table, owner, reader.reading);
  region.name = name;
  region.place = table.place;
  if (table.members.empty()) throw CaseError(table.place, owner + ": give at least one of body, where, box, nearest, set");
  if (region.where && (region.where->depends_on_time() || region.where->depends_on_current_place()))
    throw CaseError(table.find("where")->place,
                    owner + ": where = \"" + region.where->text() +
                        "\" may use X, Y and Z only: a region is chosen once, in the reference configuration");
  const std::vector<std::string> bodies = body_names(reader);
  if (!region.body.empty() && std::find(bodies.begin(), bodies.end(), region.body) == bodies.end())
    throw CaseError(table.find("body")->place, owner + ": " + unknown_name_message("body", region.body, bodies));
  return region;
}

}  // namespace

void read_regions(CaseReader& reader) {
  const Node table = section_table(reader, "region");
  Node resolved = Node::make_table(table.place);
  for (const Node::Member& member : table.members) {
    const std::string owner = "region \"" + member.key + "\"";
    check_new_name(member.key, member.place, "region", body_names(reader));
    Node filled;
    reader.result.regions[member.key] = read_region(reader, member.value, member.key, owner, filled);
    resolved.members.push_back({member.key, member.place, std::move(filled)});
  }
  add_resolved(reader, "region", std::move(resolved));

  RegionCase& all = reader.result.regions["all"];
  all.name = "all";
  for (const BodyCase& body : reader.result.bodies) {
    RegionCase& region = reader.result.regions[body.name];
    region.name = region.body = body.name;
    region.place = body.place;
  }
}

void add_inline_region(CaseReader& reader, const Node& table, const std::string& name) {
  Node resolved;
  RegionCase region = read_region(reader, table, name, name + ": region", resolved);
  region.is_inline = true;
  reader.result.regions[name] = std::move(region);
}

void check_region(const CaseReader& reader, const std::string& name, const Place& place, const std::string& owner) {
  std::vector<std::string> known;
  for (const auto& [key, region] : reader.result.regions)
    if (!region.is_inline) known.push_back(key);
  if (std::find(known.begin(), known.end(), name) != known.end()) return;
  throw CaseError(place, owner + ": " + unknown_name_message("region", name, known));
}

}  // namespace sinew
