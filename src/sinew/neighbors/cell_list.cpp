#include <sinew/neighbors/cell_list.hpp>

#include <algorithm>
#include <cmath>

namespace sinew {

CellList::CellList(const std::vector<Point>& points, double cell_size) {
  Point high = points.empty() ? Point{} : points.front();
  low_ = high;
  for (const Point& p : points)
    for (int c = 0; c < 3; ++c) {
      low_[c] = std::min(low_[c], p[c]);
      high[c] = std::max(high[c], p[c]);
    }
  const double most_cells = 4.0 * static_cast<double>(points.size()) + 64.0;
  auto cells_at = [&](double size) {
    double product = 1.0;
    for (int c = 0; c < 3; ++c) product *= std::floor((high[c] - low_[c]) / size) + 1.0;
    return product;
  };
  double size = cell_size;
  while (cells_at(size) > most_cells) size *= 1.3;
  inverse_size_ = 1.0 / size;
  for (int c = 0; c < 3; ++c) cells_[c] = static_cast<int>(std::floor((high[c] - low_[c]) / size)) + 1;

  // counting sort: stable, so the points of a cell keep their order
  const std::size_t total = static_cast<std::size_t>(cells_[0]) * cells_[1] * cells_[2];
  first_.assign(total + 1, 0);
  std::vector<std::size_t> cell(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    cell[i] = (static_cast<std::size_t>(cell_of(points[i][2], 2)) * cells_[1] + cell_of(points[i][1], 1)) * cells_[0] +
              cell_of(points[i][0], 0);
    ++first_[cell[i] + 1];
  }
  for (std::size_t c = 0; c < total; ++c) first_[c + 1] += first_[c];
  number_.resize(points.size());
  sorted_.resize(points.size());
  std::vector<int> next(first_.begin(), first_.end() - 1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const int place = next[cell[i]]++;
    number_[place] = static_cast<int>(i);
    sorted_[place] = points[i];
  }
}

}  // namespace sinew
