#pragma once
/// Points sorted into slabs, rows and along the rows of a SlabGrid: all points near a place without looking at all of them. Empty
/// slabs and rows take no memory, however far apart the points are.

#include <bit>
#include <sinew/neighbors/lane_bits.hpp>
#include <sinew/particles/aligned_array.hpp>
#include <sinew/particles/order.hpp>
#include <vector>

namespace sinew {

class CellList {
 public:
  /// Rows are `cell_size` wide. Points that are in computing order of that spacing keep it.
  CellList(std::span<const Point> points, double cell_size);

  /// Calls visit(number, squared distance) for every point closer to `center` than `radius`.
  template <class Visit>
  void for_each_within(const Point& center, double radius, Visit&& visit) const {
    const double limit = radius * radius, end = end_along(center, radius);
    for_each_row(center, radius, [&](const int* first, int end_row, unsigned) {
      for (int place = *first; place < end_row && along()[place] <= end; ++place) {
        const Point d = point(place) - center;
        const double r2 = dot(d, d);
        if (r2 < limit) visit(number(place), r2);
      }
    });
  }

  /// For one center (T double) or eight that are close together (T Pack): calls use(first, end, reached) for one row after the
  /// other, in the order of the sorted places. Points of the row closer to center k than radius k are at places first[k] to end;
  /// there are none if bit k of `reached` is not set.
  template <class T, class Use>
  void for_each_row(const Vec3<T>& center, const T& radius, Use&& use) const;

  /// Number of the row that a point is in.
  int row(int number) const { return row_of_[number]; }
  /// The coordinate along the rows from which on no point is closer to `center` than `radius`.
  double end_along(const Point& center, double radius) const { return center[grid_.fastest] + reach(radius) * grid_.spacing; }

  /// Number of the point at a sorted place, and the other way round.
  int number(int place) const { return keeps_order_ ? place : number_[place]; }
  int place(int number) const { return keeps_order_ ? number : place_[number]; }
  /// Whether both are the same.
  bool keeps_order() const { return keeps_order_; }
  /// Coordinates by sorted place: along an axis, all, along the rows (ascending in each). Eight places more than there are
  /// points may be read.
  const double* coordinate(int axis) const { return coordinate_[axis].data(); }
  Point point(int place) const { return {{coordinate_[0][place], coordinate_[1][place], coordinate_[2][place]}}; }
  const double* along() const { return coordinate(grid_.fastest); }

 private:
  /// Finds values in an ascending sequence. A table holds, for each of its cells, the first member that is in it or after it.
  struct Ruler {
    double low = 0.0, inverse_size = 0.0, last_cell = 0.0;
    int table = 0;  ///< entry of the first cell
    /// The low bits of the sum are the number of the cell.
    template <class T>
    T cell(const T& value) const {
      return min(T(last_cell), max(T(0.0), (value - low) * inverse_size)) + to_low_bits;
    }
    int entry(double value) const { return table + low_bits(cell(value)); }
  };
  struct Row {
    Ruler along;
    int layer = 0, end = 0;  ///< last sorted place + 1
  };
  struct Slab {
    Ruler layers;
    int number = 0, end = 0;  ///< last row + 1
  };

  /// Added to a value from 0 to 2^31, this leaves the nearest whole number in the low bits.
  static constexpr double to_low_bits = 4503599627370496.0;
  static int low_bits(double sum) { return static_cast<int>(std::bit_cast<std::uint64_t>(sum)); }

  /// Radius in cells, a little longer, so that rounding loses no point.
  template <class T>
  T reach(const T& radius) const {
    return radius * ((1.0 + 1e-12) / grid_.spacing) + rounding_;
  }
  void sort(std::span<const Point> points, const AlignedArray<std::uint64_t>& row);
  void find_rows(const AlignedArray<std::uint64_t>& row);
  void make_tables();
  template <class Value>
  Ruler make_ruler(int first, int last, Value&& value);

  SlabGrid grid_;
  double rounding_ = 0.0;  ///< of places of the grid [cells]
  bool keeps_order_ = true;
  AlignedArray<int> number_, place_;  ///< empty if the order is kept
  AlignedArray<double> coordinate_[3];
  AlignedArray<int> row_of_;
  std::vector<Row> row_;
  std::vector<Slab> slab_;
  Ruler slabs_;
  AlignedArray<int> table_;
  int table_end_ = 0;
};

template <class T, class Use>
void CellList::for_each_row(const Vec3<T>& center, const T& radius, Use&& use) const {
  using namespace lane_bits;
  const T across_slabs = grid_.spacings(center, grid_.slowest), across_layers = grid_.spacings(center, grid_.middle);
  const T along = center[grid_.fastest], far = reach(radius);
  auto distance_to_bin = [](const T& place, double bin) { return max(T(0.0), max(place - bin, bin - place) - 0.5); };
  const int end_slab = table_[slabs_.entry(largest(across_slabs + far) + 0.5) + 1];
  for (int s = table_[slabs_.entry(smallest(across_slabs - far) - 0.5)]; s < end_slab; ++s) {
    const T to_slab = distance_to_bin(across_slabs, slab_[s].number);
    const T in_slab2 = max(T(0.0), far * far - to_slab * to_slab);
    const T in_slab = sqrt(in_slab2) + 0.5;
    const Ruler& layers = slab_[s].layers;
    const int end_row = table_[layers.entry(largest(across_layers + in_slab)) + 1];
    for (int r = table_[layers.entry(smallest(across_layers - in_slab))]; r < end_row; ++r) {
      const Row& row = row_[r];
      const T to_row = distance_to_bin(across_layers, row.layer);
      const T in_row2 = in_slab2 - to_row * to_row;
      const unsigned reached = bits_of(in_row2 > T(0.0));
      if (reached == 0) continue;
      alignas(64) double cell[width<T>];
      store(row.along.cell(along - sqrt(max(T(0.0), in_row2)) * grid_.spacing), cell);
      int first[width<T>];
      for (int k = 0; k < width<T>; ++k) first[k] = table_[row.along.table + low_bits(cell[k])];
      use(first, row.end, reached);
    }
  }
}

}  // namespace sinew
