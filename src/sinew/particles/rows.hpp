#pragma once
/// Rows: what one particle shows to its neighbors, packed so that a neighbor is one cache line (3D) or half of one (2D).
///
///     place row   {u_x u_y u_z -  X_x X_y X_z -} in 3D, {u_x u_y X_x X_y} in 2D       u: displacement, X: reference position
///     vector row  {v_x v_y v_z -}                in 3D, {v_x v_y}         in 2D       velocities, forces
///
/// The displacement, not the current position, is stored: F - I is then as accurate as u itself.

#include <sinew/core/pack.hpp>
#include <sinew/core/vec.hpp>

namespace sinew {

template <int D>
inline constexpr int vector_width = D == 3 ? 4 : 2;
template <int D>
inline constexpr int place_width = 2 * vector_width<D>;

/// Displacements and reference positions of eight particles.
template <int D>
struct PlacePack {
  Vec<Pack, D> u, X;
};

/// Loads eight place rows whole and transposes them in registers.
template <int D, class Index>
SINEW_INLINE PlacePack<D> load_places(const double* rows, const Index* index) {
  registers::Doubles u[D], X[D];
  registers::load_columns(rows, index, u, X);
  PlacePack<D> p;
  for (int c = 0; c < D; ++c) p.u[c] = Pack(u[c]), p.X[c] = Pack(X[c]);
  return p;
}

/// Loads eight vector rows.
template <int D, class Index>
SINEW_INLINE Vec<Pack, D> load_vectors(const double* rows, const Index* index) {
  Vec<Pack, D> v;
  if constexpr (D == 3) {
    registers::Doubles first[2], second[2];
    registers::load_columns(rows, index, first, second);
    v[0] = Pack(first[0]), v[1] = Pack(first[1]), v[2] = Pack(second[0]);
  } else {
    for (int k = 0; k < lanes; ++k)
      for (int c = 0; c < D; ++c) v[c].set(k, rows[static_cast<std::ptrdiff_t>(vector_width<D>) * index[k] + c]);
  }
  return v;
}

/// Vectors by place.
template <int D>
struct VectorRows {
  const double* rows;

  template <class Index>
  SINEW_INLINE Vec<Pack, D> load(const Index* index) const {
    return load_vectors<D>(rows, index);
  }
};

/// D x D matrices by place, D vector rows each.
template <int D>
struct MatrixRows {
  const double* rows;

  /// Of eight particles, row by row: the whole matrix would not fit into registers.
  struct Of {
    const double* rows;
    int first_row[lanes];
    SINEW_INLINE Vec<Pack, D> row(int r) const { return load_vectors<D>(rows + vector_width<D> * r, first_row); }
  };
  template <class Index>
  SINEW_INLINE Of load(const Index* index) const {
    Of of{rows, {}};
    for (int k = 0; k < lanes; ++k) of.first_row[k] = D * index[k];
    return of;
  }
};

/// Subtracts lane k of `t` from vector row index[k], one lane after the other: equal indices are added up correctly.
template <int D, class Index>
SINEW_INLINE void subtract_rows(double* rows, const Index* index, const Vec<Pack, D>& t) {
  if constexpr (D == 3)
    registers::subtract_columns(rows, index, t[0].v, t[1].v, t[2].v);
  else
    registers::subtract_columns(rows, index, t[0].v, t[1].v);
}

}  // namespace sinew
