#include <sinew/particles/aligned_array.hpp>
#include <sinew/particles/order.hpp>

#include <algorithm>
#include <array>

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

std::vector<int> computing_order(std::span<const Point> points, double spacing, int dimension) {
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

}  // namespace sinew
