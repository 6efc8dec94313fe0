#pragma once
/// The registers behind Pack where one holds four doubles (AVX2) or fewer: two vectors of four. One vector of eight would do, but
/// compilers keep it in memory and take its lanes apart one by one. pack_wide.hpp offers the same names.

#include <cstddef>
#include <cstring>
#include <sinew/core/device.hpp>

namespace sinew::registers {

/// Lanes 0 to 3 and 4 to 7.
template <class Half>
struct Halves {
  Half lo, hi;

  friend SINEW_INLINE Halves operator+(Halves a, Halves b) { return {a.lo + b.lo, a.hi + b.hi}; }
  friend SINEW_INLINE Halves operator-(Halves a, Halves b) { return {a.lo - b.lo, a.hi - b.hi}; }
  friend SINEW_INLINE Halves operator*(Halves a, Halves b) { return {a.lo * b.lo, a.hi * b.hi}; }
  friend SINEW_INLINE Halves operator/(Halves a, Halves b) { return {a.lo / b.lo, a.hi / b.hi}; }
  friend SINEW_INLINE Halves operator-(Halves a) { return {-a.lo, -a.hi}; }
  friend SINEW_INLINE Halves operator&(Halves a, Halves b) { return {a.lo & b.lo, a.hi & b.hi}; }
  friend SINEW_INLINE Halves operator|(Halves a, Halves b) { return {a.lo | b.lo, a.hi | b.hi}; }
  friend SINEW_INLINE Halves operator~(Halves a) { return {~a.lo, ~a.hi}; }
  friend SINEW_INLINE Halves operator<<(Halves a, int n) { return {a.lo << n, a.hi << n}; }
  friend SINEW_INLINE Halves operator>>(Halves a, int n) { return {a.lo >> n, a.hi >> n}; }
};

using Four = double __attribute__((vector_size(32)));
using FourIntegers = long long __attribute__((vector_size(32)));
using Two = double __attribute__((vector_size(16)));
using Doubles = Halves<Four>;
using Integers = Halves<FourIntegers>;

SINEW_INLINE Integers operator<(Doubles a, Doubles b) { return {a.lo < b.lo, a.hi < b.hi}; }
SINEW_INLINE Integers operator>(Doubles a, Doubles b) { return {a.lo > b.lo, a.hi > b.hi}; }
SINEW_INLINE Integers operator<=(Doubles a, Doubles b) { return {a.lo <= b.lo, a.hi <= b.hi}; }
SINEW_INLINE Integers operator>=(Doubles a, Doubles b) { return {a.lo >= b.lo, a.hi >= b.hi}; }

SINEW_INLINE Doubles repeat(double s) { return {Four{s, s, s, s}, Four{s, s, s, s}}; }
SINEW_INLINE Integers repeat(long long s) { return {FourIntegers{s, s, s, s}, FourIntegers{s, s, s, s}}; }
template <class Half>
SINEW_INLINE auto lane(const Halves<Half>& v, int i) {
  return i < 4 ? v.lo[i] : v.hi[i - 4];
}
SINEW_INLINE void set_lane(Doubles& v, int i, double s) {
  if (i < 4)
    v.lo[i] = s;
  else
    v.hi[i - 4] = s;
}

template <class V>
SINEW_INLINE V read(const void* from) {
  V v;
  std::memcpy(&v, from, sizeof v);
  return v;
}

SINEW_INLINE Doubles load(const double* aligned) {
  return {*reinterpret_cast<const Four*>(aligned), *reinterpret_cast<const Four*>(aligned + 4)};
}
SINEW_INLINE void store(Doubles v, double* aligned) {
  *reinterpret_cast<Four*>(aligned) = v.lo;
  *reinterpret_cast<Four*>(aligned + 4) = v.hi;
}
SINEW_INLINE Doubles load_unaligned(const double* from) { return {read<Four>(from), read<Four>(from + 4)}; }
SINEW_INLINE void store_unaligned(Doubles v, double* to) {
  std::memcpy(to, &v.lo, sizeof v.lo);
  std::memcpy(to + 4, &v.hi, sizeof v.hi);
}
/// Written out, each half is one instruction; with __builtin_convertvector it is five.
SINEW_INLINE Four doubles_of(const float* f) { return Four{f[0], f[1], f[2], f[3]}; }
SINEW_INLINE Doubles load(const float* f) { return {doubles_of(f), doubles_of(f + 4)}; }

template <class Index>
SINEW_INLINE Doubles gather(const double* v, const Index* i) {
  return {Four{v[i[0]], v[i[1]], v[i[2]], v[i[3]]}, Four{v[i[4]], v[i[5]], v[i[6]], v[i[7]]}};
}

SINEW_INLINE Doubles select(Integers mask, Doubles yes, Doubles no) {
  return {mask.lo ? yes.lo : no.lo, mask.hi ? yes.hi : no.hi};
}
SINEW_INLINE Integers mask_from_bits(unsigned char bits) {
  const FourIntegers low{1, 2, 4, 8}, high{16, 32, 64, 128};
  const Integers all = repeat(static_cast<long long>(bits));
  return {(all.lo & low) == low, (all.hi & high) == high};
}
SINEW_INLINE bool any(Integers mask) {
  const FourIntegers either = mask.lo | mask.hi;
#if defined(__AVX__)
  return __builtin_ia32_ptestz256(either, either) == 0;
#else
  return (either[0] | either[1] | either[2] | either[3]) != 0;
#endif
}

SINEW_INLINE Four square_root(Four v) {
  return Four{__builtin_sqrt(v[0]), __builtin_sqrt(v[1]), __builtin_sqrt(v[2]), __builtin_sqrt(v[3])};
}
SINEW_INLINE Doubles square_root(Doubles v) { return {square_root(v.lo), square_root(v.hi)}; }
SINEW_INLINE Integers bits_of(Doubles v) { return {reinterpret_cast<FourIntegers>(v.lo), reinterpret_cast<FourIntegers>(v.hi)}; }
SINEW_INLINE Doubles doubles_of(Integers v) { return {reinterpret_cast<Four>(v.lo), reinterpret_cast<Four>(v.hi)}; }
SINEW_INLINE Integers to_integers(Doubles v) {
  return {__builtin_convertvector(v.lo, FourIntegers), __builtin_convertvector(v.hi, FourIntegers)};
}
SINEW_INLINE Doubles to_doubles(Integers v) { return {__builtin_convertvector(v.lo, Four), __builtin_convertvector(v.hi, Four)}; }

// --- eight rows in memory and their columns in registers -----------------------------------------------------------

/// {a0 b0 a2 b2}, {a1 b1 a3 b3}; low halves and high halves of both.
SINEW_INLINE Four even(Four a, Four b) { return __builtin_shufflevector(a, b, 0, 4, 2, 6); }
SINEW_INLINE Four odd(Four a, Four b) { return __builtin_shufflevector(a, b, 1, 5, 3, 7); }
SINEW_INLINE Four low_halves(Four a, Four b) { return __builtin_shufflevector(a, b, 0, 1, 4, 5); }
SINEW_INLINE Four high_halves(Four a, Four b) { return __builtin_shufflevector(a, b, 2, 3, 6, 7); }

/// The two doubles at a and the two at b: a load and one insertion from memory.
SINEW_INLINE Four join(const double* a, const double* b) {
  return __builtin_shufflevector(*reinterpret_cast<const Two*>(a), *reinterpret_cast<const Two*>(b), 0, 1, 2, 3);
}

/// Columns 0, 1 (and 2) of the rows of `width` doubles at index[0..3].
template <int width, int columns, class Index>
SINEW_INLINE void load_four(const double* rows, const Index* index, Four (&column)[columns]) {
  const double* r[4];
  for (int k = 0; k < 4; ++k) r[k] = rows + width * static_cast<std::ptrdiff_t>(index[k]);
  const Four a = join(r[0], r[2]), b = join(r[1], r[3]);
  column[0] = even(a, b), column[1] = odd(a, b);
  if constexpr (columns == 3) column[2] = even(join(r[0] + 2, r[2] + 2), join(r[1] + 2, r[3] + 2));
}

template <int columns, class Index>
SINEW_INLINE void load_eight(const double* rows, const Index* index, Doubles (&column)[columns]) {
  constexpr int width = columns == 3 ? 8 : 4;
  Four lo[columns], hi[columns];
  load_four<width>(rows, index, lo);
  load_four<width>(rows, index + 4, hi);
  for (int c = 0; c < columns; ++c) column[c] = {lo[c], hi[c]};
}

/// Columns 0, 1, 2 and 4, 5, 6 of the rows of eight doubles at index[0..7].
template <class Index>
SINEW_INLINE void load_columns(const double* rows, const Index* index, Doubles (&first)[3], Doubles (&second)[3]) {
  load_eight(rows, index, first);
  load_eight(rows + 4, index, second);
}
/// Columns 0, 1 and 2, 3 of the rows of four doubles at index[0..7].
template <class Index>
SINEW_INLINE void load_columns(const double* rows, const Index* index, Doubles (&first)[2], Doubles (&second)[2]) {
  load_eight(rows, index, first);
  load_eight(rows + 2, index, second);
}

/// Columns 0 to 3 of the rows of `width` doubles at index[0..3].
template <int width, class Index>
SINEW_INLINE void load_four_quads(const double* rows, const Index* index, Four (&column)[4]) {
  const double* r[4];
  for (int k = 0; k < 4; ++k) r[k] = rows + width * static_cast<std::ptrdiff_t>(index[k]);
  const Four a = join(r[0], r[2]), b = join(r[1], r[3]), c = join(r[0] + 2, r[2] + 2), d = join(r[1] + 2, r[3] + 2);
  column[0] = even(a, b), column[1] = odd(a, b);
  column[2] = even(c, d), column[3] = odd(c, d);
}
/// The same of eight rows.
template <int width, class Index>
SINEW_INLINE void load_quads(const double* rows, const Index* index, Doubles (&column)[4]) {
  Four lo[4], hi[4];
  load_four_quads<width>(rows, index, lo);
  load_four_quads<width>(rows, index + 4, hi);
  for (int c = 0; c < 4; ++c) column[c] = {lo[c], hi[c]};
}

template <class Row>
SINEW_INLINE void subtract_row(double* rows, int index, Row r) {
  *reinterpret_cast<Row*>(rows + sizeof(Row) / sizeof(double) * static_cast<std::ptrdiff_t>(index)) -= r;
}
template <class Index>
SINEW_INLINE void subtract_four(double* rows, const Index* index, Four x, Four y, Four z) {
  const Four xy_even = even(x, y), xy_odd = odd(x, y), z_even = even(z, Four{}), z_odd = odd(z, Four{});
  subtract_row(rows, index[0], low_halves(xy_even, z_even));
  subtract_row(rows, index[1], low_halves(xy_odd, z_odd));
  subtract_row(rows, index[2], high_halves(xy_even, z_even));
  subtract_row(rows, index[3], high_halves(xy_odd, z_odd));
}
template <class Index>
SINEW_INLINE void subtract_four(double* rows, const Index* index, Four x, Four y) {
  const Four e = even(x, y), o = odd(x, y);
  subtract_row(rows, index[0], __builtin_shufflevector(e, e, 0, 1));
  subtract_row(rows, index[1], __builtin_shufflevector(o, o, 0, 1));
  subtract_row(rows, index[2], __builtin_shufflevector(e, e, 2, 3));
  subtract_row(rows, index[3], __builtin_shufflevector(o, o, 2, 3));
}

/// Subtracts {x y z 0} of lane k from the row of four doubles at index[k], one lane after the other.
template <class Index>
SINEW_INLINE void subtract_columns(double* rows, const Index* index, Doubles x, Doubles y, Doubles z) {
  subtract_four(rows, index, x.lo, y.lo, z.lo);
  subtract_four(rows, index + 4, x.hi, y.hi, z.hi);
}
/// Subtracts {x y} of lane k from the row of two doubles at index[k], one lane after the other.
template <class Index>
SINEW_INLINE void subtract_columns(double* rows, const Index* index, Doubles x, Doubles y) {
  subtract_four(rows, index, x.lo, y.lo);
  subtract_four(rows, index + 4, x.hi, y.hi);
}

}  // namespace sinew::registers
