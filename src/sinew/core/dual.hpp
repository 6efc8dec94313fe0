#pragma once
/// Dual numbers a + b eps, eps^2 = 0: exact first derivatives through any function written for a generic `T`.
/// `T` is double or Pack.

#include <sinew/core/pack.hpp>

namespace sinew {

template <class T = double>
struct Dual {
  T value{}, slope{};

  Dual() = default;
  SINEW_INLINE Dual(double v) : value(v), slope(0.0) {}
  SINEW_INLINE Dual(T v, T s) : value(v), slope(s) {}

  friend SINEW_INLINE Dual operator+(const Dual& a, const Dual& b) { return {a.value + b.value, a.slope + b.slope}; }
  friend SINEW_INLINE Dual operator-(const Dual& a, const Dual& b) { return {a.value - b.value, a.slope - b.slope}; }
  friend SINEW_INLINE Dual operator-(const Dual& a) { return {-a.value, -a.slope}; }
  friend SINEW_INLINE Dual operator*(const Dual& a, const Dual& b) {
    return {a.value * b.value, a.slope * b.value + a.value * b.slope};
  }
  friend SINEW_INLINE Dual operator/(const Dual& a, const Dual& b) {
    const T q = a.value / b.value;
    return {q, (a.slope - q * b.slope) / b.value};
  }
  SINEW_INLINE Dual& operator+=(const Dual& b) { return *this = *this + b; }
  SINEW_INLINE Dual& operator-=(const Dual& b) { return *this = *this - b; }
  friend SINEW_INLINE auto operator<(const Dual& a, const Dual& b) { return a.value < b.value; }
  friend SINEW_INLINE auto operator>(const Dual& a, const Dual& b) { return a.value > b.value; }
  friend SINEW_INLINE auto operator<=(const Dual& a, const Dual& b) { return a.value <= b.value; }
  friend SINEW_INLINE auto operator>=(const Dual& a, const Dual& b) { return a.value >= b.value; }
};

template <class T, class Mask>
SINEW_INLINE Dual<T> select(const Mask& mask, const Dual<T>& yes, const Dual<T>& no) {
  return {select(mask, yes.value, no.value), select(mask, yes.slope, no.slope)};
}
template <class T>
SINEW_INLINE Dual<T> min(const Dual<T>& a, const Dual<T>& b) {
  return select(b < a, b, a);
}
template <class T>
SINEW_INLINE Dual<T> max(const Dual<T>& a, const Dual<T>& b) {
  return select(a < b, b, a);
}

template <class T>
SINEW_INLINE Dual<T> sqrt(const Dual<T>& a) {
  using std::sqrt;
  const T r = sqrt(a.value);
  return {r, a.slope / (T(2.0) * r)};
}
template <class T>
SINEW_INLINE Dual<T> log(const Dual<T>& a) {
  using std::log;
  return {log(a.value), a.slope / a.value};
}
template <class T>
SINEW_INLINE Dual<T> cbrt(const Dual<T>& a) {
  const T r = cbrt(a.value);
  return {r, a.slope / (T(3.0) * r * r)};
}

}  // namespace sinew
