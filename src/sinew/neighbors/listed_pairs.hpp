#pragma once
/// The loops over pairs of a slice that has a pair list, eight particles at once. Physics comes in as functions of one (vector of a) pair.

#include <sinew/neighbors/block_pairs.hpp>
#include <sinew/particles/rows.hpp>

namespace sinew {

/// The places of a slice.
struct OwnPlaces {
  int place[lanes];
  explicit SINEW_INLINE OwnPlaces(int first) {
    for (int k = 0; k < lanes; ++k) place[k] = first + k;
  }
};

/// What the loops read and write, for one thread.
template <int D>
struct ListedPairsData {
  const BlockPairs<D>& pairs;
  const double* place_rows;     ///< {u, X} by place
  const double* velocity_rows;  ///< by place; only for exchange_moving
  double* force_rows;           ///< by place
  double* kept;                 ///< room for the pairs of a slice, numbers_kept<D> packs each
};

template <int D>
inline constexpr int numbers_kept = 2 * D + 2;

/// One slice at a time: `enter` it, visit all its pairs once with `first_visit`, then as often as needed with the others. The first visit fetches
/// the neighbors and keeps u_ij, X_ij and the weight in order, so that later ones read one stream. `Weights`: weights.at(entry, index, X, R)
/// gives the weight of eight pairs; the fill of the list has X = 0 and a weight that is finite. `keeps`: later visits are usual; otherwise they fetch the neighbors
/// again, if they want to know of them.
template <int D, class Weights, bool keeps = true>
class ListedPairs {
  static_assert(keeps || !Weights::computed);

 public:
  using Weight = typename Weights::Weight;
  static constexpr bool listed = true, vectors = !Weights::radial;
  static constexpr int slices_together = 1;                          ///< whose first visits may come before their other visits
  static constexpr int width = 2 * D + (Weights::computed ? 2 : 0);  ///< packs kept of a pair

  SINEW_INLINE ListedPairs(const ListedPairsData<D>& data, const Weights& weights) : data_(data), weights_(weights) {}

  SINEW_INLINE void enter(int slice) {
    place_ = data_.pairs.blocks.place_of_slice[slice];
    begin_ = data_.pairs.first_entry[slice];
    end_ = data_.pairs.first_entry[slice + 1];
  }

  /// use(weight, u_ij, X_ij).
  template <class Use>
  SINEW_INLINE void first_visit(Use&& use) {
    first_visit_with(NoRows{},
                     [&](const Weight& weight, const Vec<Pack, D>& u, const Vec<Pack, D>& X, int) { use(weight, u, X); });
  }
  /// use(weight, u_ij, X_ij, rows of j). `Rows` is MatrixRows or VectorRows.
  template <class Rows, class Use>
  SINEW_INLINE void first_visit_with(const Rows& rows, Use&& use) {
    const PlacePack<D> own = load_places<D>(data_.place_rows, OwnPlaces(place_).place);
    const auto shared = weights_.of_slice(place_);
    double* kept = data_.kept;
    for (std::size_t e = begin_; e < end_; ++e) {
      const PlaceIndex* index = data_.pairs.entry(e);
      __builtin_prefetch(index + 32 * lanes);
      weights_.prefetch(e + 32);
      const PlacePack<D> other = load_places<D>(data_.place_rows, index);
      const Vec<Pack, D> u = other.u - own.u, X = other.X - own.X;
      const Weight weight = weights_.at(e, index, X, shared);
      for (int c = 0; keeps && c < D; ++c) {
        u[c].store(kept + lanes * c);
        X[c].store(kept + lanes * (D + c));
      }
      if constexpr (Weights::computed) weight.store(kept + lanes * 2 * D);
      kept += lanes * width;
      use(weight, u, X, rows.load(index));
    }
  }
  template <class Rows>
  SINEW_INLINE auto own(const Rows& rows) const {
    return rows.load(OwnPlaces(place_).place);
  }
  /// use(entry, z_j - z_i), for sums that need no more of a pair than that and stored weights.
  template <class Use>
  SINEW_INLINE void for_each_difference(const VectorRows<D>& z, Use&& use) const {
    const Vec<Pack, D> z_i = own(z);
    for (std::size_t e = begin_; e < end_; ++e) {
      const PlaceIndex* index = data_.pairs.entry(e);
      __builtin_prefetch(index + 32 * lanes);
      use(e, z.load(index) - z_i);
    }
  }
  /// sum_j weight_ij (z_j - z_i). `weights`: one a pair, entry by entry.
  SINEW_INLINE Vec<Pack, D> sum_differences(const VectorRows<D>& z, const double* weights) const {
    Vec<Pack, D> sum;
    for_each_difference(z, [&](std::size_t e, const Vec<Pack, D>& dz) { sum += Pack::load(weights + lanes * e) * dz; });
    return sum;
  }
  /// sum_j (z_j - z_i) (x) vector_ij. `weights`: D numbers a pair, entry by entry, component by component.
  SINEW_INLINE Mat<Pack, D> gradient(const VectorRows<D>& z, const double* weights) const {
    Mat<Pack, D> sum;
    for_each_difference(z, [&](std::size_t e, const Vec<Pack, D>& dz) {
      Vec<Pack, D> vector;
      for (int c = 0; c < D; ++c) vector[c] = Pack::load(weights + lanes * (D * e + c));
      sum += outer(dz, vector);
    });
    return sum;
  }
  /// Adds a force to the particles themselves.
  SINEW_INLINE void add_to_own(const Vec<Pack, D>& force) const {
    subtract_rows(data_.force_rows, OwnPlaces(place_).place, -force);
  }

