#pragma once

#include <sinew/particles/generate/lattice.hpp>
#include <string_view>

namespace sinew {

/// A rectangle or a box with sides along the axes.
/// Square and cubic lattices: round(side / spacing) equal cells along each side fill it exactly, one particle at each center.
/// Triangular and fcc lattices: the lattice points inside, with equal volumes that sum to that of the box.
struct Box {
  static constexpr std::string_view name = "box";
  static constexpr std::string_view summary = "Rectangle or box with sides along the axes";
  std::vector<double> low, high;
  LatticeParams arrangement;

  static void describe(auto&& field, auto& m) {
    field("low", m.low, "m", "Corner with the smallest coordinates.", any_number);
    field("high", m.high, "m", "Corner with the largest coordinates.", any_number);
    LatticeParams::describe(field, m.arrangement);
  }
  PointSet generate(const GenerateOptions& options) const;
};

}  // namespace sinew
