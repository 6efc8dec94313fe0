#include <sinew/particles/aligned_array.hpp>
#include <sinew/particles/order.hpp>

#include <algorithm>
#include <array>
#include <numeric>

namespace sinew {

namespace {

struct Place {
  std::uint64_t row;
  double along;
  int point;
  bool operator<(const Place& o) const {
    if (row != o.row) return row < o.row;
    if (along != o.along) return along < o.along;
    return point < o.point;
  }
};

/// Counting sort by row, or by ranges of rows where most rows are empty. Bucket b is [first[b], first[b + 1]).
AlignedArray<Place> sorted_into_buckets(std::span<const Point> points, const SlabGrid& grid, std::vector<std::size_t>& first) {
  AlignedArray<std::uint64_t> row(points.size());
  std::uint64_t most = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    row[i] = grid.row(points[i]);
    most = std::max(most, row[i]);
  }
  int shift = 0;
  while (most >> shift > 4 * points.size() + 64) ++shift;
  first.assign((most >> shift) + 2, 0);
  for (const std::uint64_t r : row) ++first[(r >> shift) + 1];
  for (std::size_t b = 1; b < first.size(); ++b) first[b] += first[b - 1];
  std::vector<std::size_t> next(first.begin(), first.end() - 1);
  AlignedArray<Place> places(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    places[next[row[i] >> shift]++] = {row[i], points[i][grid.fastest], static_cast<int>(i)};
  return places;
}

/// Cuts a sequence of points, keeping the order on both sides of a cut.
class Bisection {
 public:
  Bisection(std::span<const Point> points, const SlabGrid& grid, int most) : points_(points), grid_(grid), most_(most) {}

  /// `members`: places in the sequence `order`.
  void cut(std::span<int> members, const std::vector<int>& order, std::vector<int>& block_end) {
    const std::size_t count = members.size(), blocks = (count + most_ - 1) / most_;
    if (blocks <= 1) {
      block_end.push_back(static_cast<int>(count) + (block_end.empty() ? 0 : block_end.back()));
      return;
    }
    const std::size_t left = part(members, order, count * (blocks / 2) / blocks);
    cut(members.first(left), order, block_end);
    cut(members.subspan(left), order, block_end);
  }

 private:
  struct Extent {
    int axis;
    std::uint64_t low, high;  ///< first and last bin
  };
  /// Moves about as many members as wanted to the front, all of those that lie before a plane. Returns how many.
  std::size_t part(std::span<int> members, const std::vector<int>& order, std::size_t wanted) const {
    const Extent e = longest_axis(members, order);
    if (e.high == e.low) return wanted;  // nothing lies between them
    const auto bin = [&](int m) { return grid_.bin(points_[order[m]], e.axis) - e.low; };
    std::vector<std::size_t> below(e.high - e.low + 2, 0);  // members in bins before the k-th
    for (int m : members) ++below[bin(m) + 1];
    for (std::size_t k = 1; k < below.size(); ++k) below[k] += below[k - 1];
    const auto off = [&](std::size_t k) { return below[k] > wanted ? below[k] - wanted : wanted - below[k]; };
    std::size_t best = 1;  // the first and the last bin hold somebody: both sides of every plane in between do
    for (std::size_t k = 2; k + 1 < below.size(); ++k)
      if (off(k) < off(best)) best = k;
    std::stable_partition(members.begin(), members.end(), [&](int m) { return bin(m) < best; });
    return below[best];
  }

  Extent longest_axis(std::span<const int> members, const std::vector<int>& order) const {
    Extent longest{0, 0, 0};
    double most = -1.0;
    for (int axis : {grid_.slowest, grid_.middle, grid_.fastest}) {
      if (axis == grid_.middle && grid_.layers == 1) continue;
      std::uint64_t low = grid_.bin(points_[order[members[0]]], axis), high = low;
      for (int m : members) {
        const std::uint64_t bin = grid_.bin(points_[order[m]], axis);
        low = std::min(low, bin), high = std::max(high, bin);
      }
      const double length = static_cast<double>(high - low) * (axis == grid_.fastest ? 0.25 : 1.0);
      if (length > most) most = length, longest = {axis, low, high};
    }
    return longest;
  }

  std::span<const Point> points_;
  const SlabGrid& grid_;
  std::size_t most_;
};

}  // namespace

SlabGrid::SlabGrid(std::span<const Point> points, double point_spacing, int dimension) : spacing(point_spacing) {
  if (points.empty()) return;
  Point high = low = points.front();
  for (const Point& p : points)
    for (int c = 0; c < 3; ++c) {
      low[c] = min(low[c], p[c]);
      high[c] = max(high[c], p[c]);
    }
  std::array<int, 3> axes{0, 1, 2};
  std::stable_sort(axes.begin(), axes.begin() + dimension,
                   [&](int p, int q) { return high[p] - low[p] > high[q] - low[q] + 1e-9 * spacing; });
  slowest = axes[0], fastest = axes[1], middle = axes[2];
  if (dimension == 3) layers = bin(high, middle) + 1;
}

std::vector<int> row_order(std::span<const Point> points, double spacing, int dimension) {
  std::vector<std::size_t> first;
  AlignedArray<Place> places = sorted_into_buckets(points, SlabGrid(points, spacing, dimension), first);
  for (std::size_t b = 0; b + 1 < first.size(); ++b) {
    Place *begin = places.data() + first[b], *end = places.data() + first[b + 1];
    if (!std::is_sorted(begin, end)) std::sort(begin, end);
  }
  std::vector<int> order(points.size());
  std::transform(places.begin(), places.end(), order.begin(), [](const Place& place) { return place.point; });
  return order;
}

BlockOrder block_order(std::span<const Point> points, double spacing, int dimension, int most) {
  const std::vector<int> rows = row_order(points, spacing, dimension);
  const SlabGrid grid(points, spacing, dimension);
  BlockOrder order;
  std::vector<int> places(points.size());
  std::iota(places.begin(), places.end(), 0);
  if (!points.empty()) Bisection(points, grid, most).cut(places, rows, order.block_end);
  order.number.reserve(points.size());
  for (int place : places) order.number.push_back(rows[place]);
  return order;
}

}  // namespace sinew
