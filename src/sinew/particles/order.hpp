#pragma once
/// The computing order of the points of one body: slabs of one spacing along the longest axis, in them rows along the second
/// longest. Neighbors of consecutive particles are then consecutive, and an index range is a slab: the reach of a pair in the
/// order is short, which the chunks of the force pass live on.

#include <sinew/core/vec.hpp>
#include <vector>

namespace sinew {

/// Returns the numbers of the points in computing order. Equal for equal input, whatever the machine or thread count.
std::vector<int> computing_order(const std::vector<Point>& points, double spacing, int dimension);

}  // namespace sinew
