#pragma once

#include <sinew/model/case.hpp>

namespace sinew {

/// The keys of [[boundary]] as they are written; a BoundaryCase keeps the one quantity that is prescribed.
struct BoundaryKeys {
  using FreeVector = std::array<std::optional<Expression>, 3>;
  std::string region;
  std::optional<FreeVector> displacement, velocity;
  std::optional<std::array<Expression, 3>> force, traction;
  std::optional<Expression> pressure;
  std::optional<std::string> wall;
  std::optional<Point> normal;
  std::optional<double> area;
  bool follower = false;
  Place place;

  static void describe(auto&& field, auto& m) {
    field("region", m.region, no_unit, "Where it holds.", TypeText{region_type});
    field("displacement", m.displacement, "m", "Prescribed displacement; \"free\" leaves a component alone.", optional);
    field("velocity", m.velocity, "m/s", "Prescribed velocity; \"free\" leaves a component alone.", optional);
    field("force", m.force, "N", "Total force, shared by the particles of the region.", optional);
    field("traction", m.traction, "Pa", "Force per reference area.", optional);
    field("pressure", m.pressure, "Pa",
          "Pressure, positive when it pushes; on the surface before deformation (a dead load) unless follower says otherwise.",
          optional);
    field("wall", m.wall, no_unit,
          "The particles are a wall, which stands still unless a later entry moves it: no_slip, rough; free_slip, smooth. On the "
          "current "
          "configuration.",
          optional, OneOf{{"no_slip", "free_slip"}});
    field("normal", m.normal, no_unit,
          "For pressure: outward normal before deformation; by default from the particles. For free_slip: normal of the wall.",
          optional);
    field("area", m.area, "m^2", "For traction and pressure: total area of the surface; by default one face a particle.",
          positive, optional);
    field("follower", m.follower, no_unit,
          "For pressure: whether it acts on the surface as it is deformed, -p J F^-T N per area before deformation.", optional);
  }
};

}  // namespace sinew
