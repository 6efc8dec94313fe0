#pragma once

#include <sinew/particles/generate/lattice.hpp>
#include <string_view>

namespace sinew {

/// A ball, or a disk in two dimensions, optionally hollow: the lattice points inside, with equal volumes that sum to the exact
/// one.
struct Sphere {
  static constexpr std::string_view name = "sphere";
  static constexpr std::string_view summary = "Ball (a disk in 2D), optionally hollow";
  std::vector<double> center;
  double radius = 0.0, inner_radius = 0.0;
  LatticeParams arrangement;

  static void describe(auto&& field, auto& m) {
    field("center", m.center, "m", "Center.", any_number);
    field("radius", m.radius, "m", "Outer radius.", positive);
    field("inner_radius", m.inner_radius, "m", "Radius of the hollow inside; 0 is none.", non_negative, optional);
    LatticeParams::describe(field, m.arrangement);
  }
  PointSet generate(const GenerateOptions& options) const;
};

}  // namespace sinew