  /// use(weight, u_ij, X_ij) again.
  template <class Use>
  SINEW_INLINE void visit(Use&& use) const {
    const double* kept = data_.kept;
    for (std::size_t e = begin_; e < end_; ++e, kept += lanes * width) {
      const PlacePack<D> pair = difference(e, kept);
      use(weight(e, kept), pair.u, pair.X);
    }
  }

  /// Adds t = share(weight, u_ij, X_ij) to i and subtracts it from j: momentum is conserved by construction. One pair after the other, in list order.
  template <class Share>
  SINEW_INLINE void exchange(Share&& share) const {
    Vec<Pack, D> total;
    const double* kept = data_.kept;
    for (std::size_t e = begin_; e < end_; ++e, kept += lanes * width) {
      const PlacePack<D> pair = difference(e, kept);
      const Vec<Pack, D> t = share(weight(e, kept), pair.u, pair.X);
      total += t;
      subtract_rows(data_.force_rows, data_.pairs.entry(e), t);
    }
    subtract_rows(data_.force_rows, OwnPlaces(place_).place, -total);
  }

  /// The same with t = share(weight, u_ij, v_ij, X_ij), v_ij the difference of the velocities.
  template <class Share>
  SINEW_INLINE void exchange_moving(Share& share) const {
    Vec<Pack, D> total;
    const Vec<Pack, D> own = load_vectors<D>(data_.velocity_rows, OwnPlaces(place_).place);
    const double* kept = data_.kept;
    for (std::size_t e = begin_; e < end_; ++e, kept += lanes * width) {
      const Vec<Pack, D> v = load_vectors<D>(data_.velocity_rows, data_.pairs.entry(e)) - own;
      const PlacePack<D> pair = difference(e, kept);
      const Vec<Pack, D> t = share(weight(e, kept), pair.u, v, pair.X);
      total += t;
      subtract_rows(data_.force_rows, data_.pairs.entry(e), t);
    }
    subtract_rows(data_.force_rows, OwnPlaces(place_).place, -total);
  }

 private:
  struct NoRows {
    SINEW_INLINE int load(const PlaceIndex*) const { return 0; }
  };

  /// u_ij and X_ij.
  SINEW_INLINE PlacePack<D> difference(std::size_t entry, const double* kept) const {
    PlacePack<D> pair;
    if constexpr (keeps) {
      for (int c = 0; c < D; ++c) {
        pair.u[c] = Pack::load(kept + lanes * c);
        pair.X[c] = Pack::load(kept + lanes * (D + c));
      }
    } else {
      const PlacePack<D> other = load_places<D>(data_.place_rows, data_.pairs.entry(entry));
      const PlacePack<D> own = load_places<D>(data_.place_rows, OwnPlaces(place_).place);
      pair.u = other.u - own.u, pair.X = other.X - own.X;
    }
    return pair;
  }
  SINEW_INLINE Weight weight(std::size_t entry, const double* kept) const {
    if constexpr (Weights::computed)
      return Weight::load(kept + lanes * 2 * D);
    else
      return weights_.stored(entry);
  }

  const ListedPairsData<D>& data_;
  const Weights weights_;
  int place_ = 0;
  std::size_t begin_ = 0, end_ = 0;
};

}  // namespace sinew
