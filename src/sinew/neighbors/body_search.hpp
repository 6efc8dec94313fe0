#pragma once
/// Looks around each particle of one body. The particles of a slice find the rows near them together, then each looks at eight
/// places of a row at a time.

#include <algorithm>
#include <sinew/neighbors/cell_list.hpp>
#include <sinew/particles/particles.hpp>

namespace sinew {

/// A row that may hold neighbors of particles of a slice.
struct NearRow {
  int first[lanes];  ///< for each of them, the sorted place where those may begin
  int end;           ///< last sorted place of the row + 1
  unsigned reached;  ///< bit k: the row may hold neighbors of the k-th
};

template <int D>
class BodySearch {
 public:
  BodySearch(const Arrangement<D>& particles, const BodyRange& range)
      : body_(range),
        cells_(reference_points(particles, range).view(), range.spacing) {}

  const BodyRange& body() const { return body_; }
  const CellList& cells() const { return cells_; }

  /// Particles, not padding, in the slice that begins at `slot`.
  int particles_in(int slot) const { return std::min(lanes, body_.begin + body_.count - slot); }

  /// Rows near the particles of the slice that begins at `slot`; the k-th sees as far as radius[k].
  void find_rows(int slot, const double* radius, std::vector<NearRow>& rows) const {
    rows.clear();
    const int first = slot - body_.begin, particles = particles_in(slot);
    for (int begin = 0, end = 0; begin < particles; begin = end) {
      while (end < particles && cells_.row(first + begin) == cells_.row(first + end)) ++end;
      add_rows(first, radius, {begin, end}, rows);
    }
  }

  /// Calls use(place, squared distances, others) until the particle in `slot` has seen all sorted places that may be closer to it
  /// than `radius`: eight from `place` on. Bit k of `others` is set where place + k is in the row and not the particle itself.
  template <class Use>
  SINEW_INLINE void for_each_eight(int slot, double radius, const std::vector<NearRow>& rows, Use&& use) const {
    const int lane = slot % lanes, self = cells_.place(slot - body_.begin);
    const Point center = cells_.point(self);
    const double end_along = cells_.end_along(center, radius);
    const double *along = cells_.along(), *x = cells_.coordinate(0), *y = cells_.coordinate(1), *z = cells_.coordinate(2);
    for (const NearRow& row : rows) {
      if ((row.reached >> lane & 1U) == 0U) continue;
      const int end = row.end;
      int place = row.first[lane];
      do {
        Vec<Pack, D> d;
        d[0] = Pack::load_unaligned(x + place) - center[0];
        d[1] = Pack::load_unaligned(y + place) - center[1];
        if constexpr (D == 3) d[2] = Pack::load_unaligned(z + place) - center[2];
        const unsigned in_row = 0xffU >> std::max(0, lanes - (end - place));
        const auto itself = static_cast<unsigned>(self - place);
        use(place, dot(d, d), in_row & ~(static_cast<unsigned>(itself < lanes) << (itself % lanes)));
        place += lanes;
      } while (place < end && along[place - 1] <= end_along);
    }
  }

 private:
  struct Lanes {
    int begin, end;
  };

  static AlignedArray<Point> reference_points(const Arrangement<D>& particles, const BodyRange& range) {
    AlignedArray<Point> points(range.count);
    for (int i = 0; i < range.count; ++i) points[i] = particles.reference(range.begin + i);
    return points;
  }

  /// For particles of one row: far from one another they would have few rows in common.
  void add_rows(int first_particle, const double* radius, Lanes which, std::vector<NearRow>& rows) const {
    Vec3<Pack> center;
    Pack reach;
    for (int k = 0; k < lanes; ++k) {
      const int lane = std::clamp(k, which.begin, which.end - 1);
      const Point point = cells_.point(cells_.place(first_particle + lane));
      for (int c = 0; c < 3; ++c) center[c].set(k, point[c]);
      reach.set(k, radius[lane]);
    }
    const unsigned lanes_meant = (1U << which.end) - (1U << which.begin);
    cells_.for_each_row(center, reach, [&](const int(&first)[lanes], int end, unsigned reached) {
      NearRow& row = rows.emplace_back();
      std::copy(first, first + lanes, row.first);
      row.end = end;
      row.reached = reached & lanes_meant;
    });
  }

  const BodyRange& body_;
  CellList cells_;
};

}  // namespace sinew
