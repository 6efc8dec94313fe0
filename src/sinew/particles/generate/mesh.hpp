#pragma once
/// A finite-element mesh as the particles need it, and the two readers that make one.

#include <array>
#include <map>
#include <sinew/core/vec.hpp>
#include <sinew/particles/generate/text_file.hpp>
#include <string>
#include <unordered_map>
#include <vector>

namespace sinew {

enum class ElementKind { triangle, quadrilateral, tetrahedron, hexahedron };

struct ElementType {
  int dimension;
  int corners;
  ElementKind kind;
};

/// The supported element with that many corners in that dimension: 3 or 4 in 2D, 4 or 8 in 3D.
ElementType first_order(int dimension, int corners);

struct MeshElement {
  ElementType type;
  std::array<int, 8> corner{};  ///< indices into Mesh::nodes
  long long number = 0;         ///< as the file calls it
  int line = 0;                 ///< where the file defines it
};

struct Mesh {
  std::vector<Point> nodes;
  std::vector<MeshElement> elements;             ///< those of the dimension of the case
  std::map<std::string, std::vector<int>> sets;  ///< indices into `elements`
  std::vector<std::string> warnings;
};

/// Collects nodes and elements by the numbers of the file and checks them.
class MeshBuilder {
 public:
  explicit MeshBuilder(const TextFile& source) : file(&source) {}

  /// CaseError at the current line if the number is used already.
  void add_node(long long number, const Point& place);
  /// The index of the new element, from `numbers`: its own, then those of its corners. CaseError if one is used already or
  /// unknown.
  int add_element(const ElementType& type, const std::vector<long long>& numbers);
  /// The index of the element of that number; -1 if there is none.
  int element_index(long long number) const;
  void add_to_set(const std::string& name, int element) { mesh.sets[name].push_back(element); }
  /// The mesh, with the members of each set in order and there once.
  Mesh finish();

  Mesh mesh;

 private:
  const TextFile* file;
  std::unordered_map<long long, int> node_of, element_of;
};

/// The elements of the given dimension. Both: CaseError with line and column for whatever is wrong or not supported.
Mesh read_gmsh(TextFile& file, int dimension);
Mesh read_abaqus(TextFile& file, int dimension);

/// Area or volume of an element and its center of mass.
struct ElementMeasure {
  double volume = 0.0;  ///< signed: negative if the corners run clockwise, or the element is inside out
  Point center;
};

/// Triangle and tetrahedron: exact. Quadrilateral: two triangles. Hexahedron: 24 tetrahedra that join its edges to the mean of
/// the corners of each face and to the mean of all corners, so that neighbors agree on their common face.
ElementMeasure measure(const Mesh& mesh, const MeshElement& element);

}  // namespace sinew
