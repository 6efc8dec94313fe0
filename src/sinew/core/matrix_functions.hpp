#pragma once
/// Logarithm and exponential of symmetric matrices, as plasticity at finite strain needs them: of the part that keeps the volume.
///
/// For a traceless X a power series is three numbers, since X^3 = I3 - I2 X (Cayley-Hamilton) with I2 = -X:X / 2 and I3 = det X: with s_k a coefficient,
/// Horner's rule turns (a, b, c), which means a + b X + c X^2, into (s_k + c I3, a - c I2, b). No division, no iteration, nothing ill-conditioned for
/// equal eigenvalues. It is used up to eigenvalues of 0.06, where the series are exact to rounding; beyond, the spectrum is.

#include <sinew/core/spectral.hpp>

namespace sinew {

namespace detail {
inline constexpr double most_of_series = 0.06;  ///< largest eigenvalue

/// Whether all eigenvalues of a traceless matrix with that X:X are small enough.
template <class T>
SINEW_INLINE auto series_holds(const T& square) {
  return square <= T(1.5 * most_of_series * most_of_series);  // the largest eigenvalue is at most sqrt(2/3) |X|
}

/// b X + c X^2, the power series without its constant, whose coefficients are coefficient(1) ... coefficient(degree).
template <int degree, class M, class Coefficient>
SINEW_INLINE M series(const M& X, const M& X2, const ScalarOf<M>& square, Coefficient&& coefficient, ScalarOf<M>& constant) {
  using T = ScalarOf<M>;
  const T I2 = T(-0.5) * square, I3 = determinant(X);
  T a(coefficient(degree)), b(0.0), c(0.0);
  for (int k = degree - 1; k >= 0; --k) {
    const T previous = a;
    a = T(coefficient(k)) + c * I3;
    const T next = previous - c * I2;
    c = b;
    b = next;
  }
  constant = a;
  return b * X + c * X2;
}

/// Entries of one where the mask is true, of the other elsewhere.
template <class Mask, class T, int D>
SINEW_INLINE Mat<T, D> select(const Mask& mask, const Mat<T, D>& yes, const Mat<T, D>& no) {
  Mat<T, D> m;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) m[i][j] = sinew::select(mask, yes[i][j], no[i][j]);
  return m;
}
template <class Mask, class T>
SINEW_INLINE PlaneMatrix<T> select(const Mask& mask, const PlaneMatrix<T>& yes, const PlaneMatrix<T>& no) {
  return {select(mask, yes.in_plane, no.in_plane), sinew::select(mask, yes.out_of_plane, no.out_of_plane)};
}
}  // namespace detail

/// Entries of one matrix where the mask is true, of the other elsewhere.
template <class Mask, class M>
SINEW_INLINE M select_matrix(const Mask& mask, const M& yes, const M& no) {
  return detail::select(mask, yes, no);
}

/// Deviator of ln(a), a symmetric and positive definite: the same for every multiple of a.
template <class M>
SINEW_INLINE M deviator_of_log(const M& a) {
  using std::log;
  using T = ScalarOf<M>;
  const M I = M::identity();
  const M X = (T(3.0) / trace(a)) * a - I, X2 = X * X;
  const T square = trace(X2);
  T constant;
  M result = detail::series<12>(
      X, X2, square, [](int k) { return k == 0 ? 0.0 : (k % 2 == 1 ? 1.0 : -1.0) / k; }, constant);
  result = result - (T(1.0 / 3.0) * trace(result)) * I;
  const auto small = detail::series_holds(square);
  if (all(small)) return result;
  const Spectrum<M> s = spectrum(a);
  Vec3<T> logs{{log(s.values[0]), log(s.values[1]), log(s.values[2])}};
  const T mean = T(1.0 / 3.0) * (logs[0] + logs[1] + logs[2]);
  for (int k = 0; k < 3; ++k) logs[k] -= mean;
  return select_matrix(small, result, compose(s.directions, logs));
}

/// exp(X), X symmetric and traceless: of determinant 1.
template <class M>
SINEW_INLINE M exp_of_deviator(const M& X) {
  using std::exp;
  using T = ScalarOf<M>;
  const M X2 = X * X;
  const T square = trace(X2);
  T constant;
  M result = detail::series<9>(
      X, X2, square,
      [](int k) {
        double factorial = 1.0;
        for (int n = 2; n <= k; ++n) factorial *= n;
        return 1.0 / factorial;
      },
      constant);
  result += constant * M::identity();
  const auto small = detail::series_holds(square);
  if (all(small)) return result;
  const Spectrum<M> s = spectrum(X);
  return select_matrix(small, result, compose(s.directions, Vec3<T>{{exp(s.values[0]), exp(s.values[1]), exp(s.values[2])}}));
}

}  // namespace sinew
