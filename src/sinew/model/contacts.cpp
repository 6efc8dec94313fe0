#include <sinew/model/contacts.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace sinew {

namespace {

double youngs_modulus(const AnyMaterial& any) {
  return std::visit([](const auto& material) { return material.elastic.youngs_modulus; }, any);
}

bool among(const std::vector<std::string>& names, const std::string& name) {
  return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
}

FieldFunction function_of_time(const Expression& expression) {
  return {[expression](const Point&, const Point&, double t) { return expression(t); }, false, expression.text()};
}

WallCondition wall_condition(const Case& c, const WallCase& wall) {
  using Motion = WallCondition::Motion;
  WallCondition condition{wall.name, wall.geometry, wall.law, Motion::none, {}, {}};
  const auto& motion = wall.displacement ? wall.displacement : wall.velocity;
  if (motion) condition.motion = wall.displacement ? Motion::displacement : Motion::velocity;
  for (int i = 0; i < 3 && motion; ++i) condition.function[i] = function_of_time((*motion)[i]);
  for (const BodyCase& body : c.bodies) {
    const bool acts = among(wall.bodies, body.name);
    const double given = wall.law.stiffness;
    if (acts && std::isnan(given) && youngs_modulus(body.material) == 0.0)
      throw CaseError(wall.place, "wall \"" + wall.name + "\": give \"stiffness\", since body \"" + body.name +
                                      "\" is rigid and has none of its own; or name with \"bodies\" those that it acts on");
    condition.stiffness.push_back(!acts ? 0.0 : std::isnan(given) ? youngs_modulus(body.material) : given);
  }
  return condition;
}

/// The smaller of two moduli; that of a rigid body, 0, does not count.
double smaller_modulus(const BodyCase& a, const BodyCase& b) {
  const double of_a = youngs_modulus(a.material), of_b = youngs_modulus(b.material);
  return of_a > 0.0 && of_b > 0.0 ? std::min(of_a, of_b) : std::max(of_a, of_b);
}

/// Each pair of bodies has a law of its own, since its stiffness may follow from theirs.
ContactTable contact_table(const Case& c) {
  ContactTable table;
  table.bodies = static_cast<int>(c.bodies.size());
  table.law_of.assign(c.bodies.size() * c.bodies.size(), -1);
  for (const BodyCase& body : c.bodies) table.driven.push_back(youngs_modulus(body.material) == 0.0);
  for (const ContactCase& contact : c.contacts)
    for (std::size_t a = 0; a < c.bodies.size(); ++a)
      for (std::size_t b = a; b < c.bodies.size(); ++b) {
        if (!among(contact.bodies, c.bodies[a].name) || !among(contact.bodies, c.bodies[b].name) || (a == b && !contact.self) ||
            (table.driven[a] && table.driven[b]))
          continue;
        table.law_of[a * c.bodies.size() + b] = table.law_of[b * c.bodies.size() + a] = static_cast<int>(table.laws.size());
        table.laws.push_back(contact.law);
        if (std::isnan(contact.law.stiffness)) table.laws.back().stiffness = smaller_modulus(c.bodies[a], c.bodies[b]);
      }
  if (!c.contacts.empty() && !table.any())
    throw CaseError(c.contacts[0].place, "no two bodies touch by this contact; rigid ones do not touch each other");
  return table;
}

template <int D>
void check_pairs(const Case& c, const Contacts<D>& contacts, double allowed, const Comm& comm) {
  if (!contacts.pairs().any()) return;
  const auto overlap = contacts.pairs().overlap(allowed);
  if (overlap.most <= allowed) return;
  comm.together([&] {
    throw CaseError(
        c.contacts[0].place,
        fmt::format(
            "bodies \"{}\" and \"{}\" overlap at the start: particles of bodies in contact reach into each other by up to "
            "{:.3g} of a spacing ({} pairs by more than {}). Move the bodies apart.",
            c.bodies[overlap.body].name, c.bodies[overlap.other].name, overlap.most, overlap.pairs / 2, allowed));
  });
}

}  // namespace

template <int D>
Contacts<D> make_contacts(const Case& c, const Particles<D>& particles, const std::vector<double>& support_radius,
                          const Comm& comm) {
  std::vector<WallCondition> walls;
  for (const WallCase& wall : c.walls) walls.push_back(wall_condition(c, wall));
  const double thickness = D == 2 ? c.general.thickness : 1.0;
  return {Walls<D>(std::move(walls), particles, thickness),
          PairContacts<D>(contact_table(c), particles, support_radius, thickness, comm), particles};
}

template <int D>
void check_initial_contacts(const Case& c, const Contacts<D>& contacts, const Particles<D>& particles, const Comm& comm) {
  constexpr double allowed = 0.2;  // of the radius of a particle, or the sum of two
  check_pairs(c, contacts, allowed, comm);
  for (int w = 0; w < contacts.walls().count(); ++w) {
    const auto overlap = contacts.walls().overlap(w, particles);
    const double most = comm.maximum(overlap.most);
    const long behind = comm.sum(overlap.behind);
    if (most <= allowed) continue;
    comm.together([&] {
      throw CaseError(
          c.walls[w].place,
          fmt::format("wall \"{}\" is inside a body at the start: {} particles have their centers behind its surface, and "
                      "the deepest reaches in by {:.3g} of its radius (half a spacing). Move the wall away, turn its normal, "
                      "or name with \"bodies\" those that it acts on.",
                      c.walls[w].name, behind, most));
    });
  }
}

template Contacts<2> make_contacts<2>(const Case&, const Particles<2>&, const std::vector<double>&, const Comm&);
template Contacts<3> make_contacts<3>(const Case&, const Particles<3>&, const std::vector<double>&, const Comm&);
template void check_initial_contacts<2>(const Case&, const Contacts<2>&, const Particles<2>&, const Comm&);
template void check_initial_contacts<3>(const Case&, const Contacts<3>&, const Particles<3>&, const Comm&);

}  // namespace sinew
