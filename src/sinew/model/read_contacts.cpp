#include <sinew/model/read_case.hpp>

#include <algorithm>
#include <cmath>

namespace sinew {
namespace {

void check_bodies(const CaseReader& reader, const std::vector<std::string>& bodies, const Node& entry, const std::string& owner) {
  std::vector<std::string> known;
  for (const BodyCase& body : reader.result.bodies) known.push_back(body.name);
  for (const std::string& name : bodies)
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw CaseError(entry.find("bodies")->place, owner + ": bodies: " + unknown_name_message("body", name, known));
  for (std::size_t k = 0; k < bodies.size(); ++k)
    if (std::find(bodies.begin(), bodies.begin() + static_cast<std::ptrdiff_t>(k), bodies[k]) !=
        bodies.begin() + static_cast<std::ptrdiff_t>(k))
      throw CaseError(entry.find("bodies")->place, owner + ": bodies: \"" + bodies[k] + "\" is named twice");
  if (entry.find("bodies") && bodies.empty())
    throw CaseError(entry.find("bodies")->place, owner + ": bodies: name at least one, or leave the key out for all");
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
      else if (!std::isfinite((**motion)[i](0.0)))
        throw CaseError(entry.find(motion == &wall.velocity ? "velocity" : "displacement")->place,
                        owner + ": \"" + (**motion)[i].text() + "\" is not a finite number at t = 0");
}

/// The law is named by "model", "hertz" if it is not.
void check_model(const Node& entry, const std::string& owner) {
  const Node* model = entry.find("model");
  if (!model) return;
  if (!model->is(Node::Kind::string))
    throw CaseError(model->place, owner + ": model: expected a name, found " + model->kind_name());
  if (model->text != HertzContact::name)
    throw CaseError(model->place, owner + ": " + unknown_name_message("law of contact", model->text, ContactLaws::names()));
}

/// Two laws for one pair of bodies contradict each other.
void check_no_pair_twice(const CaseReader& reader, const ContactCase& contact, const std::string& owner) {
  const auto has = [](const ContactCase& c, const std::string& name) {
    return c.bodies.empty() || std::find(c.bodies.begin(), c.bodies.end(), name) != c.bodies.end();
  };
  for (const ContactCase& earlier : reader.result.contacts)
    for (const BodyCase& a : reader.result.bodies)
      for (const BodyCase& b : reader.result.bodies)
        if (has(contact, a.name) && has(contact, b.name) && has(earlier, a.name) && has(earlier, b.name) &&
            (a.name != b.name || (contact.self && earlier.self)))
          throw CaseError(contact.place,
                          owner + ": the contact of \"" + a.name + "\" and \"" + b.name + "\" is already described above");
}

void read_pairs(CaseReader& reader) {
  Node resolved = Node::make_array();
  for (const Node& entry : section_entries(reader, "contact")) {
    ContactCase contact;
    const std::string owner = "contact " + std::to_string(resolved.items.size() + 1);
    check_model(entry, owner);
    Node filled = read_described(contact, entry, owner, reader.reading, {"model"});
    contact.place = entry.place;
    check_bodies(reader, contact.bodies, entry, owner);
    if (!contact.self && (contact.bodies.size() == 1 || reader.result.bodies.size() == 1))
      throw CaseError(entry.place, owner + ": one body touches nobody; name more, or let it touch itself with self = true");
    check_no_pair_twice(reader, contact, owner);
    if (contact.bodies.empty()) erase_member(filled, "bodies");  // not given: all
    resolved.items.push_back(std::move(filled));
    reader.result.contacts.push_back(std::move(contact));
  }
  add_resolved(reader, "contact", std::move(resolved));
}

}  // namespace

void read_contacts(CaseReader& reader) {
  read_pairs(reader);
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
    if (wall.bodies.empty()) erase_member(resolved.items.back(), "bodies");  // not given: all
    names.push_back(wall.name);
    reader.result.walls.push_back(std::move(wall));
  }
  add_resolved(reader, "wall", std::move(resolved));
}

}  // namespace sinew
