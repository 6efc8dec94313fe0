#pragma once

#include <sinew/particles/generate/lattice.hpp>
#include <string_view>

namespace sinew {

/// A rectangle or a box with sides along the axes.
/// Square and cubic lattices: round(side / spacing) equal cells along each side fill it exactly, one particle at each center.
/// `on_faces`: one at each corner of a cell instead, so that the outermost ones lie on the faces, with the volume that is inside: a half, on edges a quarter, at corners of
/// 3D boxes an eighth.
/// Triangular and fcc lattices: the lattice points inside, with equal volumes that sum to that of the box.
struct Box {
  static constexpr std::string_view name = "box";
  static constexpr std::string_view summary = "Rectangle or box with sides along the axes";
  std::vector<double> low, high;
  LatticeParams arrangement;
  bool on_faces = false;

  static void describe(auto&& field, auto& m) {
    field("low", m.low, "m", "Corner with the smallest coordinates.", any_number);
    field("high", m.high, "m", "Corner with the largest coordinates.", any_number);
    LatticeParams::describe(field, m.arrangement);
    field(
        "on_faces", m.on_faces, "1",
        "Square and cubic lattices: particles at the corners of cells instead of their centers, the outermost ones on the faces "
        "with the part of their volume that is inside.",
        any_number, optional);
  }
  PointSet generate(const GenerateOptions& options) const;
};

}  // namespace sinew
