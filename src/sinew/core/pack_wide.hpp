#pragma once
/// The registers behind Pack where one holds eight doubles (AVX-512): vectors of the compiler. pack_pair.hpp offers the same names.

#include <cstddef>
#include <cstring>
#include <sinew/core/device.hpp>

namespace sinew::registers {

using Doubles = double __attribute__((vector_size(64)));
using Integers = long long __attribute__((vector_size(64)));

SINEW_INLINE Doubles repeat(double s) { return Doubles{s, s, s, s, s, s, s, s}; }
SINEW_INLINE Integers repeat(long long s) { return Integers{s, s, s, s, s, s, s, s}; }
template <class V>
SINEW_INLINE auto lane(const V& v, int i) {
  return v[i];
}
SINEW_INLINE void set_lane(Doubles& v, int i, double s) { v[i] = s; }

SINEW_INLINE Doubles load(const double* aligned) { return *reinterpret_cast<const Doubles*>(aligned); }
SINEW_INLINE void store(Doubles v, double* aligned) { *reinterpret_cast<Doubles*>(aligned) = v; }
SINEW_INLINE Doubles load_unaligned(const double* from) {
  Doubles v;
  std::memcpy(&v, from, sizeof v);
  return v;
}
SINEW_INLINE void store_unaligned(Doubles v, double* to) { std::memcpy(to, &v, sizeof v); }
/// Written out, this is one instruction; with __builtin_convertvector it is four.
SINEW_INLINE Doubles load(const float* f) { return Doubles{f[0], f[1], f[2], f[3], f[4], f[5], f[6], f[7]}; }

/// Written out, the lanes meet in registers; set one after the other they meet in memory.
template <class Index>
SINEW_INLINE Doubles gather(const double* v, const Index* i) {
  return Doubles{v[i[0]], v[i[1]], v[i[2]], v[i[3]], v[i[4]], v[i[5]], v[i[6]], v[i[7]]};
}

SINEW_INLINE Doubles select(Integers mask, Doubles yes, Doubles no) { return mask ? yes : no; }
SINEW_INLINE Integers mask_from_bits(unsigned char bits) { return __builtin_ia32_cvtmask2q512(bits); }
SINEW_INLINE bool any(Integers mask) {
#if defined(__clang__)
  return __builtin_reduce_or(mask) != 0;
#else
  return __builtin_ia32_ptestmq512(mask, mask, 0xff) != 0;
#endif
}

SINEW_INLINE Doubles square_root(Doubles v) {
  Doubles r;
  for (int i = 0; i < 8; ++i) r[i] = __builtin_sqrt(v[i]);
  return r;
}
SINEW_INLINE Integers bits_of(Doubles v) { return reinterpret_cast<Integers>(v); }
SINEW_INLINE Doubles doubles_of(Integers v) { return reinterpret_cast<Doubles>(v); }
SINEW_INLINE Integers to_integers(Doubles v) { return __builtin_convertvector(v, Integers); }
SINEW_INLINE Doubles to_doubles(Integers v) { return __builtin_convertvector(v, Doubles); }

// --- eight rows in memory and their columns in registers -----------------------------------------------------------

using Four = double __attribute__((vector_size(32)));
using Two = double __attribute__((vector_size(16)));

template <class Row>
SINEW_INLINE const Row& row(const double* rows, int index) {
  return *reinterpret_cast<const Row*>(rows + sizeof(Row) / sizeof(double) * static_cast<std::ptrdiff_t>(index));
}
template <class Row>
SINEW_INLINE void subtract_row(double* rows, int index, Row r) {
  *reinterpret_cast<Row*>(rows + sizeof(Row) / sizeof(double) * static_cast<std::ptrdiff_t>(index)) -= r;
}

/// {a0 b0 a2 b2 ..}, {a1 b1 a3 b3 ..}: even and odd columns of two rows.
SINEW_INLINE Doubles even(Doubles a, Doubles b) { return __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14); }
SINEW_INLINE Doubles odd(Doubles a, Doubles b) { return __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15); }
/// Pairs 0 and 2 of both, pairs 1 and 3 of both.
SINEW_INLINE Doubles even_pairs(Doubles a, Doubles b) { return __builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13); }
SINEW_INLINE Doubles odd_pairs(Doubles a, Doubles b) { return __builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15); }
SINEW_INLINE Doubles low_halves(Doubles a, Doubles b) { return __builtin_shufflevector(a, b, 0, 1, 2, 3, 8, 9, 10, 11); }
SINEW_INLINE Doubles high_halves(Doubles a, Doubles b) { return __builtin_shufflevector(a, b, 4, 5, 6, 7, 12, 13, 14, 15); }
template <int i>
SINEW_INLINE Four half(Doubles a) {
  return __builtin_shufflevector(a, a, 4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 3);
}
template <int i>
SINEW_INLINE Two pair(Doubles a) {
  return __builtin_shufflevector(a, a, 2 * i, 2 * i + 1);
}

