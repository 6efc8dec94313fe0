#pragma once

#include <sinew/particles/generate/point_set.hpp>

namespace sinew {

/// The nominal spacing of the points [length]: `points.spacing` where it is known, otherwise the mean of volume^(1/dimension).
/// 0 if there are no points.
double mean_spacing(const PointSet& points, int dimension);

}  // namespace sinew
