#include <sinew/particles/generate/ball_shell.hpp>

#include <numbers>
#include <sinew/particles/generate/fill.hpp>

namespace sinew {

double BallShell::volume(int dimension) const {
  const double r = inner_radius, R = outer_radius;
  return std::numbers::pi * (dimension == 3 ? 4.0 / 3.0 * (R * R * R - r * r * r) : R * R - r * r);
}

PointSet ball_shell(const BallShell& shell, const LatticeParams& arrangement, const std::string& shape,
                    const GenerateOptions& options) {
  const Lattice lattice = arrangement.resolve(options);
  Bounds block{shell.center, shell.center};
  for (int d = 0; d < options.dimension; ++d) {
    block.low[d] -= shell.outer_radius;
    block.high[d] += shell.outer_radius;
  }
  const double margin = surface_tolerance * arrangement.spacing;
  const auto contains = [&](const Point& p) {
    const double r = norm(p - shell.center);
    return r < shell.outer_radius - margin && (shell.inner_radius == 0.0 || r > shell.inner_radius + margin);
  };
  const Layers layers = Layers::about_center(block, lattice, arrangement.spacing, options);
  PointSet points = fill(layers, arrangement.spacing, options.dimension, contains);
  scale_to_volume(points, shell.volume(options.dimension), shape, options);
  apply_jitter(arrangement, options.dimension, points);
  return points;
}

}  // namespace sinew
