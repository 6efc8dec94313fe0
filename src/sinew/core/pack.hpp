#pragma once
/// Eight doubles, one lane a particle. The width is a constant of the program, not of the machine, so results do not depend on the
/// length of the machine's vectors. What depends on that length is in namespace registers: one vector of eight or two of four.

#include <cstdint>
#include <initializer_list>
#include <sinew/core/pack_double.hpp>

#if !defined(__CUDACC__)  // a thread of a device has one particle: double only
#if defined(__AVX512F__) && defined(__AVX512DQ__)
#include <sinew/core/pack_wide.hpp>
#else
#include <sinew/core/pack_pair.hpp>
#endif

namespace sinew {

inline constexpr int lanes = 8;
/// The least multiple of eight that is not smaller.
constexpr int whole_slices(int count) { return (count + lanes - 1) / lanes * lanes; }

/// Eight truth values, all bits set or none.
struct PackMask {
  registers::Integers v;

  /// Lane k is true where bit k of `bits` is set.
  static SINEW_INLINE PackMask from_bits(unsigned char bits) { return {registers::mask_from_bits(bits)}; }

  friend SINEW_INLINE PackMask operator&(PackMask a, PackMask b) { return {a.v & b.v}; }
  friend SINEW_INLINE PackMask operator|(PackMask a, PackMask b) { return {a.v | b.v}; }
  friend SINEW_INLINE PackMask operator!(PackMask a) { return {~a.v}; }
  SINEW_INLINE bool operator[](int i) const { return registers::lane(v, i) != 0; }
};

struct Pack {
  using V = registers::Doubles;
  V v{};

  Pack() = default;
  SINEW_INLINE Pack(double s) : v(registers::repeat(s)) {}
  SINEW_INLINE explicit Pack(V raw) : v(raw) {}

  static SINEW_INLINE Pack load(const double* aligned) { return Pack(registers::load(aligned)); }
  SINEW_INLINE void store(double* aligned) const { registers::store(v, aligned); }
  static SINEW_INLINE Pack load_unaligned(const double* from) { return Pack(registers::load_unaligned(from)); }
  SINEW_INLINE void store_unaligned(double* to) const { registers::store_unaligned(v, to); }
  /// The first `count` of eight; 0 in the other lanes, which are not read.
  static SINEW_INLINE Pack load_some(const double* from, int count) {
    Pack p;
    for (int k = 0; k < count; ++k) p.set(k, from[k]);
    return p;
  }
  /// Eight floats as doubles, fastest at a multiple of 32 bytes.
  static SINEW_INLINE Pack load(const float* floats) { return Pack(registers::load(floats)); }

  /// values[index[k]] in lane k.
  template <class Index>
  static SINEW_INLINE Pack gather(const double* values, const Index* index) {
    return Pack(registers::gather(values, index));
  }

  SINEW_INLINE double operator[](int i) const { return registers::lane(v, i); }
  SINEW_INLINE void set(int i, double s) { registers::set_lane(v, i, s); }

  friend SINEW_INLINE Pack operator+(Pack a, Pack b) { return Pack(a.v + b.v); }
  friend SINEW_INLINE Pack operator-(Pack a, Pack b) { return Pack(a.v - b.v); }
  friend SINEW_INLINE Pack operator*(Pack a, Pack b) { return Pack(a.v * b.v); }
  friend SINEW_INLINE Pack operator/(Pack a, Pack b) { return Pack(a.v / b.v); }
  friend SINEW_INLINE Pack operator-(Pack a) { return Pack(-a.v); }
  SINEW_INLINE Pack& operator+=(Pack b) { return *this = *this + b; }
  SINEW_INLINE Pack& operator-=(Pack b) { return *this = *this - b; }
  SINEW_INLINE Pack& operator*=(Pack b) { return *this = *this * b; }

