#pragma once
/// The weight of a pair i -> j, at a point: how its displacement enters F_i and its force. For gradients that are corrected to be exact for linear
/// fields, g_ij = L_i (w_ij X_ij) with one number a pair, w_ij = V_j |dW/dr| / r; for all others a vector g_ij.

#include <cmath>
#include <sinew/core/pack.hpp>
#include <sinew/core/vec.hpp>

namespace sinew {

/// One number, and one more for hourglass forces that need their own.
template <class T, bool with_hourglass>
struct RadialWeight {
  T gradient;            ///< V_j a_ij [1/length^2]
  T hourglass = T(0.0);  ///< V_j W_ij / r_ij^2 [1/length^2]

  /// What is summed to sum u (x) ...: the gradient weight before its correction.
  template <int D>
  SINEW_INLINE Vec<T, D> vector(const Vec<T, D>& X) const {
    return gradient * X;
  }
  /// What carries the stress to the pair.
  template <int D>
  SINEW_INLINE Vec<T, D> force(const Vec<T, D>& X) const {
    return vector(X);
  }
  SINEW_INLINE const T& hourglass_weight() const { return hourglass; }
  SINEW_INLINE void store(double* to) const {
    gradient.store(to);
    if constexpr (with_hourglass) hourglass.store(to + lanes);
  }
  static SINEW_INLINE RadialWeight load(const double* from) {
    RadialWeight w{Pack::load(from)};
    if constexpr (with_hourglass) w.hourglass = Pack::load(from + lanes);
    return w;
  }
  /// Lanes that have a neighbor.
  SINEW_INLINE PackMask present() const { return gradient > T(0.0); }
  /// The same where the mask is set, 0 elsewhere.
  SINEW_INLINE RadialWeight only(PackMask mask) const {
    return {select(mask, gradient, T(0.0)), with_hourglass ? select(mask, hourglass, T(0.0)) : T(0.0)};
  }
};

/// The complete gradient as a vector, and more. Each is loaded where it is asked for: all at once they would not fit into registers.
template <int D>
struct VectorWeight {
  const double* gradient_at;     ///< V_j g_ij [1/length], component by component
  const double* force_at;        ///< the same, or what takes its place in the force [1/length]
  const double* hourglass_at;    ///< [1/length^2]; nullptr: none
  const double* average_at;      ///< V_j W1_ij / r_ij^2 of the average over bonds [1/length^2]
  const double* dissipation_at;  ///< V_j a_ij [1/length^2]

  SINEW_INLINE Vec<Pack, D> vector(const Vec<Pack, D>&) const { return load(gradient_at); }
  SINEW_INLINE Vec<Pack, D> force(const Vec<Pack, D>&) const { return load(force_at); }
  SINEW_INLINE Pack hourglass_weight() const { return hourglass_at ? Pack::load(hourglass_at) : Pack(0.0); }
  SINEW_INLINE Pack average() const { return Pack::load(average_at); }
  SINEW_INLINE Pack dissipation() const { return Pack::load(dissipation_at); }
  SINEW_INLINE PackMask present() const { return PackMask::from_bits(0xff); }

 private:
  static SINEW_INLINE Vec<Pack, D> load(const double* from) {
    Vec<Pack, D> v;
    for (int c = 0; c < D; ++c) v[c] = Pack::load(from + lanes * c);
    return v;
  }
};

/// RadialWeight of all pairs of one kind in a lattice, with the vector at hand.
template <class T, int D, bool with_hourglass>
struct BondWeight {
  T gradient;
  Vec<T, D> gradient_vector;  ///< V_j a_ij X_ij [1/length]
  T hourglass = T(0.0);

  SINEW_INLINE const Vec<T, D>& vector(const Vec<T, D>&) const { return gradient_vector; }
  SINEW_INLINE const Vec<T, D>& force(const Vec<T, D>&) const { return gradient_vector; }
  SINEW_INLINE const T& hourglass_weight() const { return hourglass; }
  SINEW_INLINE BondWeight reversed() const { return {gradient, -gradient_vector, hourglass}; }
  SINEW_INLINE PackMask present() const { return gradient > T(0.0); }
  SINEW_INLINE BondWeight only(PackMask mask) const {
    BondWeight w{select(mask, gradient, T(0.0)), {}, with_hourglass ? select(mask, hourglass, T(0.0)) : T(0.0)};
    for (int c = 0; c < D; ++c) w.gradient_vector[c] = select(mask, gradient_vector[c], T(0.0));
    return w;
  }
};

/// RadialWeight from the reference configuration. Where r = 0 (the fill of a pair list) it is 0.
template <class Kernel, bool with_hourglass, int D, class T>
SINEW_INLINE RadialWeight<T, with_hourglass> radial_weight(const Vec<T, D>& X, const T& volume, const T& radius) {
  const T r2 = dot(X, X);
  const auto apart = r2 > T(0.0);
  const T inverse_r = inverse_sqrt(select(apart, r2, radius * radius));
  const T r = r2 * inverse_r;
  RadialWeight<T, with_hourglass> w{select(apart, -volume * Kernel::template slope<D>(r, radius) * inverse_r, T(0.0))};
  if constexpr (with_hourglass)
    w.hourglass = select(apart, volume * Kernel::template value<D>(r, radius) * (inverse_r * inverse_r), T(0.0));
  return w;
}

}  // namespace sinew
