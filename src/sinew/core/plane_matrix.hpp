#pragma once
/// Matrices of plane states. In two dimensions F13, F23, F31 and F32 are zero, and so they are in all that isotropic materials make of F; a
/// compiler may not drop a product with a zero that it cannot see. PlaneMatrix has the vocabulary of Mat<T, 3>, so that a formula written
/// for a matrix type M holds for both.

#include <sinew/core/vec.hpp>

namespace sinew {

/// The 3 x 3 matrix with `in_plane` in its upper left, `out_of_plane` as component 33 and zeros elsewhere.
template <class T>
struct PlaneMatrix {
  Mat<T, 2> in_plane{};
  T out_of_plane{};

  static SINEW_INLINE PlaneMatrix identity() { return {Mat<T, 2>::identity(), T(1.0)}; }

  SINEW_INLINE PlaneMatrix& operator+=(const PlaneMatrix& b) { return *this = *this + b; }
  SINEW_INLINE PlaneMatrix& operator-=(const PlaneMatrix& b) { return *this = *this - b; }
  friend SINEW_INLINE PlaneMatrix operator+(const PlaneMatrix& a, const PlaneMatrix& b) {
    return {a.in_plane + b.in_plane, a.out_of_plane + b.out_of_plane};
  }
  friend SINEW_INLINE PlaneMatrix operator-(const PlaneMatrix& a, const PlaneMatrix& b) {
    return {a.in_plane - b.in_plane, a.out_of_plane - b.out_of_plane};
  }
  friend SINEW_INLINE PlaneMatrix operator*(const T& s, const PlaneMatrix& a) { return {s * a.in_plane, s * a.out_of_plane}; }
  friend SINEW_INLINE PlaneMatrix operator*(const PlaneMatrix& a, const PlaneMatrix& b) {
    return {a.in_plane * b.in_plane, a.out_of_plane * b.out_of_plane};
  }
};

template <class T>
SINEW_INLINE PlaneMatrix<T> transpose(const PlaneMatrix<T>& a) {
  return {transpose(a.in_plane), a.out_of_plane};
}

template <class T>
SINEW_INLINE T trace(const PlaneMatrix<T>& a) {
  return trace(a.in_plane) + a.out_of_plane;
}

/// a : b, the sum of a_ij b_ij.
template <class T>
SINEW_INLINE T double_dot(const PlaneMatrix<T>& a, const PlaneMatrix<T>& b) {
  return double_dot(a.in_plane, b.in_plane) + a.out_of_plane * b.out_of_plane;
}

template <class T>
SINEW_INLINE T determinant(const PlaneMatrix<T>& a) {
  return determinant(a.in_plane) * a.out_of_plane;
}

/// cof A = det(A) A^-T.
template <class T>
SINEW_INLINE PlaneMatrix<T> cofactor(const PlaneMatrix<T>& a) {
  return {a.out_of_plane * cofactor(a.in_plane), determinant(a.in_plane)};
}

/// Inverse by cofactors; the caller makes sure that the determinant is not zero.
template <class T>
SINEW_INLINE PlaneMatrix<T> inverse(const PlaneMatrix<T>& a) {
  return (T(1.0) / determinant(a)) * transpose(cofactor(a));
}

/// The same matrix with all nine components.
template <class T>
SINEW_INLINE Mat3<T> in_space(const PlaneMatrix<T>& a) {
  return embed(a.in_plane, a.out_of_plane);
}

/// The upper left 2 x 2 part, as of a 3 x 3 matrix.
template <int D, class T>
SINEW_INLINE Mat<T, D> in_plane(const PlaneMatrix<T>& a) {
  return a.in_plane;
}

/// The type of the entries of a Mat or PlaneMatrix.
template <class M>
using ScalarOf = decltype(trace(M{}));

}  // namespace sinew
