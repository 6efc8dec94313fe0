#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <sinew/io/picture/surface_normals.hpp>

namespace sinew {

namespace {

constexpr double reach_in_spacings = 2.5;
/// The mean offset of the neighbors of a particle on a flat surface, as a part of the reach (3/8 for a half ball).
constexpr double offset_of_a_half_ball = 0.375;

/// Particles sorted by cells as wide as the reach. Cells share a table by hashing, so any extent will do.
class CellTable {
 public:
  CellTable(std::span<const Point> position_, double reach_) : position(position_), reach(reach_) {
    const std::size_t count = position.size();
    mask = std::bit_ceil(count + 1) - 1;
    std::vector<std::size_t> slot(count);
    std::vector<int> next(mask + 2, 0);
    for (std::size_t p = 0; p < count; ++p) {
      slot[p] = slot_of(cell(position[p], 0), cell(position[p], 1), cell(position[p], 2));
      ++next[slot[p] + 1];
    }
    std::partial_sum(next.begin(), next.end(), next.begin());
    first = next;
    sorted.resize(count);
    for (std::size_t p = 0; p < count; ++p) sorted[static_cast<std::size_t>(next[slot[p]]++)] = static_cast<int>(p);
  }

  /// Sum of (x_b - x) and number over all b within reach of x.
  Point mean_offset(const Point& x) const {
    Point sum{};
    int count = 0;
    std::vector<std::size_t> seen;
    for (int i = -1; i <= 1; ++i)
      for (int j = -1; j <= 1; ++j)
        for (int k = -1; k <= 1; ++k) {
          const std::size_t slot = slot_of(cell(x, 0) + i, cell(x, 1) + j, cell(x, 2) + k);
          if (std::find(seen.begin(), seen.end(), slot) != seen.end()) continue;
          seen.push_back(slot);
          for (int s = first[slot]; s < first[slot + 1]; ++s) {
            const Point d = position[static_cast<std::size_t>(sorted[static_cast<std::size_t>(s)])] - x;
            if (dot(d, d) >= reach * reach) continue;
            sum += d;
            ++count;
          }
        }
    return (1.0 / std::max(1, count)) * sum;
  }

 private:
  std::int64_t cell(const Point& x, int axis) const { return static_cast<std::int64_t>(std::floor(x[axis] / reach)); }
  std::size_t slot_of(std::int64_t i, std::int64_t j, std::int64_t k) const {
    constexpr std::uint64_t primes[3] = {73856093, 19349663, 83492791};  // Teschner et al. (2003)
    return (static_cast<std::uint64_t>(i) * primes[0] ^ static_cast<std::uint64_t>(j) * primes[1] ^
            static_cast<std::uint64_t>(k) * primes[2]) &
           mask;
  }

  std::span<const Point> position;
  double reach;
  std::size_t mask = 0;
  std::vector<int> first, sorted;  ///< slot s holds sorted[first[s]] .. sorted[first[s + 1] - 1]
};

}  // namespace

std::vector<Point> surface_normals(std::span<const Point> position, std::span<const int> which, double spacing) {
  const double reach = reach_in_spacings * spacing;
  const CellTable cells(position, reach);
  std::vector<Point> normals;
  normals.reserve(which.size());
  for (const int p : which) {
    const Point offset = cells.mean_offset(position[static_cast<std::size_t>(p)]);
    const double length = norm(offset), one_sidedness = std::min(1.0, length / (offset_of_a_half_ball * reach));
    normals.push_back(length > 0.0 ? (-one_sidedness / length) * offset : Point{});
  }
  return normals;
}

}  // namespace sinew
