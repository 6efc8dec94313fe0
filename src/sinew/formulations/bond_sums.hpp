#pragma once
/// Sums over the bonds of a particle, at a point: their average gradient, and what its stress makes of it. For ListedPairs::first_visit_with.

#include <sinew/core/pack.hpp>
#include <sinew/core/vec.hpp>
#include <sinew/particles/rows.hpp>

namespace sinew {

/// The average of the gradients of bonds, of displacements: with b_ij = V_j W1_ij / r_ij^2 and G = F - I,
///
///     F_i - I = G_i K_i + sum_j b_ij (r_ij^2 G_j / 2 + (u_ij - G_j X_ij / 2) (x) X_ij)
template <int D>
struct GradientOfBonds {
  Mat<Pack, D> sum;  ///< begins as G_i K_i

  template <class Weight, class Matrix>
  SINEW_INLINE void operator()(const Weight& weight, const Vec<Pack, D>& u, const Vec<Pack, D>& X, const Matrix& G_j) {
    const Pack b = weight.average(), half = 0.5 * b, along = half * dot(X, X);
    for (int r = 0; r < D; ++r) {
      const Vec<Pack, D> G = G_j.row(r);
      const Pack pull = b * u[r] - half * dot(G, X);
      for (int c = 0; c < D; ++c) sum[r][c] += along * G[c] + pull * X[c];
    }
  }
};

/// How the stress of these averages pulls at the gradients that they average: with A = V P and b_ij = V_i W1_ji / r_ij^2,
///
///     Q_i = A_i K_i + sum_j b_ij (r_ij^2 A_j - A_j X_ij (x) X_ij) / 2
template <int D>
struct StressOfBonds {
  Mat<Pack, D> sum;  ///< begins as A_i K_i

  template <class Weight, class Matrix>
  SINEW_INLINE void operator()(const Weight& weight, const Vec<Pack, D>&, const Vec<Pack, D>& X, const Matrix& A_j) {
    const Pack half = 0.5 * weight.average(), along = half * dot(X, X);
    for (int r = 0; r < D; ++r) {
      const Vec<Pack, D> A = A_j.row(r);
      const Pack pull = half * dot(A, X);
      for (int c = 0; c < D; ++c) sum[r][c] += along * A[c] - pull * X[c];
    }
  }
};

}  // namespace sinew
