#include <sinew/neighbors/lane_bits.hpp>
#include <sinew/neighbors/moving_neighbors.hpp>

#include <algorithm>
#include <bit>
#include <cmath>

namespace sinew {

template <int D>
MovingGrid<D>::MovingGrid(double radius, const Vec<double, D>& low, const Vec<double, D>& high, double points)
    : size(0.5 * radius * (1.0 + 1e-9)) {
  const auto cells = [&] {
    double count = 1.0;
    for (int c = 0; c < D; ++c) count *= std::floor((high[c] - low[c]) / size) + 1.0;
    return count;
  };
  while (cells() > 8.0 * points + 4096.0) size *= 1.25;
  reach = static_cast<int>(std::ceil(radius / size));
}

template <int D>
typename MovingNeighbors<D>::Cell MovingNeighbors<D>::cell_of(const VectorField<D>& positions, int point) const {
  Cell cell;
  for (int c = 0; c < D; ++c) cell[c] = static_cast<int>(std::floor(positions.at(c, point) / grid_.size)) - low_[c];
  return cell;
}

/// Cells beside each other along x have numbers beside each other.
template <int D>
int MovingNeighbors<D>::number_of(const Cell& cell) const {
  int number = cell[D - 1];
  for (int c = D - 2; c >= 0; --c) number = number * cells_[c] + cell[c];
  return number;
}

template <int D>
void MovingNeighbors<D>::find_box(const VectorField<D>& positions, std::span<const int> numbers) {
  for (int c = 0; c < D; ++c) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    const double* x = positions.component(c);
    for (std::size_t point = 0; point < numbers.size(); ++point)
      if (numbers[point] >= 0) low = std::min(low, x[point]), high = std::max(high, x[point]);
    if (low > high) low = high = 0.0;
    low_[c] = static_cast<int>(std::floor(low / grid_.size));
    cells_[c] = static_cast<int>(std::floor(high / grid_.size)) - low_[c] + 1;
  }
}

/// Counting sort by cells, then by numbers within the few points of a cell.
template <int D>
void MovingNeighbors<D>::sort(const VectorField<D>& positions, std::span<const int> numbers) {
  const auto count = static_cast<int>(numbers.size());
  int cells = 1;
  for (int c = 0; c < D; ++c) cells *= cells_[c];
  cell_.resize(count);
#pragma omp parallel for schedule(static) if (count >= fewest_for_threads)
  for (int point = 0; point < count; ++point) cell_[point] = numbers[point] >= 0 ? number_of(cell_of(positions, point)) : -1;
  first_.assign(static_cast<std::size_t>(cells) + 1, 0);
  for (const int cell : cell_)
    if (cell >= 0) ++first_[cell + 1];
  for (int cell = 0; cell < cells; ++cell) first_[cell + 1] += first_[cell];
  point_at_.resize(first_[cells]);
  for (int point = 0; point < count; ++point)
    if (const int cell = cell_[point]; cell >= 0) point_at_[first_[cell]++] = point;
  for (int cell = cells; cell > 0; --cell) first_[cell] = first_[cell - 1];
  first_[0] = 0;
  const int places = this->places();
  cell_at_.resize(places);
  for (auto& along : coordinate_) along.resize(static_cast<std::size_t>(places) + lanes);
#pragma omp parallel for schedule(static) if (places >= fewest_for_threads)
  for (int cell = 0; cell < cells; ++cell) {
    std::sort(point_at_.begin() + first_[cell], point_at_.begin() + first_[cell + 1],
              [&](int a, int b) { return numbers[a] < numbers[b]; });
    for (int place = first_[cell]; place < first_[cell + 1]; ++place) {
      cell_at_[place] = cell_of(positions, point_at_[place]);
      for (int c = 0; c < D; ++c) coordinate_[c][place] = positions.at(c, point_at_[place]);
    }
  }
}

template <int D>
void MovingNeighbors<D>::choose_own(int own) {
  own_.clear();
  for (int place = 0; place < places(); ++place)
    if (point_at_[place] < own) own_.push_back(lanes * place);
  own_.resize(whole_slices(static_cast<int>(own_.size())), nobody());
  length_.resize(own_.size() / lanes);
}

/// Writes the neighbors of a place, ascending; returns how many. `hits` has room for as many as a row of cells has points, and eight more.
template <int D>
int MovingNeighbors<D>::find(int place, double radius2, int* hits) const {
  const Cell& center = cell_at_[place];
  Vec<Pack, D> x;
  for (int c = 0; c < D; ++c) x[c] = Pack(coordinate_[c][place]);
  const auto begin_of = [&](int axis) { return std::max(center[axis] - grid_.reach, 0); };
  const auto end_of = [&](int axis) { return std::min(center[axis] + grid_.reach, cells_[axis] - 1); };
  int count = 0;
  const auto search_row = [&](const Cell& row) {
    Cell cell = row;
    cell[0] = begin_of(0);
    const int first = first_[number_of(cell)];
    cell[0] = end_of(0);
    const int end = first_[number_of(cell) + 1];
    for (int p = first; p < end; p += lanes) {
      Pack distance2(0.0);
      for (int c = 0; c < D; ++c) {
        const Pack d = Pack::load_unaligned(coordinate_[c].data() + p) - x[c];
        distance2 += d * d;
      }
      unsigned bits = lane_bits::bits_of(distance2 < Pack(radius2));
      if (end - p < lanes) bits &= (1U << (end - p)) - 1U;
      if (place >= p && place < p + lanes) bits &= ~(1U << (place - p));
      const auto& set = lane_bits::set_bits.of[bits];
      for (int k = 0; k < lanes; ++k) hits[count + k] = p + set[k];
      count += std::popcount(bits);
    }
  };
  Cell row{};
  if constexpr (D == 3) {
    for (row[2] = begin_of(2); row[2] <= end_of(2); ++row[2])
      for (row[1] = begin_of(1); row[1] <= end_of(1); ++row[1]) search_row(row);
  } else {
    for (row[1] = begin_of(1); row[1] <= end_of(1); ++row[1]) search_row(row);
  }
  return count;
}

