#pragma once
/// The sections of a case that say who touches whom.

#include <array>
#include <optional>
#include <sinew/contact_laws/registry.hpp>
#include <sinew/model/expression.hpp>
#include <sinew/model/field_options.hpp>
#include <string>
#include <vector>

namespace sinew {

/// [[contact]]
struct ContactCase {
  std::vector<std::string> bodies;  ///< empty: all
  bool self = false;
  HertzContact law;
  Place place;

  static void describe(auto&& field, auto& m) {
    field("bodies", m.bodies, no_unit, "The bodies that touch each other; by default all.", optional, TypeText{"array of names"});
    field(
        "self", m.self, no_unit,
        "Whether each of them also touches itself: particles of it that were farther apart than the kernel radius at the start.",
        optional);
    HertzContact::describe(field, m.law);
  }
};

/// [[wall]]
struct WallCase {
  std::string name;
  AnyWallShape geometry;
  HertzContact law;
  std::optional<std::array<Expression, 3>> velocity, displacement;  ///< of time
  std::vector<std::string> bodies;                                  ///< empty: all
  Place place;

  static void describe(auto&& field, auto& m) {
    field("name", m.name, no_unit, "Name of the wall, by which probes and messages call it.");
    field("geometry", m.geometry, no_unit, "Its surface.", TypeText{"table with \"shape\""});
    field("velocity", m.velocity, "m/s", "Velocity of the wall, a function of t; it does not turn.", optional);
    field("displacement", m.displacement, "m", "Instead of a velocity: where it has moved by time t.", optional);
    field("bodies", m.bodies, no_unit, "The bodies that it acts on; by default all.", optional, TypeText{"array of names"});
    HertzContact::describe(field, m.law);
  }
};

}  // namespace sinew
