#pragma once

#include <sinew/core/params.hpp>
#include <sinew/particles/generate/options.hpp>
#include <sinew/particles/generate/point_set.hpp>
#include <string_view>

namespace sinew {

/// One particle per element of a finite-element mesh, at the center of mass of the element and with its area or volume.
/// Gmsh (.msh, formats 2.2 and 4.1, ASCII) and Abaqus (.inp). Only the elements of the dimension of the case are used: triangles
/// and quadrilaterals in 2D, tetrahedra and hexahedra in 3D, all of first order. Physical groups and element sets become sets.
struct MeshFile {
  static constexpr std::string_view name = "mesh";
  static constexpr std::string_view summary = "One particle per element of a mesh file (Gmsh .msh, Abaqus .inp)";
  std::string file;
  double scale = 1.0;

  static void describe(auto&& field, auto& m) {
    field("file", m.file, "1", "Mesh file, relative to the case file: Gmsh .msh (ASCII) or Abaqus .inp.", any_number);
    field("scale", m.scale, "1", "Factor on all coordinates, 0.001 for a mesh in millimeters.", positive, optional);
  }
  PointSet generate(const GenerateOptions& options) const;
};

}  // namespace sinew
