#pragma once

#include <sinew/particles/generate/lattice.hpp>
#include <string_view>

namespace sinew {

/// A plane region inside a closed polygon that does not cross itself: the lattice points inside, with equal areas that sum to the
/// exact one. Two dimensions only.
struct Polygon {
  static constexpr std::string_view name = "polygon";
  static constexpr std::string_view summary = "Region inside a closed polygon (2D)";
  std::vector<double> points;
  LatticeParams arrangement;

  static void describe(auto&& field, auto& m) {
    field("points", m.points, "m", "Vertices in order, as x0, y0, x1, y1, ...; the last is joined to the first.", any_number);
    LatticeParams::describe(field, m.arrangement);
  }
  PointSet generate(const GenerateOptions& options) const;
};

}  // namespace sinew
