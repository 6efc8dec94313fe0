#pragma once
/// Points sorted into the cells of a regular grid: all points near a place without looking at all of them.

#include <sinew/core/vec.hpp>
#include <vector>

namespace sinew {

class CellList {
 public:
  /// Sorts the points into cells of edge `cell_size`. A grid with very many empty cells is made coarser.
  CellList(const std::vector<Point>& points, double cell_size);

  /// Calls visit(number, squared distance) for every point closer to `center` than `radius`.
  template <class Visit>
  void for_each_within(const Point& center, double radius, Visit&& visit) const {
    int low[3], high[3];
    for (int c = 0; c < 3; ++c) {
      low[c] = cell_of(center[c] - radius, c);
      high[c] = cell_of(center[c] + radius, c);
    }
    const double limit = radius * radius;
    for (int iz = low[2]; iz <= high[2]; ++iz)
      for (int iy = low[1]; iy <= high[1]; ++iy) {
        const std::size_t row = (static_cast<std::size_t>(iz) * cells_[1] + iy) * cells_[0];
        for (int k = first_[row + low[0]]; k < first_[row + high[0] + 1]; ++k) {
          const Point d = sorted_[k] - center;
          const double r2 = dot(d, d);
          if (r2 < limit) visit(number_[k], r2);
        }
      }
  }

 private:
  int cell_of(double coordinate, int axis) const {
    const double c = (coordinate - low_[axis]) * inverse_size_;
    return c <= 0.0 ? 0 : c >= cells_[axis] ? cells_[axis] - 1 : static_cast<int>(c);
  }

  Point low_;
  double inverse_size_ = 1.0;
  int cells_[3] = {1, 1, 1};
  std::vector<int> first_;   ///< first sorted point of each cell, and the end
  std::vector<int> number_;  ///< sorted place -> number of the point
  std::vector<Point> sorted_;
};

}  // namespace sinew
