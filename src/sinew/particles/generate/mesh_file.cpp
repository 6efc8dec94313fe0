#include <sinew/particles/generate/mesh_file.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sinew/particles/generate/mesh.hpp>
#include <sinew/particles/generate/rounded_text.hpp>

namespace sinew {

namespace {

constexpr double flat_tolerance = 1e-9;         // of the size of the mesh: how far a plane mesh may leave its plane
constexpr double degenerate_tolerance = 1e-12;  // of size^dimension: below it an element has no volume

double size_of(const Mesh& mesh, const MeshElement& element) {
  double size = 0.0;
  for (int c = 1; c < element.type.corners; ++c)
    size = std::max(size, norm(mesh.nodes[element.corner[c]] - mesh.nodes[element.corner[0]]));
  return size;
}

/// Whether two sides of a quadrilateral cross: two of its corners turn left and two right.
bool crosses_itself(const Mesh& mesh, const MeshElement& element) {
  if (element.type.kind != ElementKind::quadrilateral) return false;
  int left = 0, right = 0;
  for (int c = 0; c < 4; ++c) {
    const Point &a = mesh.nodes[element.corner[c]], &b = mesh.nodes[element.corner[(c + 1) % 4]],
                &d = mesh.nodes[element.corner[(c + 3) % 4]];
    const double turn = cross(b - a, d - a)[2];
    left += turn > 0.0;
    right += turn < 0.0;
  }
  return left == 2 && right == 2;
}

/// The measure of an element with a positive volume. CaseError if it has none.
ElementMeasure checked_measure(const Mesh& mesh, const MeshElement& element, const std::string& path) {
  ElementMeasure result = measure(mesh, element);
  result.volume = std::abs(result.volume);
  const std::string name = "element " + std::to_string(element.number) + " is degenerate: ";
  const Place place{path, element.line, 1};
  if (crosses_itself(mesh, element)) throw CaseError(place, name + "two of its sides cross.");
  if (!(result.volume > degenerate_tolerance * std::pow(size_of(mesh, element), element.type.dimension)))
    throw CaseError(place, name + (element.type.dimension == 2 ? "it has no area." : "it has no volume."));
  return result;
}

/// CaseError unless all elements are in one plane z = constant.
void check_flat(const Mesh& mesh, const std::string& path) {
  const double level = mesh.nodes[mesh.elements[0].corner[0]][2];
  for (const MeshElement& element : mesh.elements)
    for (int c = 0; c < element.type.corners; ++c) {
      const double z = mesh.nodes[element.corner[c]][2];
      if (std::abs(z - level) > flat_tolerance * (1.0 + std::abs(level)) * size_of(mesh, element))
        throw CaseError(Place{path, element.line, 1}, "element " + std::to_string(element.number) +
                                                          " is not in the x-y plane of a 2D case: its corners have z = " +
                                                          rounded_text(level) + " and z = " + rounded_text(z) + ".");
    }
}

Mesh read(TextFile& file, const GenerateOptions& options) {
  const std::string extension = lower_case(std::filesystem::path(file.path()).extension().string());
  if (extension == ".msh") return read_gmsh(file, options.dimension);
  if (extension == ".inp") return read_abaqus(file, options.dimension);
  options.fail("the mesh file \"" + file.path() + "\" must end in .msh (Gmsh) or .inp (Abaqus).");
}

}  // namespace

PointSet MeshFile::generate(const GenerateOptions& options) const {
  if (!(scale > 0.0) || !std::isfinite(scale))
    options.fail("\"scale\" is " + rounded_text(scale) + "; it must be greater than 0.");
  TextFile source(file, options);
  Mesh mesh = read(source, options);
  if (mesh.elements.empty())
    throw CaseError(Place{source.path()}, options.dimension == 2
                                              ? "the mesh has no triangles or quadrilaterals, which a 2D case needs."
                                              : "the mesh has no tetrahedra or hexahedra, which a 3D case needs.");
  if (options.dimension == 2) check_flat(mesh, source.path());

  PointSet points;
  const double volume_scale = std::pow(scale, options.dimension);
  for (const MeshElement& element : mesh.elements) {
    const ElementMeasure result = checked_measure(mesh, element, source.path());
    points.position.push_back(scale * result.center);
    points.volume.push_back(volume_scale * result.volume);
    if (options.dimension == 2) points.position.back()[2] = 0.0;
  }
  points.sets = std::move(mesh.sets);
  points.warnings = std::move(mesh.warnings);
  return points;
}

}  // namespace sinew
