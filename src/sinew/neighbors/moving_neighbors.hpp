#pragma once
/// Neighbors of points that move: all pairs closer than some reach, found anew whenever something has moved too far. Points are sorted into cells by counting; the
/// order of the cells is that of space, and within a cell that of the numbers that points have in the whole case. So the neighbors of a point have one order,
/// on whatever rank it is found and by however many threads.

#include <sinew/core/function_ref.hpp>
#include <sinew/core/pack.hpp>
#include <sinew/neighbors/threads.hpp>
#include <sinew/particles/vector_field.hpp>
#include <span>
#include <vector>

namespace sinew {

/// Cells of one size over a box; a multiple of the size is at the origin, so that it does not matter where the box begins.
template <int D>
struct MovingGrid {
  double size = 1.0;  ///< [length]
  int reach = 1;      ///< cells on each side in which neighbors may be

  /// For neighbors closer than `radius` among `points` points in a box; there will not be many more cells than points.
  MovingGrid(double radius, const Vec<double, D>& low, const Vec<double, D>& high, double points);
  MovingGrid() = default;
};

/// Eight points and their neighbors: entry n of point k is places[lanes * n + k]. All of them are lanes times a place, so that they are offsets in rows of eight doubles.
struct MovingSlice {
  const int* own;     ///< of the eight; nobody() where there are fewer
  const int* places;  ///< of their neighbors; nobody() where a point has fewer than `length`
  int length;
};

template <int D>
class MovingNeighbors {
 public:
  /// `positions`: of points 0 to `numbers`.size(); those with a negative number are left out. The first `own` of them get neighbors.
  void build(const VectorField<D>& positions, std::span<const int> numbers, int own, double radius, const MovingGrid<D>& grid);

  /// The pairs {point, other} of `all` for which keep(point, other), in the same places.
  void take_part(const MovingNeighbors& all, FunctionRef<bool(int, int)> keep);

  /// Points in spatial order. Place places() is nobody's.
  int places() const { return static_cast<int>(point_at_.size()); }
  int nobody() const { return lanes * places(); }  ///< as in a slice
  int point_at(int place) const { return point_at_[place]; }
  int slices() const { return static_cast<int>(length_.size()); }
  MovingSlice slice(int s) const {
    return {own_.data() + static_cast<std::ptrdiff_t>(lanes) * s, entry_.data() + static_cast<std::size_t>(s) * room_ * lanes,
            length_[s]};
  }
  /// Those that have neighbors here, of a part.
  const std::vector<int>& own_points() const { return own_points_; }
  long pairs() const { return pairs_; }  ///< directed, closer than the radius of the list
  std::size_t bytes() const;

  /// Calls use(slice) for all of them, on all threads.
  template <class Use>
  void for_each_slice(Use&& use) const {
    const int count = slices();
#pragma omp parallel for schedule(dynamic, 32) if (places() >= fewest_for_threads)
    for (int s = 0; s < count; ++s) use(slice(s));
  }

 private:
  using Cell = Vec<int, D>;
  Cell cell_of(const VectorField<D>& positions, int point) const;
  int number_of(const Cell& cell) const;
  void find_box(const VectorField<D>& positions, std::span<const int> numbers);
  void sort(const VectorField<D>& positions, std::span<const int> numbers);
  void choose_own(int own);
  bool find_all(double radius);
  int find(int place, double radius2, int* hits) const;
  void lay_out(const std::vector<int>& kept);

  MovingGrid<D> grid_;
  Cell low_{}, cells_{};    ///< first cell, number of cells along each axis
  std::vector<int> cell_;   ///< of each point
  std::vector<int> first_;  ///< first place of each cell
  std::vector<int> point_at_, own_, length_, own_points_;
  std::vector<double> coordinate_[D];  ///< by place, with room for eight more
  std::vector<Cell> cell_at_;
  AlignedArray<int> entry_;
  std::vector<std::vector<int>> hits_;  ///< scratch, one a thread
  std::vector<int> ends_;               ///< scratch: where the neighbors of each point with some end in hits_[0]
  int room_ = 0;                        ///< entries of a slice at most
  long pairs_ = 0;
};

extern template struct MovingGrid<2>;
extern template struct MovingGrid<3>;
extern template class MovingNeighbors<2>;
extern template class MovingNeighbors<3>;

}  // namespace sinew
