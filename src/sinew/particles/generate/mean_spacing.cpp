#include <sinew/particles/generate/mean_spacing.hpp>

#include <cmath>

namespace sinew {

double mean_spacing(const PointSet& points, int dimension) {
  if (points.spacing > 0.0) return points.spacing;
  if (points.size() == 0) return 0.0;
  double sum = 0.0;
  for (const double volume : points.volume) sum += std::pow(volume, 1.0 / dimension);
  return sum / static_cast<double>(points.size());
}

}  // namespace sinew
