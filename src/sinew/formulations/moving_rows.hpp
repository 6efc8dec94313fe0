#pragma once
/// What a particle shows to its neighbors in the current configuration, row by row in spatial order. All rows are one or two cache lines, so that one offset finds the
/// place in each of them; loops take the quarters and halves of a row that they need.
///
///     motion row  {x y z m  v_x v_y v_z 1/rho} in 3D, {x y m 1/rho  v_x v_y - -} in 2D
///     stress row  {T_xx T_yy T_zz T_xy  T_yz T_xz c -} in 3D, {T_xx T_yy T_xy c  - - - -} in 2D     T: sigma B^T / rho^2, c: speed of sound
///     rest row    {T_yx T_zy T_zx -} and {R_xx R_yy R_zz R_xy  R_yz R_xz - -  L row by row, G}      what only some cases need
///
/// R: artificial stress or pressure; L: velocity gradient, G: shear modulus. m: mass per thickness in two dimensions.

#include <sinew/core/pack.hpp>
#include <sinew/core/vec.hpp>

namespace sinew {

inline constexpr int moving_row = 8;  ///< doubles in a motion or stress row
inline constexpr int rest_row = 24;   ///< likewise of the rest
/// Where parts of the rest begin.
inline constexpr int rest_lower = 0, rest_repulsion = 4, rest_gradient = 12;

template <int D>
struct PlacePart {
  Vec<Pack, D> x;
  Pack mass;
};
template <int D>
struct MotionPart {
  Vec<Pack, D> v;
  Pack specific_volume;  ///< 1 / rho
};
template <int D>
struct StressPart {
  Mat<Pack, D> T;
  Pack sound_speed;
};
/// A matrix and a number beside it.
template <int D>
struct GradientPart {
  Mat<Pack, D> L;
  Pack modulus;
};

/// Rows of `width` doubles, at offsets that are lanes times the place.
template <int width>
struct RowQuads {
  const double* rows;
  const int* offset;
  SINEW_INLINE void load(int first, Pack (&column)[4]) const {
    registers::Doubles raw[4];
    registers::load_quads<width / moving_row>(rows + first, offset, raw);
    for (int c = 0; c < 4; ++c) column[c] = Pack(raw[c]);
  }
};

template <int D>
SINEW_INLINE PlacePart<D> load_place(const double* rows, const int* offset) {
  Pack a[4];
  RowQuads<moving_row>{rows, offset}.load(0, a);
  if constexpr (D == 3)
    return {{{a[0], a[1], a[2]}}, a[3]};
  else
    return {{{a[0], a[1]}}, a[2]};
}

template <int D>
SINEW_INLINE MotionPart<D> load_motion(const double* rows, const int* offset) {
  Pack b[4];
  RowQuads<moving_row>{rows, offset}.load(4, b);
  if constexpr (D == 3) {
    return {{{b[0], b[1], b[2]}}, b[3]};
  } else {
    Pack a[4];
    RowQuads<moving_row>{rows, offset}.load(0, a);
    return {{{b[0], b[1]}}, a[3]};
  }
}

/// `lower`: whether T is not symmetric, and the rest rows have its lower half.
template <int D>
SINEW_INLINE StressPart<D> load_stress(const double* rows, const double* rest, bool lower, const int* offset) {
  StressPart<D> part;
  Pack a[4], b[4];
  RowQuads<moving_row>{rows, offset}.load(0, a);
  if constexpr (D == 3) {
    RowQuads<moving_row>{rows, offset}.load(4, b);
    part.T = {{{a[0], a[3], b[1]}, {a[3], a[1], b[0]}, {b[1], b[0], a[2]}}};
    part.sound_speed = b[2];
  } else {
    part.T = {{{a[0], a[2]}, {a[2], a[1]}}};
    part.sound_speed = a[3];
  }
  if (lower) {
    RowQuads<rest_row>{rest, offset}.load(rest_lower, a);
    part.T[1][0] = a[0];
    if constexpr (D == 3) part.T[2][1] = a[1], part.T[2][0] = a[2];
  }
  return part;
}

template <int D>
SINEW_INLINE Mat<Pack, D> load_repulsion(const double* rest, const int* offset) {
  Pack a[4], b[4];
  RowQuads<rest_row>{rest, offset}.load(rest_repulsion, a);
  if constexpr (D == 2) return {{{a[0], a[2]}, {a[2], a[1]}}};
  RowQuads<rest_row>{rest, offset}.load(rest_repulsion + 4, b);
  Mat<Pack, D> m;
  for (int c = 0; c < D; ++c) m[c][c] = a[c];
  m[0][1] = m[1][0] = a[3];
  m[1][D - 1] = m[D - 1][1] = b[0];
  m[0][D - 1] = m[D - 1][0] = b[1];
  return m;
}

template <int D>
SINEW_INLINE GradientPart<D> load_gradient(const double* rest, const int* offset) {
  Pack column[12];
  for (int quad = 0; quad < (D == 3 ? 3 : 2); ++quad) {
    Pack part[4];
    RowQuads<rest_row>{rest, offset}.load(rest_gradient + 4 * quad, part);
    for (int c = 0; c < 4; ++c) column[4 * quad + c] = part[c];
  }
  GradientPart<D> gradient;
  for (int c = 0; c < D * D; ++c) gradient.L[c / D][c % D] = column[c];
  gradient.modulus = column[D * D];
  return gradient;
}

}  // namespace sinew
