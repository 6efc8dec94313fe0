#pragma once

#include <sinew/particles/generate/lattice.hpp>
#include <string_view>

namespace sinew {

/// A circular cylinder or tube between the centers of its two ends: the points of a lattice along the coordinate axes that are
/// inside, with equal volumes that sum to the exact one. Three dimensions only.
struct Cylinder {
  static constexpr std::string_view name = "cylinder";
  static constexpr std::string_view summary = "Circular cylinder or tube (3D)";
  std::vector<double> from, to;
  double radius = 0.0, inner_radius = 0.0;
  LatticeParams arrangement;

  static void describe(auto&& field, auto& m) {
    field("from", m.from, "m", "Center of one end.", any_number);
    field("to", m.to, "m", "Center of the other end.", any_number);
    field("radius", m.radius, "m", "Outer radius.", positive);
    field("inner_radius", m.inner_radius, "m", "Radius of the bore; 0 is none.", non_negative, optional);
    LatticeParams::describe(field, m.arrangement);
  }
  PointSet generate(const GenerateOptions& options) const;
};

}  // namespace sinew
