#pragma once
/// Small fixed-size vectors and matrices. `T` is double, Pack (one lane a particle) or Dual; `D` is 2 or 3.
/// Plain data: no allocation, no virtual call, everything inlines.

#include <array>
#include <cmath>
#include <sinew/core/device.hpp>

namespace sinew {

template <class T, int D>
struct Vec {
  T c[D]{};

  SINEW_INLINE T& operator[](int i) { return c[i]; }
  SINEW_INLINE const T& operator[](int i) const { return c[i]; }

  SINEW_INLINE Vec& operator+=(const Vec& b) {
    for (int i = 0; i < D; ++i) c[i] = c[i] + b.c[i];
    return *this;
  }
  SINEW_INLINE Vec& operator-=(const Vec& b) {
    for (int i = 0; i < D; ++i) c[i] = c[i] - b.c[i];
    return *this;
  }
  friend SINEW_INLINE Vec operator+(Vec a, const Vec& b) { return a += b; }
  friend SINEW_INLINE Vec operator-(Vec a, const Vec& b) { return a -= b; }
  friend SINEW_INLINE Vec operator*(const T& s, Vec a) {
    for (int i = 0; i < D; ++i) a.c[i] = s * a.c[i];
    return a;
  }
  friend SINEW_INLINE Vec operator-(Vec a) {
    for (int i = 0; i < D; ++i) a.c[i] = -a.c[i];
    return a;
  }
};

/// Row-major D x D matrix: m[i][j] is row i, column j.
template <class T, int D>
struct Mat {
  T m[D][D]{};

  SINEW_INLINE T* operator[](int i) { return m[i]; }
  SINEW_INLINE const T* operator[](int i) const { return m[i]; }

  static SINEW_INLINE Mat identity() {
    Mat a;
    for (int i = 0; i < D; ++i) a.m[i][i] = T(1.0);
    return a;
  }
  SINEW_INLINE Mat& operator+=(const Mat& b) {
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) m[i][j] = m[i][j] + b.m[i][j];
    return *this;
  }
  SINEW_INLINE Mat& operator-=(const Mat& b) {
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) m[i][j] = m[i][j] - b.m[i][j];
    return *this;
  }
  friend SINEW_INLINE Mat operator+(Mat a, const Mat& b) { return a += b; }
  friend SINEW_INLINE Mat operator-(Mat a, const Mat& b) { return a -= b; }
  friend SINEW_INLINE Mat operator*(const T& s, Mat a) {
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) a.m[i][j] = s * a.m[i][j];
    return a;
  }
  friend SINEW_INLINE Mat operator*(const Mat& a, const Mat& b) {
    Mat p;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) {
        T sum = a.m[i][0] * b.m[0][j];
        for (int k = 1; k < D; ++k) sum = sum + a.m[i][k] * b.m[k][j];
        p.m[i][j] = sum;
      }
    return p;
  }
  friend SINEW_INLINE Vec<T, D> operator*(const Mat& a, const Vec<T, D>& b) {
    Vec<T, D> p;
    for (int i = 0; i < D; ++i) {
      T sum = a.m[i][0] * b.c[0];
      for (int k = 1; k < D; ++k) sum = sum + a.m[i][k] * b.c[k];
      p.c[i] = sum;
    }
    return p;
  }
};

template <class T>
using Vec3 = Vec<T, 3>;
template <class T>
using Mat3 = Mat<T, 3>;
/// A place or direction as geometry and files see it: always three components, z = 0 in two dimensions.
using Point = Vec<double, 3>;

template <class T, int D>
SINEW_INLINE T dot(const Vec<T, D>& a, const Vec<T, D>& b) {
  T sum = a.c[0] * b.c[0];
  for (int i = 1; i < D; ++i) sum = sum + a.c[i] * b.c[i];
  return sum;
}

template <class T, int D>
SINEW_INLINE T norm(const Vec<T, D>& a) {
  using std::sqrt;
  return sqrt(dot(a, a));
}

template <class T>
SINEW_INLINE Vec3<T> cross(const Vec3<T>& a, const Vec3<T>& b) {
  return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}

/// a (x) b: component ij is a_i b_j.
template <class T, int D>
SINEW_INLINE Mat<T, D> outer(const Vec<T, D>& a, const Vec<T, D>& b) {
  Mat<T, D> p;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) p.m[i][j] = a.c[i] * b.c[j];
  return p;
}

template <class T, int D>
SINEW_INLINE Mat<T, D> transpose(const Mat<T, D>& a) {
  Mat<T, D> p;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) p.m[i][j] = a.m[j][i];
  return p;
}

template <class T, int D>
SINEW_INLINE T trace(const Mat<T, D>& a) {
  T sum = a.m[0][0];
  for (int i = 1; i < D; ++i) sum = sum + a.m[i][i];
  return sum;
}

/// a : b, the sum of a_ij b_ij.
template <class T, int D>
SINEW_INLINE T double_dot(const Mat<T, D>& a, const Mat<T, D>& b) {
  T sum = a.m[0][0] * b.m[0][0];
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j)
      if (i + j > 0) sum = sum + a.m[i][j] * b.m[i][j];
  return sum;
}

/// cof A = det(A) A^-T; for a deformation gradient H = dJ/dF.
template <class T>
SINEW_INLINE Mat<T, 3> cofactor(const Mat<T, 3>& a) {
  Mat<T, 3> h;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      h.m[i][j] = a.m[i1][j1] * a.m[i2][j2] - a.m[i1][j2] * a.m[i2][j1];
    }
  return h;
}
template <class T>
SINEW_INLINE Mat<T, 2> cofactor(const Mat<T, 2>& a) {
  Mat<T, 2> h;
  h.m[0][0] = a.m[1][1];
  h.m[0][1] = -a.m[1][0];
  h.m[1][0] = -a.m[0][1];
  h.m[1][1] = a.m[0][0];
  return h;
}

template <class T, int D>
SINEW_INLINE T determinant(const Mat<T, D>& a) {
  const Mat<T, D> h = cofactor(a);
  T sum = a.m[0][0] * h.m[0][0];
  for (int j = 1; j < D; ++j) sum = sum + a.m[0][j] * h.m[0][j];
  return sum;
}

/// Inverse by cofactors; the caller makes sure that the determinant is not zero.
template <class T, int D>
SINEW_INLINE Mat<T, D> inverse(const Mat<T, D>& a) {
  return (T(1.0) / determinant(a)) * transpose(cofactor(a));
}

/// A plane matrix in the upper left of a 3 x 3 one with `out_of_plane` as component 33 (plane strain: 1 for F).
template <class T, int D>
SINEW_INLINE Mat3<T> embed(const Mat<T, D>& a, const T& out_of_plane) {
  Mat3<T> b;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) b.m[i][j] = a.m[i][j];
  if constexpr (D == 2) b.m[2][2] = out_of_plane;
  return b;
}

/// The upper left D x D part of a 3 x 3 matrix.
template <int D, class T>
SINEW_INLINE Mat<T, D> in_plane(const Mat3<T>& a) {
  Mat<T, D> b;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) b.m[i][j] = a.m[i][j];
  return b;
}

}  // namespace sinew
