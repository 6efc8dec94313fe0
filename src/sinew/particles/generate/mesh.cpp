#include <sinew/particles/generate/mesh.hpp>

#include <algorithm>

namespace sinew {

ElementType first_order(int dimension, int corners) {
  if (dimension == 2) return {2, corners, corners == 3 ? ElementKind::triangle : ElementKind::quadrilateral};
  return {3, corners, corners == 4 ? ElementKind::tetrahedron : ElementKind::hexahedron};
}

void MeshBuilder::add_node(long long number, const Point& place) {
  if (!node_of.emplace(number, static_cast<int>(mesh.nodes.size())).second)
    file->fail("node " + std::to_string(number) + " is defined twice.");
  mesh.nodes.push_back(place);
}

int MeshBuilder::add_element(const ElementType& type, const std::vector<long long>& numbers) {
  const int index = static_cast<int>(mesh.elements.size());
  const std::string name = "element " + std::to_string(numbers[0]);
  if (!element_of.emplace(numbers[0], index).second) file->fail(name + " is defined twice.");
  MeshElement element{type, {}, numbers[0], file->line_number()};
  for (int c = 0; c < type.corners; ++c) {
    const auto found = node_of.find(numbers[1 + c]);
    if (found == node_of.end()) file->fail(name + " uses node " + std::to_string(numbers[1 + c]) + ", which is not defined.");
    element.corner[c] = found->second;
  }
  mesh.elements.push_back(element);
  return index;
}

int MeshBuilder::element_index(long long number) const {
  const auto found = element_of.find(number);
  return found == element_of.end() ? -1 : found->second;
}

Mesh MeshBuilder::finish() {
  for (auto& [name, members] : mesh.sets) {
    std::sort(members.begin(), members.end());
    members.erase(std::unique(members.begin(), members.end()), members.end());
  }
  return std::move(mesh);
}

namespace {

/// Sums simplices into a measure: signed volumes and their first moments about an origin near the element.
struct Moments {
  double volume = 0.0;
  Point first;

  void add(double part, const Point& center) {
    volume += part;
    first += part * center;
  }
  void add_triangle(const Point& a, const Point& b, const Point& c) {
    add(0.5 * cross(b - a, c - a)[2], (1.0 / 3.0) * (a + b + c));
  }
  void add_tetrahedron(const Point& a, const Point& b, const Point& c, const Point& d) {
    add(dot(cross(b - a, c - a), d - a) / 6.0, 0.25 * (a + b + c + d));
  }
};

void add_hexahedron(Moments& moments, const std::array<Point, 8>& x) {
  constexpr int faces[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  Point middle;
  for (const Point& corner : x) middle += 0.125 * corner;
  for (const auto& face : faces) {
    const Point face_middle = 0.25 * (x[face[0]] + x[face[1]] + x[face[2]] + x[face[3]]);
    for (int e = 0; e < 4; ++e) moments.add_tetrahedron(middle, x[face[e]], x[face[(e + 1) % 4]], face_middle);
  }
}

}  // namespace

ElementMeasure measure(const Mesh& mesh, const MeshElement& element) {
  const Point origin = mesh.nodes[element.corner[0]];
  std::array<Point, 8> x;
  for (int c = 0; c < element.type.corners; ++c) x[c] = mesh.nodes[element.corner[c]] - origin;
  Moments moments;
  switch (element.type.kind) {
    case ElementKind::triangle: moments.add_triangle(x[0], x[1], x[2]); break;
    case ElementKind::quadrilateral:
      moments.add_triangle(x[0], x[1], x[2]);
      moments.add_triangle(x[0], x[2], x[3]);
      break;
    case ElementKind::tetrahedron: moments.add_tetrahedron(x[0], x[1], x[2], x[3]); break;
    case ElementKind::hexahedron: add_hexahedron(moments, x); break;
  }
  return {moments.volume, moments.volume == 0.0 ? origin : origin + (1.0 / moments.volume) * moments.first};
}

}  // namespace sinew
