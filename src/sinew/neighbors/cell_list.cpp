#include <sinew/neighbors/cell_list.hpp>

#include <algorithm>

namespace sinew {

CellList::CellList(std::span<const Point> points, double cell_size) : grid_(points, cell_size, 3) {
  AlignedArray<std::uint64_t> row(points.size());
  double farthest = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    row[i] = grid_.row(points[i]);
    farthest = max(farthest, grid_.spacings(points[i], grid_.slowest));
  }
  rounding_ = 4e-15 * farthest;
  sort(points, row);
  find_rows(row);
  make_tables();
}

void CellList::sort(std::span<const Point> points, const AlignedArray<std::uint64_t>& row) {
  const int count = static_cast<int>(points.size()), along = grid_.fastest;
  for (int i = 1; i < count && keeps_order_; ++i)
    keeps_order_ = row[i - 1] < row[i] || (row[i - 1] == row[i] && points[i - 1][along] <= points[i][along]);
  if (!keeps_order_) {
    const std::vector<int> order = row_order(points, grid_.spacing, 3);
    number_ = place_ = AlignedArray<int>(points.size());
    for (int place = 0; place < count; ++place) {
      number_[place] = order[place];
      place_[order[place]] = place;
    }
  }
  for (AlignedArray<double>& coordinate : coordinate_) coordinate = AlignedArray<double>(points.size() + lanes);
  for (int place = 0; place < count; ++place)
    for (int c = 0; c < 3; ++c) coordinate_[c][place] = points[number(place)][c];
}

void CellList::find_rows(const AlignedArray<std::uint64_t>& row) {
  const int count = static_cast<int>(row.size());
  row_of_ = AlignedArray<int>(row.size());
  for (int place = 0; place < count;) {
    const std::uint64_t here = row[number(place)];
    for (; place < count && row[number(place)] == here; ++place) row_of_[number(place)] = static_cast<int>(row_.size());
    const int slab = static_cast<int>(here / grid_.layers), layer = static_cast<int>(here % grid_.layers);
    if (slab_.empty() || slab_.back().number != slab) slab_.push_back({{}, slab, 0});
    row_.push_back({{}, layer, place});
    slab_.back().end = static_cast<int>(row_.size());
  }
}

void CellList::make_tables() {
  const int rows = static_cast<int>(row_.size()), slabs = static_cast<int>(slab_.size());
  table_ = AlignedArray<int>(row_of_.size() + 2 * (row_.size() + slab_.size()) +
                             2);  // an entry for each member, one more for each end
  for (int r = 0; r < rows; ++r)
    row_[r].along = make_ruler(r > 0 ? row_[r - 1].end : 0, row_[r].end, [&](int place) { return along()[place]; });
  for (int s = 0; s < slabs; ++s)
    slab_[s].layers = make_ruler(s > 0 ? slab_[s - 1].end : 0, slab_[s].end, [&](int r) { return row_[r].layer; });
  slabs_ = make_ruler(0, slabs, [&](int s) { return slab_[s].number; });
}

/// Table and ruler of the members [first, last) of a sequence, of which value(k) are the values: as many cells as members.
template <class Value>
CellList::Ruler CellList::make_ruler(int first, int last, Value&& value) {
  Ruler ruler;
  ruler.table = table_end_;
  if (first < last) {
    ruler.low = value(first);
    ruler.last_cell = last - first - 1;
    const double length = value(last - 1) - ruler.low;
    if (length > 0.0) ruler.inverse_size = (last - first) / length;
  }
  for (int k = first; k < last; ++k)
    for (const int entry = ruler.entry(value(k)); table_end_ <= entry;) table_[table_end_++] = k;
  for (const int end = ruler.table + static_cast<int>(ruler.last_cell) + 2; table_end_ < end;) table_[table_end_++] = last;
  return ruler;
}

}  // namespace sinew
