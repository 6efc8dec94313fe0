#pragma once

#include <sinew/particles/generate/lattice.hpp>
#include <string_view>

namespace sinew {

/// A plane ring: the lattice points between two circles, with equal areas that sum to the exact one. Two dimensions only.
struct Annulus {
  static constexpr std::string_view name = "annulus";
  static constexpr std::string_view summary = "Ring between two circles (2D)";
  std::vector<double> center;
  double inner_radius = 0.0, outer_radius = 0.0;
  LatticeParams arrangement;

  static void describe(auto&& field, auto& m) {
    field("center", m.center, "m", "Center.", any_number);
    field("inner_radius", m.inner_radius, "m", "Radius of the inner circle.", positive);
    field("outer_radius", m.outer_radius, "m", "Radius of the outer circle.", positive);
    LatticeParams::describe(field, m.arrangement);
  }
  PointSet generate(const GenerateOptions& options) const;
};

}  // namespace sinew
