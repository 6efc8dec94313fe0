#include <sinew/particles/generate/cylinder.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sinew/particles/generate/fill.hpp>
#include <sinew/particles/generate/rounded_text.hpp>

namespace sinew {

PointSet Cylinder::generate(const GenerateOptions& options) const {
  options.need_dimension(3, std::string(name),
                         "Use \"sphere\" for a disk, \"annulus\" for a ring or \"box\" for a cut along the axis.");
  const Lattice lattice = arrangement.resolve(options);
  const Point start = options.point(from, "from"), end = options.point(to, "to");
  const double length = norm(end - start);
  if (!(length > 0.0)) options.fail("\"from\" and \"to\" of the cylinder are the same point; they are the centers of its ends.");
  if (!(inner_radius < radius))
    options.fail("\"inner_radius\" is " + rounded_text(inner_radius) + "; it must be below \"radius\", " + rounded_text(radius) +
                 ".");
  const Point axis = (1.0 / length) * (end - start);

  Bounds block;
  for (int d = 0; d < 3; ++d) {
    const double reach = radius * std::sqrt(std::max(0.0, 1.0 - axis[d] * axis[d]));
    block.low[d] = std::min(start[d], end[d]) - reach;
    block.high[d] = std::max(start[d], end[d]) + reach;
  }
  const double margin = surface_tolerance * arrangement.spacing;
  const auto contains = [&](const Point& p) {
    const double along = dot(p - start, axis);
    const double across = norm(p - start - along * axis);
    return along > margin && along < length - margin && across < radius - margin &&
           (inner_radius == 0.0 || across > inner_radius + margin);
  };
  const Layers layers = Layers::inside(block, lattice, arrangement.spacing, options);
  PointSet points = fill(layers, arrangement.spacing, 3, contains);
  const double exact = std::numbers::pi * (radius * radius - inner_radius * inner_radius) * length;
  scale_to_volume(points, exact, std::string(name), options);
  apply_jitter(arrangement, 3, points);
  return points;
}

}  // namespace sinew
