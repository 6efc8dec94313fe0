#pragma once
/// Eight doubles in one vector register, one lane a particle. The width is a constant of the program, not of the
/// machine: the compiler splits it where registers are narrower, so results do not depend on the vector length.

#include <bit>
#include <cmath>
#include <cstdint>
#include <sinew/core/device.hpp>

namespace sinew {

inline constexpr int lanes = 8;

/// Eight truth values, all bits set or none.
struct PackMask {
  using V = long long __attribute__((vector_size(8 * lanes)));
  V v;
  friend SINEW_INLINE PackMask operator&(PackMask a, PackMask b) { return {a.v & b.v}; }
  friend SINEW_INLINE PackMask operator|(PackMask a, PackMask b) { return {a.v | b.v}; }
  friend SINEW_INLINE PackMask operator!(PackMask a) { return {~a.v}; }
  SINEW_INLINE bool operator[](int i) const { return v[i] != 0; }
};

struct Pack {
  using V = double __attribute__((vector_size(8 * lanes)));
  using Integers = PackMask::V;
  V v{};

  Pack() = default;
  SINEW_INLINE Pack(double s) : v{s, s, s, s, s, s, s, s} {}
  SINEW_INLINE explicit Pack(V raw) : v(raw) {}

  static SINEW_INLINE Pack load(const double* aligned) { return Pack(*reinterpret_cast<const V*>(aligned)); }
  SINEW_INLINE void store(double* aligned) const { *reinterpret_cast<V*>(aligned) = v; }

  SINEW_INLINE double operator[](int i) const { return v[i]; }
  SINEW_INLINE void set(int i, double s) { v[i] = s; }

  friend SINEW_INLINE Pack operator+(Pack a, Pack b) { return Pack(a.v + b.v); }
  friend SINEW_INLINE Pack operator-(Pack a, Pack b) { return Pack(a.v - b.v); }
  friend SINEW_INLINE Pack operator*(Pack a, Pack b) { return Pack(a.v * b.v); }
  friend SINEW_INLINE Pack operator/(Pack a, Pack b) { return Pack(a.v / b.v); }
  friend SINEW_INLINE Pack operator-(Pack a) { return Pack(-a.v); }
  SINEW_INLINE Pack& operator+=(Pack b) { return v += b.v, *this; }
  SINEW_INLINE Pack& operator-=(Pack b) { return v -= b.v, *this; }
  SINEW_INLINE Pack& operator*=(Pack b) { return v *= b.v, *this; }

  friend SINEW_INLINE PackMask operator<(Pack a, Pack b) { return {a.v < b.v}; }
  friend SINEW_INLINE PackMask operator>(Pack a, Pack b) { return {a.v > b.v}; }
  friend SINEW_INLINE PackMask operator<=(Pack a, Pack b) { return {a.v <= b.v}; }
  friend SINEW_INLINE PackMask operator>=(Pack a, Pack b) { return {a.v >= b.v}; }
};

// --- choose without branching; the same names work for double ------------------------------------------------

SINEW_INLINE Pack select(PackMask mask, Pack yes, Pack no) { return Pack(mask.v ? yes.v : no.v); }
SINEW_INLINE double select(bool mask, double yes, double no) { return mask ? yes : no; }

SINEW_INLINE Pack min(Pack a, Pack b) { return select(b < a, b, a); }
SINEW_INLINE Pack max(Pack a, Pack b) { return select(a < b, b, a); }
SINEW_INLINE double min(double a, double b) { return b < a ? b : a; }
SINEW_INLINE double max(double a, double b) { return a < b ? b : a; }
SINEW_INLINE Pack abs(Pack a) { return max(a, -a); }

SINEW_INLINE bool any(PackMask m) {
  long long bits = 0;
  for (int i = 0; i < lanes; ++i) bits |= m.v[i];
  return bits != 0;
}
SINEW_INLINE bool all(PackMask m) { return !any(!m); }
SINEW_INLINE bool any(bool m) { return m; }
SINEW_INLINE bool all(bool m) { return m; }

SINEW_INLINE double smallest(Pack a) {
  double s = a[0];
  for (int i = 1; i < lanes; ++i) s = min(s, a[i]);
  return s;
}
SINEW_INLINE double largest(Pack a) { return -smallest(-a); }
/// Sum over the lanes in a fixed order.
SINEW_INLINE double sum(Pack a) { return ((a[0] + a[1]) + (a[2] + a[3])) + ((a[4] + a[5]) + (a[6] + a[7])); }

// --- functions ----------------------------------------------------------------------------------------------

SINEW_INLINE Pack sqrt(Pack a) {
  Pack r;
  for (int i = 0; i < lanes; ++i) r.v[i] = __builtin_sqrt(a.v[i]);
  return r;
}

/// Natural logarithm on eight lanes; error below 1 ulp for positive normal numbers, NaN for negative ones and -inf at 0.
/// Argument reduction x = 2^k m with m in [sqrt(1/2), sqrt(2)], then the odd series of (m-1)/(m+1) with the minimax
/// coefficients of the FreeBSD mathematical library (e_log.c).
SINEW_INLINE Pack log(Pack x) {
  using I = Pack::Integers;
  const I bits = std::bit_cast<I>(x.v);
  const I shifted = bits - 0x3fe6a09e00000000LL;  // so that m falls around 1
  const I exponent = shifted >> 52;
  const Pack m(std::bit_cast<Pack::V>(bits - (exponent << 52)));
  const Pack k(__builtin_convertvector(exponent, Pack::V));
  const Pack f = m - 1.0;
  const Pack s = f / (f + 2.0);
  const Pack z = s * s;
  const Pack w = z * z;
  const Pack t1 = w * (w * (w * Pack(1.531383769920937332e-01) + 2.222219843214978396e-01) + 3.999999999940941908e-01);
  const Pack t2 = z * (w * (w * (w * Pack(1.479819860511658591e-01) + 1.818357216161805012e-01) + 2.857142874366239149e-01) +
                       6.666666666666735130e-01);
  const Pack half_square = 0.5 * f * f;
  const Pack r =
      k * 1.90821492927058770002e-10 + (s * (half_square + (t1 + t2)) - half_square + f) + k * 6.93147180369123816490e-01;
  const Pack bad = select(x < Pack(0.0), Pack(std::nan("")), Pack(-INFINITY));
  return select(x > Pack(0.0), r, select(x <= Pack(0.0), bad, x));
}

/// Cube root on eight lanes for positive normal numbers: a guess from the exponent, three steps of Halley's iteration.
SINEW_INLINE Pack cbrt(Pack x) {
  using I = Pack::Integers;
  const Pack scaled(__builtin_convertvector(std::bit_cast<I>(x.v), Pack::V) * (1.0 / 3.0));
  Pack y(std::bit_cast<Pack::V>(__builtin_convertvector(scaled.v, I) + 0x2a9f7893782da1ceLL));
  for (int i = 0; i < 3; ++i) {
    const Pack cube = y * y * y;
    y = y - y * ((cube - x) / (cube + cube + x));
  }
  return y;
}
SINEW_INLINE double cbrt(double x) { return std::cbrt(x); }

}  // namespace sinew
