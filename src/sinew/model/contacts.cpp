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
    condition.stiffness.push_back(!acts ? 0.0 : std::isnan(given) ? youngs_modulus(body.material) : given);
  }
  return condition;
}

}  // namespace

template <int D>
Contacts<D> make_contacts(const Case& c, const Particles<D>& particles) {
  std::vector<WallCondition> walls;
  for (const WallCase& wall : c.walls) walls.push_back(wall_condition(c, wall));
  const double thickness = D == 2 ? c.general.thickness : 1.0;
  return {Walls<D>(std::move(walls), particles, thickness), particles};
}

template <int D>
void check_initial_contacts(const Case& c, const Contacts<D>& contacts, const Particles<D>& particles, const Comm& comm) {
  constexpr double allowed = 0.2;  // of a particle's radius
  for (int w = 0; w < contacts.walls().count(); ++w) {
    const auto overlap = contacts.walls().overlap(w, particles);
    const double most = comm.maximum(overlap.most);
    const long behind = comm.sum(overlap.behind);
    if (most <= allowed) continue;
    throw CaseError(
        c.walls[w].place,
        fmt::format("wall \"{}\" is inside a body at the start: {} particles have their centers behind its surface, and "
                    "the deepest reaches in by {:.3g} of its radius (half a spacing). Move the wall away, turn its normal, "
                    "or name with \"bodies\" those that it acts on.",
                    c.walls[w].name, behind, most));
  }
}

template Contacts<2> make_contacts<2>(const Case&, const Particles<2>&);
template Contacts<3> make_contacts<3>(const Case&, const Particles<3>&);
template void check_initial_contacts<2>(const Case&, const Contacts<2>&, const Particles<2>&, const Comm&);
template void check_initial_contacts<3>(const Case&, const Contacts<3>&, const Particles<3>&, const Comm&);

}  // namespace sinew
