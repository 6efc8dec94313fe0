#pragma once
/// The loops over pairs, eight particles at once. Physics comes in as a function of one (vector of a) pair.

#include <sinew/neighbors/pair_list.hpp>

namespace sinew {

/// Eight pairs i -> j, one a lane: entry of the pair list, u_j - u_i and X_j - X_i.
template <int D>
struct PairPack {
  std::size_t entry;
  Vec<Pack, D> u, X;
};

/// The place rows of the eight particles of a slice.
template <int D>
SINEW_INLINE PlacePack<D> load_slice(const double* places, int slice) {
  const int first = lanes * slice;
  const int own[lanes] = {first, first + 1, first + 2, first + 3, first + 4, first + 5, first + 6, first + 7};
  return load_places<D>(places, own);
}

/// Calls use(pair) for all pairs of a slice.
template <int D, class Use>
SINEW_INLINE void for_each_pair(const PairList& list, const double* places, int slice, const PlacePack<D>& own, Use&& use) {
  for (std::size_t e = list.first_entry[slice]; e < list.first_entry[slice + 1]; ++e) {
    const PlacePack<D> other = load_places<D>(places, list.entry(e));
    use(PairPack<D>{e, other.u - own.u, other.X - own.X});
  }
}

/// Calls t = share(pair) for all pairs of a slice, adds t to the row of i and subtracts it from the row of j: momentum is conserved by
/// construction. One pair after the other, in list order.
template <int D, class Share>
SINEW_INLINE void exchange_pairs(const PairList& list, const double* places, int slice, const PlacePack<D>& own, double* rows,
                                 Share&& share) {
  Vec<Pack, D> total;
  for (std::size_t e = list.first_entry[slice]; e < list.first_entry[slice + 1]; ++e) {
    const int* index = list.entry(e);
    const PlacePack<D> other = load_places<D>(places, index);
    const Vec<Pack, D> t = share(PairPack<D>{e, other.u - own.u, other.X - own.X});
    total += t;
    subtract_rows(rows, index, t);
  }
  const int first = lanes * slice;
  const int index[lanes] = {first, first + 1, first + 2, first + 3, first + 4, first + 5, first + 6, first + 7};
  subtract_rows(rows, index, -total);
}

}  // namespace sinew
