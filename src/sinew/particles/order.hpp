#pragma once
/// The computing order of the points of one body: slabs of one spacing along the longest axis, in them rows along the second
/// longest. Neighbors of consecutive particles are then consecutive, and an index range is a slab: the reach of a pair in the
/// order is short, which the chunks of the force pass live on.

#include <cstdint>
#include <sinew/core/pack.hpp>
#include <sinew/core/vec.hpp>
#include <span>
#include <vector>

namespace sinew {

/// Cuts space into slabs of one spacing, these into layers of one spacing: what remains is a row along the third axis.
struct SlabGrid {
  Point low{};           ///< lowest coordinates of all points [length]
  double spacing = 1.0;  ///< [length]
  int slowest = 0;       ///< axis across the slabs, along which the points reach farthest
  int fastest = 1;       ///< axis along a row, the second longest
  int middle = 2;        ///< axis across the layers of a slab
  std::uint64_t layers = 1;

  /// `dimension` 2: one layer, whatever the third coordinate.
  SlabGrid(std::span<const Point> points, double spacing, int dimension);

  /// Distance from the lowest point along an axis, in spacings. Limited, so that it always has a bin.
  template <class T>
  T spacings(const Vec3<T>& p, int axis) const {
    return min(T(farthest), max(T(-farthest), (p[axis] - low[axis]) / spacing));
  }
  /// The bin whose middle is nearest: the rows of a lattice, rounded or a little disturbed, stay in the middle of their bins.
  std::uint64_t bin(const Point& p, int axis) const {
    const double distance = max(0.0, spacings(p, axis));
    const auto below = static_cast<std::int64_t>(distance);
    return static_cast<std::uint64_t>(below + (distance - static_cast<double>(below) >= 0.5 ? 1 : 0));
  }
  /// Number of the row of a point: layers of the first slab, then those of the second ...
  std::uint64_t row(const Point& p) const { return bin(p, slowest) * layers + (layers > 1 ? bin(p, middle) : 0); }

  static constexpr double farthest = 2e9;  ///< [spacings] so that a bin is an int, and a row number has room for two
};

/// Returns the numbers of the points in computing order: by slab, layer, coordinate along the row, and number. Equal for equal
/// input, whatever the machine or thread count.
std::vector<int> computing_order(std::span<const Point> points, double spacing, int dimension);

}  // namespace sinew
