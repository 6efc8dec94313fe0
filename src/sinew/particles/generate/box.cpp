#include <sinew/particles/generate/box.hpp>

#include <algorithm>
#include <cmath>
#include <sinew/particles/generate/fill.hpp>
#include <sinew/particles/generate/rounded_text.hpp>

namespace sinew {

namespace {

constexpr double division_tolerance = 1e-6;
constexpr const char* axis_name[] = {"x", "y", "z"};

/// Makes the cells fill the box; one warning per side that the spacing does not divide.
std::vector<std::string> fit_cells(Layers& layers, const Bounds& block, double spacing, int dimension) {
  std::vector<std::string> warnings;
  for (int d = 0; d < dimension; ++d) {
    const double side = block.high[d] - block.low[d];
    const int count = layers.count[d];
    layers.low[d] = block.low[d];
    layers.thickness[d] = side / count;
    if (std::abs(layers.thickness[d] - spacing) > division_tolerance * spacing)
      warnings.push_back("The spacing " + rounded_text(spacing) + " does not divide the side of the box along " + axis_name[d] +
                         " (" + rounded_text(side) + "): " + std::to_string(count) + (count == 1 ? " cell of " : " cells of ") +
                         rounded_text(layers.thickness[d]) + (count == 1 ? " is" : " are") + " used there.");
  }
  return warnings;
}

/// From the centers of cells to their corners.
void move_to_corners(Layers& layers, int dimension) {
  for (int d = 0; d < dimension; ++d) {
    layers.low[d] -= 0.5 * layers.thickness[d];
    ++layers.count[d];
  }
}

bool on_face(double coordinate, double low, double high, double spacing) {
  return std::min(coordinate - low, high - coordinate) < 0.25 * spacing;
}

/// What lies on faces keeps the part of its volume that is inside, and stays on them when `jitter` moves it.
template <class Jitter>
void cut_at_faces(const Bounds& block, double spacing, int dimension, PointSet& points, Jitter&& jitter) {
  const std::vector<Point> before = points.position;
  jitter();
  for (std::size_t n = 0; n < points.size(); ++n)
    for (int d = 0; d < dimension; ++d)
      if (on_face(before[n][d], block.low[d], block.high[d], spacing)) {
        points.volume[n] *= 0.5;
        points.position[n][d] = before[n][d];
      }
}

}  // namespace

PointSet Box::generate(const GenerateOptions& options) const {
  const Lattice lattice = arrangement.resolve(options);
  const Bounds block{options.point(low, "low"), options.point(high, "high")};
  double exact = 1.0;
  for (int d = 0; d < options.dimension; ++d) {
    if (!(block.low[d] < block.high[d]))
      options.fail("\"low\" of the box must be below \"high\" along " + std::string(axis_name[d]) + ": " +
                   rounded_text(block.low[d]) + " is not below " + rounded_text(block.high[d]) + ".");
    exact *= block.high[d] - block.low[d];
  }
  Layers layers = Layers::inside(block, lattice, arrangement.spacing, options);
  std::vector<std::string> warnings;
  if (layers.alternate && on_faces)
    options.fail("\"on_faces\" is for square and cubic lattices, not for \"" + arrangement.lattice.value + "\".");
  if (!layers.alternate) warnings = fit_cells(layers, block, arrangement.spacing, options.dimension);
  if (on_faces) move_to_corners(layers, options.dimension);
  PointSet points = fill(layers, arrangement.spacing, options.dimension, [](const Point&) { return true; });
  points.warnings = std::move(warnings);
  if (layers.alternate) scale_to_volume(points, exact, std::string(name), options);
  const auto jitter = [&] { apply_jitter(arrangement, options.dimension, points); };
  if (on_faces)
    cut_at_faces(block, arrangement.spacing, options.dimension, points, jitter);
  else
    jitter();
  return points;
}

}  // namespace sinew