/// Columns 0, 1, 2 and 4, 5, 6 of the rows of eight doubles at index[0..7].
template <class Index>
SINEW_INLINE void load_columns(const double* rows, const Index* index, Doubles (&first)[3], Doubles (&second)[3]) {
  auto r = [=](int k) { return row<Doubles>(rows, index[k]); };
  const Doubles e01 = even(r(0), r(1)), o01 = odd(r(0), r(1)), e23 = even(r(2), r(3)), o23 = odd(r(2), r(3));
  const Doubles e45 = even(r(4), r(5)), o45 = odd(r(4), r(5)), e67 = even(r(6), r(7)), o67 = odd(r(6), r(7));
  const Doubles a04 = even_pairs(e01, e23), b04 = even_pairs(e45, e67);  // columns 0 | 4 of rows 0 to 3, of rows 4 to 7
  const Doubles a15 = even_pairs(o01, o23), b15 = even_pairs(o45, o67);
  const Doubles a26 = odd_pairs(e01, e23), b26 = odd_pairs(e45, e67);
  first[0] = low_halves(a04, b04), second[0] = high_halves(a04, b04);
  first[1] = low_halves(a15, b15), second[1] = high_halves(a15, b15);
  first[2] = low_halves(a26, b26), second[2] = high_halves(a26, b26);
}

/// Columns 0, 1 and 2, 3 of the rows of four doubles at index[0..7].
template <class Index>
SINEW_INLINE void load_columns(const double* rows, const Index* index, Doubles (&first)[2], Doubles (&second)[2]) {
  auto r = [=](int k) {  // rows k and k + 4 side by side
    return __builtin_shufflevector(row<Four>(rows, index[k]), row<Four>(rows, index[k + 4]), 0, 1, 2, 3, 4, 5, 6, 7);
  };
  const Doubles r0 = r(0), r1 = r(1), r2 = r(2), r3 = r(3);
  const Doubles e01 = even(r0, r1), o01 = odd(r0, r1), e23 = even(r2, r3), o23 = odd(r2, r3);
  first[0] = even_pairs(e01, e23), first[1] = even_pairs(o01, o23);
  second[0] = odd_pairs(e01, e23), second[1] = odd_pairs(o01, o23);
}

/// Columns 0 to 3 of the rows of `width` doubles at index[0..7].
template <int width, class Index>
SINEW_INLINE void load_quads(const double* rows, const Index* index, Doubles (&column)[4]) {
  auto r = [=](int k) {  // rows k and k + 4 side by side
    const double *first = rows + width * static_cast<std::ptrdiff_t>(index[k]),
                 *second = rows + width * static_cast<std::ptrdiff_t>(index[k + 4]);
    return __builtin_shufflevector(*reinterpret_cast<const Four*>(first), *reinterpret_cast<const Four*>(second), 0, 1, 2, 3, 4,
                                   5, 6, 7);
  };
  const Doubles r0 = r(0), r1 = r(1), r2 = r(2), r3 = r(3);
  const Doubles e01 = even(r0, r1), o01 = odd(r0, r1), e23 = even(r2, r3), o23 = odd(r2, r3);
  column[0] = even_pairs(e01, e23), column[1] = even_pairs(o01, o23);
  column[2] = odd_pairs(e01, e23), column[3] = odd_pairs(o01, o23);
}

/// Subtracts {x y z 0} of lane k from the row of four doubles at index[k], one lane after the other.
template <class Index>
SINEW_INLINE void subtract_columns(double* rows, const Index* index, Doubles x, Doubles y, Doubles z) {
  const Doubles xy_even = even(x, y), xy_odd = odd(x, y), z_even = even(z, Doubles{}), z_odd = odd(z, Doubles{});
  const Doubles r04 = even_pairs(xy_even, z_even), r15 = even_pairs(xy_odd, z_odd);
  const Doubles r26 = odd_pairs(xy_even, z_even), r37 = odd_pairs(xy_odd, z_odd);
  subtract_row(rows, index[0], half<0>(r04));
  subtract_row(rows, index[1], half<0>(r15));
  subtract_row(rows, index[2], half<0>(r26));
  subtract_row(rows, index[3], half<0>(r37));
  subtract_row(rows, index[4], half<1>(r04));
  subtract_row(rows, index[5], half<1>(r15));
  subtract_row(rows, index[6], half<1>(r26));
  subtract_row(rows, index[7], half<1>(r37));
}

/// Subtracts {x y} of lane k from the row of two doubles at index[k], one lane after the other.
template <class Index>
SINEW_INLINE void subtract_columns(double* rows, const Index* index, Doubles x, Doubles y) {
  const Doubles e = even(x, y), o = odd(x, y);
  subtract_row(rows, index[0], pair<0>(e));
  subtract_row(rows, index[1], pair<0>(o));
  subtract_row(rows, index[2], pair<1>(e));
  subtract_row(rows, index[3], pair<1>(o));
  subtract_row(rows, index[4], pair<2>(e));
  subtract_row(rows, index[5], pair<2>(o));
  subtract_row(rows, index[6], pair<3>(e));
  subtract_row(rows, index[7], pair<3>(o));
}

}  // namespace sinew::registers
