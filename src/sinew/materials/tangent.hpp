#pragma once
/// Pieces of material tangents A = dP/dF, A_iJkL = dP_iJ / dF_kL, kept as a 9 x 9 matrix: row 3 i + J, column 3 k + L.

#include <sinew/core/vec.hpp>

namespace sinew {

template <class T>
using Tangent = Mat<T, 9>;

/// a (x) b: component iJkL is a_iJ b_kL.
template <class T>
SINEW_INLINE Tangent<T> dyad(const Mat3<T>& a, const Mat3<T>& b) {
  Tangent<T> A;
  for (int row = 0; row < 9; ++row)
    for (int column = 0; column < 9; ++column) A[row][column] = a[row / 3][row % 3] * b[column / 3][column % 3];
  return A;
}

/// d^2 J / dF dF: component iJkL is eps_ikm eps_JLN F_mN. Ren et al. (2020), eq. 58.
template <class T>
SINEW_INLINE Tangent<T> determinant_hessian(const Mat3<T>& F) {
  Tangent<T> A;
  for (int i = 0; i < 3; ++i)
    for (int J = 0; J < 3; ++J)
      for (int k = (i + 1) % 3; k != i; k = (k + 1) % 3)
        for (int L = (J + 1) % 3; L != J; L = (L + 1) % 3) {
          const T entry = F[3 - i - k][3 - J - L];
          const bool same_sense = ((k - i + 3) % 3 == 1) == ((L - J + 3) % 3 == 1);
          A[3 * i + J][3 * k + L] = same_sense ? entry : -entry;
        }
  return A;
}

}  // namespace sinew
