#pragma once
/// The computing order of the points of one body: compact blocks, in them slabs of one spacing along the longest axis of the body, in these rows
/// along the second longest. Neighbors of consecutive particles are then consecutive, and a block has few neighbors outside.

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

/// Returns the numbers of the points by slab, layer, coordinate along the row, and number. Equal for equal input, whatever the machine or
/// thread count.
std::vector<int> row_order(std::span<const Point> points, double spacing, int dimension);

/// Points in computing order.
struct BlockOrder {
  std::vector<int> number;     ///< numbers of the points, block after block, in each by rows
  std::vector<int> block_end;  ///< how many points the blocks up to this one have
};

/// Halves the points across the longest axis, between two of their slabs, layers or places in rows, until no block has more than `most`. Rows
/// count a quarter of their length, so that they stay long.
BlockOrder block_order(std::span<const Point> points, double spacing, int dimension, int most);

}  // namespace sinew
