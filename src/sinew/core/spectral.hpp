#pragma once
/// Principal values and directions of symmetric matrices, and isotropic functions of them.

#include <sinew/core/pack.hpp>
#include <sinew/core/plane_matrix.hpp>

namespace sinew {

/// a = sum_k values[k] n_k (x) n_k; n_k is column k of `directions`, an orthogonal matrix. In no order.
template <class M>
struct Spectrum {
  Vec3<ScalarOf<M>> values;
  M directions;
};

/// Tangent, cosine and sine of the rotation that makes the off-diagonal entry of {{app, apq}, {apq, aqq}} vanish.
template <class T>
struct JacobiRotation {
  T tangent, cosine, sine;

  SINEW_INLINE JacobiRotation(const T& app, const T& apq, const T& aqq) {
    using std::sqrt;
    const T difference = aqq - app, twice = T(2.0) * apq;
    const T size = sqrt(difference * difference + twice * twice) + T(1e-300);
    tangent = select(difference < T(0.0), -twice, twice) / (max(difference, -difference) + size);
    cosine = inverse_sqrt(T(1.0) + tangent * tangent);
    sine = tangent * cosine;
  }
};

namespace detail {
template <int p, int q, class T>
SINEW_INLINE void jacobi_step(Mat3<T>& a, Mat3<T>& directions) {
  constexpr int r = 3 - p - q;
  const JacobiRotation<T> turn(a[p][p], a[p][q], a[q][q]);
  const T shift = turn.tangent * a[p][q], arp = a[r][p], arq = a[r][q];
  a[p][p] -= shift;
  a[q][q] += shift;
  a[p][q] = a[q][p] = T(0.0);
  a[r][p] = a[p][r] = turn.cosine * arp - turn.sine * arq;
  a[r][q] = a[q][r] = turn.sine * arp + turn.cosine * arq;
  for (int i = 0; i < 3; ++i) {
    const T dp = directions[i][p], dq = directions[i][q];
    directions[i][p] = turn.cosine * dp - turn.sine * dq;
    directions[i][q] = turn.sine * dp + turn.cosine * dq;
  }
}
}  // namespace detail

/// By Jacobi's rotations, cyclic, until all that is off the diagonal is below rounding of the largest entry. Accurate also for equal values.
/// Golub & Van Loan (2013), sec. 8.5.
template <class T>
SINEW_INLINE Spectrum<Mat3<T>> spectrum(Mat3<T> a) {
  constexpr int most_sweeps = 8;
  constexpr double negligible = 1e-17;
  Mat3<T> directions = Mat3<T>::identity();
  const T size2 = double_dot(a, a);
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    const T off2 = a[0][1] * a[0][1] + a[0][2] * a[0][2] + a[1][2] * a[1][2];
    if (!any(off2 > T(negligible * negligible) * size2)) break;
    detail::jacobi_step<0, 1>(a, directions);
    detail::jacobi_step<0, 2>(a, directions);
    detail::jacobi_step<1, 2>(a, directions);
  }
  return {{{a[0][0], a[1][1], a[2][2]}}, directions};
}

/// In closed form: one rotation in the plane.
template <class T>
SINEW_INLINE Spectrum<PlaneMatrix<T>> spectrum(const PlaneMatrix<T>& a) {
  const Mat<T, 2>& plane = a.in_plane;
  const JacobiRotation<T> turn(plane[0][0], plane[0][1], plane[1][1]);
  const T shift = turn.tangent * plane[0][1];
  return {{{plane[0][0] - shift, plane[1][1] + shift, a.out_of_plane}},
          {{{{turn.cosine, turn.sine}, {-turn.sine, turn.cosine}}}, T(1.0)}};
}

/// sum_k values[k] n_k (x) n_k.
template <class T>
SINEW_INLINE Mat3<T> compose(const Mat3<T>& directions, const Vec3<T>& values) {
  Mat3<T> a;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) {
      T sum = values[0] * directions[i][0] * directions[j][0];
      for (int k = 1; k < 3; ++k) sum = sum + values[k] * directions[i][k] * directions[j][k];
      a[i][j] = a[j][i] = sum;
    }
  return a;
}
template <class T>
SINEW_INLINE PlaneMatrix<T> compose(const PlaneMatrix<T>& directions, const Vec3<T>& values) {
  const T c = directions.in_plane[0][0], s = directions.in_plane[0][1];
  const T mixed = c * s * (values[1] - values[0]);
  return {{{{c * c * values[0] + s * s * values[1], mixed}, {mixed, s * s * values[0] + c * c * values[1]}}}, values[2]};
}

}  // namespace sinew