  friend SINEW_INLINE PackMask operator<(Pack a, Pack b) { return {a.v < b.v}; }
  friend SINEW_INLINE PackMask operator>(Pack a, Pack b) { return {a.v > b.v}; }
  friend SINEW_INLINE PackMask operator<=(Pack a, Pack b) { return {a.v <= b.v}; }
  friend SINEW_INLINE PackMask operator>=(Pack a, Pack b) { return {a.v >= b.v}; }
};

// --- choose without branching ---------------------------------------------------------------------------------

SINEW_INLINE Pack select(PackMask mask, Pack yes, Pack no) { return Pack(registers::select(mask.v, yes.v, no.v)); }
SINEW_INLINE Pack min(Pack a, Pack b) { return select(b < a, b, a); }
SINEW_INLINE Pack max(Pack a, Pack b) { return select(a < b, b, a); }
SINEW_INLINE Pack abs(Pack a) { return max(a, -a); }

SINEW_INLINE bool any(PackMask m) { return registers::any(m.v); }
SINEW_INLINE bool all(PackMask m) { return !any(!m); }

SINEW_INLINE double smallest(Pack a) {
  double s = a[0];
  for (int i = 1; i < lanes; ++i) s = min(s, a[i]);
  return s;
}
SINEW_INLINE double largest(Pack a) { return -smallest(-a); }
/// Sum over the lanes in a fixed order.
SINEW_INLINE double sum(Pack a) { return ((a[0] + a[1]) + (a[2] + a[3])) + ((a[4] + a[5]) + (a[6] + a[7])); }

// --- functions ----------------------------------------------------------------------------------------------

SINEW_INLINE Pack sqrt(Pack a) { return Pack(registers::square_root(a.v)); }

/// Natural logarithm on eight lanes; error below 1 ulp for positive normal numbers, NaN for negative ones and -inf at 0.
/// Argument reduction x = 2^k m with m in [sqrt(1/2), sqrt(2)], then the odd series of (m-1)/(m+1) with the minimax
/// coefficients of the FreeBSD mathematical library (e_log.c).
SINEW_INLINE Pack log(Pack x) {
  using namespace registers;
  const Integers bits = bits_of(select(x > Pack(0.0), x, Pack(1.0)).v);   // others are replaced below
  const Integers exponent = (bits - repeat(0x3fe6a09e00000000LL)) >> 52;  // so that m falls around 1
  const Pack m(doubles_of(bits - (exponent << 52)));
  const Pack k(to_doubles(exponent));
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

/// Exponential on eight lanes; error below 2 ulp for x from -708 to 709, 0 below, infinity above. Argument reduction x = k ln 2 + r with |r| at most
/// ln(2) / 2, then Taylor's polynomial of degree 13.
SINEW_INLINE Pack exp(Pack x) {
  using namespace registers;
  const Pack bounded = max(min(x, Pack(709.0)), Pack(-708.0));
  const Pack magic(6755399441055744.0);  // 1.5 * 2^52: to the nearest whole number
  const Pack k = (bounded * 1.44269504088896340736 + magic) - magic;
  const Pack r = (bounded - k * 6.93147180369123816490e-01) - k * 1.90821492927058770002e-10;
  Pack sum(1.0 / 6227020800.0);
  for (const double inverse_factorial : {1.0 / 479001600.0, 1.0 / 39916800.0, 1.0 / 3628800.0, 1.0 / 362880.0, 1.0 / 40320.0,
                                         1.0 / 5040.0, 1.0 / 720.0, 1.0 / 120.0, 1.0 / 24.0, 1.0 / 6.0, 0.5, 1.0, 1.0})
    sum = sum * r + inverse_factorial;
  const Pack power(doubles_of((to_integers(k.v) + repeat(1023LL)) << 52));
  const Pack y = sum * power;
  return select(x > Pack(709.0), Pack(INFINITY), select(x < Pack(-708.0), Pack(0.0), y));
}

/// Cube root on eight lanes for positive normal numbers: a guess from the exponent, three steps of Halley's iteration.
SINEW_INLINE Pack cbrt(Pack x) {
  using namespace registers;
  const Pack scaled = Pack(to_doubles(bits_of(x.v))) * (1.0 / 3.0);
  Pack y(doubles_of(to_integers(scaled.v) + repeat(0x2a9f7893782da1ceLL)));
  for (int i = 0; i < 3; ++i) {
    const Pack cube = y * y * y;
    y = y - y * ((cube - x) / (cube + cube + x));
  }
  return y;
}

/// 1 / sqrt(x) on eight lanes for positive normal numbers, to about 1 ulp: a guess from the exponent (3.4 % off), then two steps of third and
/// one of second order. No division and no square root, which are the slowest instructions there are.
SINEW_INLINE Pack inverse_sqrt(Pack x) {
  using namespace registers;
  Pack y(doubles_of(repeat(0x5fe6eb50c7b537a9LL) - (bits_of(x.v) >> 1)));
  for (int i = 0; i < 2; ++i) {
    const Pack t = x * y * y;
    y = y * (1.875 - t * (1.25 - 0.375 * t));
  }
  return y + y * (0.5 - 0.5 * x * y * y);
}

}  // namespace sinew

#endif
