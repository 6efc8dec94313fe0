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

namespace rows_detail {

using V8 = Pack::V;
using V4 = double __attribute__((vector_size(32)));
using V2 = double __attribute__((vector_size(16)));

SINEW_INLINE V4 low_half(V8 a) { return __builtin_shufflevector(a, a, 0, 1, 2, 3); }
SINEW_INLINE V4 high_half(V8 a) { return __builtin_shufflevector(a, a, 4, 5, 6, 7); }
SINEW_INLINE V8 join(V4 a, V4 b) { return __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7); }

/// Pairs of columns of two 8-double rows: {a0 b0 a2 b2 ...} and {a1 b1 a3 b3 ...}.
SINEW_INLINE V8 even_columns(V8 a, V8 b) { return __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14); }
SINEW_INLINE V8 odd_columns(V8 a, V8 b) { return __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15); }

}  // namespace rows_detail

/// Loads eight 3D place rows whole and transposes them in registers.
SINEW_INLINE PlacePack<3> load_places(const double* rows, const int* index, std::integral_constant<int, 3>) {
  using namespace rows_detail;
  V8 r[8];
  for (int k = 0; k < 8; ++k) r[k] = *reinterpret_cast<const V8*>(rows + 8 * static_cast<std::ptrdiff_t>(index[k]));
  // after this stage lane pairs (k, k+1) hold columns: e = {c0 c0' c2 c2' c4 c4' c6 c6'}, o = {c1 c1' c3 ...}
  const V8 e01 = even_columns(r[0], r[1]), o01 = odd_columns(r[0], r[1]);
  const V8 e23 = even_columns(r[2], r[3]), o23 = odd_columns(r[2], r[3]);
  const V8 e45 = even_columns(r[4], r[5]), o45 = odd_columns(r[4], r[5]);
  const V8 e67 = even_columns(r[6], r[7]), o67 = odd_columns(r[6], r[7]);
  // columns 0 and 4 of four rows: {0 0' 4 4'} halves
  auto four = [](V8 a, V8 b) {
    return __builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13);
  };  // c, c', ... of quarter 0 and 2
  auto four_high = [](V8 a, V8 b) { return __builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15); };
  auto low = [](V8 a, V8 b) { return __builtin_shufflevector(a, b, 0, 1, 2, 3, 8, 9, 10, 11); };
  auto high = [](V8 a, V8 b) { return __builtin_shufflevector(a, b, 4, 5, 6, 7, 12, 13, 14, 15); };
  const V8 a0 = four(e01, e23), b0 = four(e45, e67);            // columns 0 | 4
  const V8 a1 = four(o01, o23), b1 = four(o45, o67);            // columns 1 | 5
  const V8 a2 = four_high(e01, e23), b2 = four_high(e45, e67);  // columns 2 | 6
  PlacePack<3> p;
  p.u[0] = Pack(low(a0, b0)), p.X[0] = Pack(high(a0, b0));
  p.u[1] = Pack(low(a1, b1)), p.X[1] = Pack(high(a1, b1));
  p.u[2] = Pack(low(a2, b2)), p.X[2] = Pack(high(a2, b2));
  return p;
}

/// Loads eight 2D place rows whole and transposes them in registers.
SINEW_INLINE PlacePack<2> load_places(const double* rows, const int* index, std::integral_constant<int, 2>) {
  using namespace rows_detail;
  V4 r[8];
  for (int k = 0; k < 8; ++k) r[k] = *reinterpret_cast<const V4*>(rows + 4 * static_cast<std::ptrdiff_t>(index[k]));
  // rows k and k + 4 side by side, then pairs of columns, then halves of lanes
  const V8 s0 = join(r[0], r[4]), s1 = join(r[1], r[5]), s2 = join(r[2], r[6]), s3 = join(r[3], r[7]);
  const V8 e01 = even_columns(s0, s1), o01 = odd_columns(s0, s1), e23 = even_columns(s2, s3), o23 = odd_columns(s2, s3);
  auto first = [](V8 a, V8 b) { return __builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13); };
  auto second = [](V8 a, V8 b) { return __builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15); };
  PlacePack<2> p;
  p.u[0] = Pack(first(e01, e23)), p.u[1] = Pack(first(o01, o23));
  p.X[0] = Pack(second(e01, e23)), p.X[1] = Pack(second(o01, o23));
  return p;
}

template <int D>
SINEW_INLINE PlacePack<D> load_places(const double* rows, const int* index) {
  return load_places(rows, index, std::integral_constant<int, D>{});
}

/// Subtracts lane k of `t` from vector row index[k], one lane after the other: equal indices are added up correctly.
SINEW_INLINE void subtract_rows(double* rows, const int* index, const Vec<Pack, 3>& t) {
  using namespace rows_detail;
  const V8 zero{};
  const V8 xy_even = even_columns(t[0].v, t[1].v), xy_odd = odd_columns(t[0].v, t[1].v);  // {x0 y0 x2 y2 ..}, {x1 y1 x3 y3 ..}
  const V8 z_even = even_columns(t[2].v, zero), z_odd = odd_columns(t[2].v, zero);        // {z0 0 z2 0 ..}
  auto pairs = [](V8 a, V8 b) { return __builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13); };         // lanes 0|4 (or 1|5)
  auto pairs_high = [](V8 a, V8 b) { return __builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15); };  // lanes 2|6 (or 3|7)
  const V8 r04 = pairs(xy_even, z_even), r15 = pairs(xy_odd, z_odd), r26 = pairs_high(xy_even, z_even),
           r37 = pairs_high(xy_odd, z_odd);
  auto subtract = [&](int k, V4 row) { *reinterpret_cast<V4*>(rows + 4 * static_cast<std::ptrdiff_t>(index[k])) -= row; };
  subtract(0, low_half(r04));
  subtract(1, low_half(r15));
  subtract(2, low_half(r26));
  subtract(3, low_half(r37));
  subtract(4, high_half(r04));
  subtract(5, high_half(r15));
  subtract(6, high_half(r26));
  subtract(7, high_half(r37));
}

SINEW_INLINE void subtract_rows(double* rows, const int* index, const Vec<Pack, 2>& t) {
  using namespace rows_detail;
  const V8 even = even_columns(t[0].v, t[1].v), odd = odd_columns(t[0].v, t[1].v);  // {x0 y0 x2 y2 ..}, {x1 y1 x3 y3 ..}
  auto subtract = [&](int k, V2 row) { *reinterpret_cast<V2*>(rows + 2 * static_cast<std::ptrdiff_t>(index[k])) -= row; };
  subtract(0, __builtin_shufflevector(even, even, 0, 1));
  subtract(1, __builtin_shufflevector(odd, odd, 0, 1));
  subtract(2, __builtin_shufflevector(even, even, 2, 3));
  subtract(3, __builtin_shufflevector(odd, odd, 2, 3));
  subtract(4, __builtin_shufflevector(even, even, 4, 5));
  subtract(5, __builtin_shufflevector(odd, odd, 4, 5));
  subtract(6, __builtin_shufflevector(even, even, 6, 7));
  subtract(7, __builtin_shufflevector(odd, odd, 6, 7));
}

}  // namespace sinew
