#include <sinew/particles/order.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace sinew {

namespace {

struct Bounds {
  Point low, high;
};

Bounds bounds_of(const std::vector<Point>& points) {
  Bounds b{points.front(), points.front()};
  for (const Point& p : points)
    for (int c = 0; c < 3; ++c) {
      b.low[c] = std::min(b.low[c], p[c]);
      b.high[c] = std::max(b.high[c], p[c]);
    }
  return b;
}

struct Key {
  long slab, layer;
  double along;
  int point;
  bool operator<(const Key& o) const {
    if (slab != o.slab) return slab < o.slab;
    if (layer != o.layer) return layer < o.layer;
    if (along != o.along) return along < o.along;
    return point < o.point;
  }
};

}  // namespace

std::vector<int> computing_order(const std::vector<Point>& points, double spacing, int dimension) {
  std::vector<int> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  if (points.empty()) return order;
  const Bounds b = bounds_of(points);
  std::array<int, 3> axes{0, 1, 2};
  std::stable_sort(axes.begin(), axes.begin() + dimension,
                   [&](int p, int q) { return b.high[p] - b.low[p] > b.high[q] - b.low[q] + 1e-9 * spacing; });
  const int slowest = axes[0], fastest = axes[1], middle = dimension == 3 ? axes[2] : axes[0];
  // half a spacing of margin keeps the rows of a lattice, rounded or a little disturbed, in the middle of their bins
  auto bin = [&](const Point& p, int axis) { return std::lround((p[axis] - b.low[axis]) / spacing); };
  std::vector<Key> keys(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    keys[i] = {bin(points[i], slowest), dimension == 3 ? bin(points[i], middle) : 0, points[i][fastest], static_cast<int>(i)};
  std::sort(keys.begin(), keys.end());
  std::transform(keys.begin(), keys.end(), order.begin(), [](const Key& key) { return key.point; });
  return order;
}

}  // namespace sinew
