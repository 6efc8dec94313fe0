#include <sinew/particles/generate/fill.hpp>

#include <algorithm>
#include <cmath>
#include <sinew/particles/generate/rounded_text.hpp>

namespace sinew {

namespace {

constexpr double max_scale_change = 0.05;

Layers layers_of(const Bounds& block, Lattice lattice, double spacing, const GenerateOptions& options) {
  Layers layers;
  layers.thickness = {{spacing, spacing, options.dimension == 3 ? spacing : 0.0}};
  layers.alternate = lattice == Lattice::triangular || lattice == Lattice::fcc;
  if (lattice == Lattice::triangular) layers.thickness = {{0.5 * spacing, std::sqrt(0.75) * spacing, 0.0}};
  if (lattice == Lattice::fcc) layers.thickness = std::sqrt(0.5) * layers.thickness;
  double sites = 1.0;
  for (int d = 0; d < options.dimension; ++d) sites *= (block.high[d] - block.low[d]) / layers.thickness[d] + 1.0;
  const double points = layers.alternate ? 0.5 * sites : sites;
  if (!(points < options.most_points))
    options.fail("a spacing of " + rounded_text(spacing) + " gives about " + rounded_text(points) +
                 " particles, and the memory of this machine is enough for about " + rounded_text(options.most_points) +
                 ". Make spacing larger.");
  return layers;
}

void center_in(Layers& layers, const Bounds& block, int dimension) {
  for (int d = 0; d < dimension; ++d)
    layers.low[d] = 0.5 * (block.low[d] + block.high[d]) - 0.5 * layers.count[d] * layers.thickness[d];
}

}  // namespace

Layers Layers::inside(const Bounds& block, Lattice lattice, double spacing, const GenerateOptions& options) {
  Layers layers = layers_of(block, lattice, spacing, options);
  for (int d = 0; d < options.dimension; ++d)
    layers.count[d] = std::max(1, static_cast<int>(std::lround((block.high[d] - block.low[d]) / layers.thickness[d])));
  center_in(layers, block, options.dimension);
  return layers;
}

Layers Layers::about_center(const Bounds& block, Lattice lattice, double spacing, const GenerateOptions& options) {
  Layers layers = inside(block, lattice, spacing, options);
  if (!layers.alternate) return layers;
  for (int d = 0; d < options.dimension; ++d) {
    const int half = static_cast<int>(0.5 * (block.high[d] - block.low[d]) / layers.thickness[d]);
    layers.count[d] = 2 * half + 1;
    layers.parity += half;
  }
  center_in(layers, block, options.dimension);
  return layers;
}

std::size_t Layers::site_count() const { return static_cast<std::size_t>(count[0]) * count[1] * count[2]; }

Point Layers::site(int i, int j, int k) const {
  return {{low[0] + (i + 0.5) * thickness[0], low[1] + (j + 0.5) * thickness[1], low[2] + (k + 0.5) * thickness[2]}};
}

double Layers::cell_volume(int dimension) const {
  double volume = alternate ? 2.0 : 1.0;
  for (int d = 0; d < dimension; ++d) volume *= thickness[d];
  return volume;
}

void scale_to_volume(PointSet& points, double exact, const std::string& shape, const GenerateOptions& options) {
  if (points.size() == 0)
    options.fail("no particle of the \"" + shape + "\" is inside it: the spacing is too large for its size.");
  double sum = 0.0;
  for (const double v : points.volume) sum += v;
  const double scale = exact / sum;
  for (double& v : points.volume) v *= scale;
  if (std::abs(scale - 1.0) > max_scale_change)
    points.warnings.push_back("The " + std::to_string(points.size()) + " lattice cells of the \"" + shape + "\" have " +
                              rounded_text(100.0 / scale) + " % of its exact volume; their volumes were multiplied by " +
                              rounded_text(scale) + ". A smaller spacing follows the shape better.");
}

}  // namespace sinew
