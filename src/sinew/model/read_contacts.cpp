#include <sinew/model/read_case.hpp>

#include <algorithm>

namespace sinew {
namespace {

void check_bodies(const CaseReader& reader, const std::vector<std::string>& bodies, const Node& entry, const std::string& owner) {
  std::vector<std::string> known;
  for (const BodyCase& body : reader.result.bodies) known.push_back(body.name);
  for (const std::string& name : bodies)
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw CaseError(entry.find("bodies")->place, owner + ": bodies: " + unknown_name_message("body", name, known));
}

void check_motion(const WallCase& wall, const Node& entry, const std::string& owner) {
  if (wall.velocity && wall.displacement)
    throw CaseError(entry.find("velocity")->place,
                    owner + ": \"displacement\" and \"velocity\" both move the wall; give only one of them");
  for (const auto* motion : {&wall.velocity, &wall.displacement})
    for (int i = 0; i < 3 && *motion; ++i)
      if ((**motion)[i].depends_on_place())
        throw CaseError(entry.find(motion == &wall.velocity ? "velocity" : "displacement")->place,
                        owner + ": \"" + (**motion)[i].text() + "\" may use t only: a wall moves as a whole");
}

}  // namespace

void read_contacts(CaseReader& reader) {
  Node resolved = Node::make_array();
  std::vector<std::string> names;
  for (const Node& entry : section_entries(reader, "wall")) {
    WallCase wall;
    const Node* name = entry.find("name");
    const std::string owner =
        name && name->is(Node::Kind::string) ? "wall \"" + name->text + "\"" : "wall " + std::to_string(names.size() + 1);
    resolved.items.push_back(read_described(wall, entry, owner, reader.reading));
    wall.place = entry.place;
    check_new_name(wall.name, name->place, "wall", names);
    check_bodies(reader, wall.bodies, entry, owner);
    check_motion(wall, entry, owner);
    names.push_back(wall.name);
    reader.result.walls.push_back(std::move(wall));
  }
  add_resolved(reader, "wall", std::move(resolved));
}

}  // namespace sinew
