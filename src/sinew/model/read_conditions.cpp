#include <sinew/model/boundary_keys.hpp>
#include <sinew/model/read_case.hpp>

namespace sinew {
namespace {

void read_initial(CaseReader& reader) {
  Node resolved = Node::make_array();
  for (const Node& entry : section_entries(reader, "initial")) {
    InitialCase initial;
    initial.stretch.reset();
    const std::string owner = "initial " + std::to_string(resolved.items.size() + 1);
    resolved.items.push_back(read_with_region(reader, initial, entry, owner));
    if (!initial.velocity && !initial.displacement && !initial.stretch)
      throw CaseError(entry.place, owner + ": give at least one of velocity, displacement, stretch");
    if (initial.displacement && initial.stretch)
      throw CaseError(entry.place, owner + ": \"displacement\" and \"stretch\" both set the positions; give only one of them");
    if (initial.stretch && reader.reading.dimension == 2) (*initial.stretch)[2] = 1.0;
    reader.result.initial.push_back(std::move(initial));
  }
  add_resolved(reader, "initial", std::move(resolved));
}

std::array<std::optional<Expression>, 3> with_values(const std::array<Expression, 3>& vector, int dimension) {
  std::array<std::optional<Expression>, 3> value;
  for (std::size_t i = 0; i < static_cast<std::size_t>(dimension); ++i) value[i] = vector[i];
  return value;
}

/// The one quantity that is prescribed.
BoundaryCase chosen(const BoundaryKeys& keys, const std::string& owner, int dimension) {
  BoundaryCase boundary{keys.region, {}, {}, keys.normal, keys.area, keys.follower, keys.place};
  std::vector<std::string> given;
  const auto choose = [&](const std::string& key, BoundaryCase::Kind kind, auto&& value) {
    given.push_back(key);
    boundary.kind = kind;
    boundary.value = value;
  };
  using Kind = BoundaryCase::Kind;
  if (keys.displacement) choose("displacement", Kind::displacement, *keys.displacement);
  if (keys.velocity) choose("velocity", Kind::velocity, *keys.velocity);
  if (keys.force) choose("force", Kind::force, with_values(*keys.force, dimension));
  if (keys.traction) choose("traction", Kind::traction, with_values(*keys.traction, dimension));
  if (keys.pressure) choose("pressure", Kind::pressure, std::array<std::optional<Expression>, 3>{*keys.pressure});
  if (keys.wall) choose("wall", Kind::wall, with_values({}, dimension));
  if (given.empty())
    throw CaseError(keys.place,
                    owner + ": nothing is prescribed; give one of displacement, velocity, force, traction, pressure, wall");
  if (given.size() > 1)
    throw CaseError(keys.place,
                    owner + ": \"" + given[0] + "\" and \"" + given[1] + "\" are both given; write one [[boundary]] for each");
  return boundary;
}

void check_surface_keys(const BoundaryCase& boundary, const Node& entry, const std::string& owner) {
  const bool pressure = boundary.kind == BoundaryCase::Kind::pressure;
  const bool surface = pressure || boundary.kind == BoundaryCase::Kind::traction;
  if (boundary.normal && !pressure && boundary.kind != BoundaryCase::Kind::wall)
    throw CaseError(entry.find("normal")->place, owner + ": \"normal\" belongs to pressure and wall only");
  if (boundary.area && !surface)
    throw CaseError(entry.find("area")->place, owner + ": \"area\" belongs to traction and pressure only");
  if (boundary.follower && !pressure)
    throw CaseError(entry.find("follower")->place, owner + ": \"follower\" belongs to pressure only");
  if (boundary.normal && norm(*boundary.normal) == 0.0)
    throw CaseError(entry.find("normal")->place, owner + ": normal must not be the zero vector");
}

/// Its normals are made from the neighbors of the beginning.
void check_follower(const CaseReader& reader, const BoundaryCase& boundary, const Node& entry, const std::string& owner) {
  if (!boundary.follower) return;
  const Case& c = reader.result;
  const auto refuse = [&](const std::string& text) {
    throw CaseError(entry.find("follower")->place, owner + ": follower " + text);
  };
  if (c.formulation.model != "total_lagrangian") refuse("belongs to model = \"total_lagrangian\"");
  if (c.formulation.reference_update) refuse("does not go with reference_update");
  if (c.general.dimension == 2 && c.general.plane == PlaneState::stress) refuse("goes with plane = \"strain\"");
  for (const BodyCase& body : c.bodies)
    if (body.damage && std::visit([](const auto& damage) { return damage.growth.separate; }, *body.damage))
      refuse("does not go with separate = true of body \"" + body.name + "\"");
}

void check_wall(const CaseReader& reader, const BoundaryKeys& keys, const Node& entry, const std::string& owner) {
  if (!keys.wall) return;
  const Place& place = entry.find("wall")->place;
  const bool slips = *keys.wall == "free_slip";
  if (slips && !keys.normal) throw CaseError(place, owner + ": free_slip needs the normal of the wall, normal = [...]");
  if (!slips && keys.normal) throw CaseError(entry.find("normal")->place, owner + ": a wall with no_slip has no normal");
  if (reader.result.formulation.model != "updated_lagrangian")
    throw CaseError(place,
                    owner +
                        ": walls of particles belong to model = \"updated_lagrangian\"; with \"total_lagrangian\" prescribe "
                        "the displacement, or its normal component, of particles of the body");
  if (!std::holds_alternative<NoCorrection>(reader.result.formulation.correction))
    throw CaseError(place, owner + ": walls of particles go with correction = \"none\"");
}

void read_boundaries(CaseReader& reader) {
  Node resolved = Node::make_array();
  for (const Node& entry : section_entries(reader, "boundary")) {
    BoundaryKeys keys;
    const std::string owner = "boundary " + std::to_string(resolved.items.size() + 1);
    resolved.items.push_back(read_with_region(reader, keys, entry, owner));
    BoundaryCase boundary = chosen(keys, owner, reader.reading.dimension);
    check_surface_keys(boundary, entry, owner);
    check_follower(reader, boundary, entry, owner);
    check_wall(reader, keys, entry, owner);
    reader.result.boundary.push_back(std::move(boundary));
  }
  add_resolved(reader, "boundary", std::move(resolved));
}

}  // namespace

void read_conditions(CaseReader& reader) {
  read_initial(reader);
  read_boundaries(reader);
  if (!reader.root.find("body_force")) return;
  BodyForceCase body_force;
  Node resolved = read_described(body_force, section_table(reader, "body_force"), "[body_force]", reader.reading);
  reader.result.body_force = body_force.acceleration;
  add_resolved(reader, "body_force", std::move(resolved));
}

}  // namespace sinew