/// False if a slice needs more room than there is; `room_` is then what it needs.
template <int D>
bool MovingNeighbors<D>::find_all(double radius) {
  const int slices = this->slices(), nobody = this->nobody();
  const double radius2 = radius * radius;
  long pairs = 0;
  int longest_of_all = 0;
  const std::size_t entries_at_most = static_cast<std::size_t>(slices) * room_ * lanes;
  if (entry_.size() < entries_at_most) entry_ = AlignedArray<int>(entries_at_most);
  if (hits_.size() < most_threads()) hits_.resize(most_threads());
  for (std::vector<int>& hits : hits_)
    if (hits.size() < point_at_.size() + lanes) hits.resize(point_at_.size() + lanes);
#pragma omp parallel if (places() >= fewest_for_threads) reduction(+ : pairs) reduction(max : longest_of_all)
  {
    std::vector<int>& hits = hits_[this_thread()];
#pragma omp for schedule(dynamic, 32)
    for (int s = 0; s < slices; ++s) {
      const int* own = own_.data() + static_cast<std::ptrdiff_t>(lanes) * s;
      int* entries = entry_.data() + static_cast<std::size_t>(s) * room_ * lanes;
      int counts[lanes] = {}, longest = 0;
      for (int k = 0; k < lanes; ++k) {
        if (own[k] == nobody) continue;
        counts[k] = find(own[k] / lanes, radius2, hits.data());
        longest = std::max(longest, counts[k]);
        pairs += counts[k];
        for (int n = 0; n < std::min(counts[k], room_); ++n) entries[lanes * n + k] = lanes * hits[n];
      }
      for (int k = 0; k < lanes; ++k)
        for (int n = counts[k]; n < std::min(longest, room_); ++n) entries[lanes * n + k] = nobody;
      length_[s] = longest;
      longest_of_all = std::max(longest_of_all, longest);
    }
  }
  pairs_ = pairs;
  if (longest_of_all <= room_) return true;
  room_ = longest_of_all + longest_of_all / 8 + 2;
  return false;
}

template <int D>
void MovingNeighbors<D>::build(const VectorField<D>& positions, std::span<const int> numbers, int own, double radius,
                               const MovingGrid<D>& grid) {
  grid_ = grid;
  find_box(positions, numbers);
  sort(positions, numbers);
  choose_own(own);
  while (!find_all(radius)) {
  }
}

template <int D>
void MovingNeighbors<D>::take_part(const MovingNeighbors& all, FunctionRef<bool(int, int)> keep) {
  point_at_ = all.point_at_;
  room_ = all.room_;
  own_.clear();
  own_points_.clear();
  ends_.clear();
  hits_.resize(1);
  std::vector<int>& kept = hits_[0];
  kept.clear();
  for (int s = 0; s < all.slices(); ++s) {
    const MovingSlice slice = all.slice(s);
    for (int k = 0; k < lanes; ++k) {
      const std::size_t before = kept.size();
      for (int n = 0; n < slice.length && slice.own[k] != nobody(); ++n) {
        const int offset = slice.places[lanes * n + k];
        if (offset != nobody() && keep(point_at(slice.own[k] / lanes), point_at(offset / lanes))) kept.push_back(offset);
      }
      if (kept.size() == before) continue;
      own_.push_back(slice.own[k]);
      own_points_.push_back(point_at(slice.own[k] / lanes));
      ends_.push_back(static_cast<int>(kept.size()));
    }
  }
  pairs_ = static_cast<long>(kept.size());
  lay_out(kept);
}

/// Neighbors that stand one after the other into slices.
template <int D>
void MovingNeighbors<D>::lay_out(const std::vector<int>& kept) {
  const std::size_t rows = own_.size();
  own_.resize(whole_slices(static_cast<int>(rows)), nobody());
  length_.assign(own_.size() / lanes, 0);
  const std::size_t entries = own_.size() * room_;
  if (entry_.size() < entries) entry_ = AlignedArray<int>(entries);
  std::fill_n(entry_.begin(), entries, nobody());
  int next = 0;
  for (std::size_t row = 0; row < rows; ++row) {
    int* entry = entry_.data() + row / lanes * room_ * lanes + row % lanes;
    length_[row / lanes] = std::max(length_[row / lanes], ends_[row] - next);
    for (; next < ends_[row]; ++next, entry += lanes) *entry = kept[next];
  }
}

template <int D>
std::size_t MovingNeighbors<D>::bytes() const {
  return entry_.bytes() + places() * (sizeof(Cell) + sizeof(int) + D * sizeof(double)) + first_.size() * sizeof(int) +
         (own_.size() + length_.size() + cell_.size()) * sizeof(int);
}

template struct MovingGrid<2>;
template struct MovingGrid<3>;
template class MovingNeighbors<2>;
template class MovingNeighbors<3>;

}  // namespace sinew
