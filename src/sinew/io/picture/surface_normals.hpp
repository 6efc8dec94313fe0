#pragma once
/// Which way the surface of a set of particles faces.

#include <sinew/core/vec.hpp>
#include <span>
#include <vector>

namespace sinew {

/// For each particle of `which`: the unit vector away from the middle of its neighbors, n ~ -sum_b (x_b - x_a) over
/// |x_b - x_a| < 2.5 `spacing`, times how one-sided they are (near 0 inside a body, 1 at its surface). Positions are finite.
std::vector<Point> surface_normals(std::span<const Point> position, std::span<const int> which, double spacing);

}  // namespace sinew
