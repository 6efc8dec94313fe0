#include <sinew/particles/generate/polygon.hpp>

#include <algorithm>
#include <cmath>
#include <sinew/particles/generate/fill.hpp>
#include <sinew/particles/generate/rounded_text.hpp>

namespace sinew {

namespace {

using Vertices = std::vector<Point>;

/// Twice the signed area of the triangle a, b, c; positive counterclockwise.
double turn(const Point& a, const Point& b, const Point& c) { return cross(b - a, c - a)[2]; }

bool on_segment(const Point& a, const Point& b, const Point& p) { return turn(a, b, p) == 0.0 && dot(p - a, p - b) <= 0.0; }

/// Whether the segments a-b and c-d have a point in common.
bool touch(const Point& a, const Point& b, const Point& c, const Point& d) {
  const double c_side = turn(a, b, c), d_side = turn(a, b, d), a_side = turn(c, d, a), b_side = turn(c, d, b);
  if (c_side * d_side < 0.0 && a_side * b_side < 0.0) return true;
  return on_segment(a, b, c) || on_segment(a, b, d) || on_segment(c, d, a) || on_segment(c, d, b);
}

std::string edge_text(std::size_t i, std::size_t n) { return std::to_string(i + 1) + "-" + std::to_string((i + 1) % n + 1); }

/// CaseError if two vertices follow each other at one place or two edges meet other than at their common vertex.
void check_simple(const Vertices& v, const GenerateOptions& options) {
  const std::size_t n = v.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Point &a = v[i], &b = v[(i + 1) % n], &after = v[(i + 2) % n];
    if (norm(b - a) == 0.0)
      options.fail("vertices " + std::to_string(i + 1) + " and " + std::to_string((i + 1) % n + 1) +
                   " of the polygon are the same point; it closes by itself.");
    if (turn(a, b, after) == 0.0 && dot(b - a, after - b) < 0.0)
      options.fail("the polygon turns back on itself at vertex " + std::to_string((i + 1) % n + 1) + ".");
  }
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;
      if (touch(v[i], v[i + 1], v[j], v[(j + 1) % n]))
        options.fail("the polygon crosses itself: its edges " + edge_text(i, n) + " and " + edge_text(j, n) + " meet.");
    }
}

/// Shoelace formula: half the sum of x_i y_i+1 - x_i+1 y_i, about the first vertex.
double area(const Vertices& v) {
  double twice = 0.0;
  for (std::size_t i = 1; i + 1 < v.size(); ++i) twice += turn(v[0], v[i], v[i + 1]);
  return 0.5 * std::abs(twice);
}

/// Inside, and farther than `margin` from every edge.
bool contains(const Vertices& v, const Point& p, double margin) {
  bool inside = false;
  for (std::size_t i = 0, j = v.size() - 1; i < v.size(); j = i++) {
    const Point edge = v[i] - v[j], from = p - v[j];
    const double t = std::clamp(dot(from, edge) / dot(edge, edge), 0.0, 1.0);
    if (norm(from - t * edge) <= margin) return false;
    if ((v[i][1] > p[1]) != (v[j][1] > p[1]) && p[0] < v[j][0] + (p[1] - v[j][1]) / edge[1] * edge[0]) inside = !inside;
  }
  return inside;
}

Vertices vertices_of(const std::vector<double>& numbers, const GenerateOptions& options) {
  if (numbers.size() % 2 != 0)
    options.fail("\"points\" has " + std::to_string(numbers.size()) + " numbers; it needs an x and a y for every vertex.");
  if (numbers.size() < 6)
    options.fail("\"points\" has " + std::to_string(numbers.size() / 2) + " vertices; a polygon needs at least 3.");
  Vertices vertices;
  for (std::size_t i = 0; i < numbers.size(); i += 2) vertices.push_back(options.point({numbers[i], numbers[i + 1]}, "points"));
  return vertices;
}

}  // namespace

PointSet Polygon::generate(const GenerateOptions& options) const {
  options.need_dimension(2, std::string(name), "Use \"box\", \"cylinder\", \"sphere\" or \"mesh\".");
  const Lattice lattice = arrangement.resolve(options);
  const Vertices vertices = vertices_of(points, options);
  check_simple(vertices, options);
  Bounds block{vertices[0], vertices[0]};
  for (const Point& v : vertices)
    for (int d = 0; d < 2; ++d) {
      block.low[d] = std::min(block.low[d], v[d]);
      block.high[d] = std::max(block.high[d], v[d]);
    }
  const double margin = surface_tolerance * arrangement.spacing;
  const Layers layers = Layers::inside(block, lattice, arrangement.spacing, options);
  PointSet set = fill(layers, arrangement.spacing, 2, [&](const Point& p) { return contains(vertices, p, margin); });
  scale_to_volume(set, area(vertices), std::string(name), options);
  apply_jitter(arrangement, 2, set);
  return set;
}

}  // namespace sinew
