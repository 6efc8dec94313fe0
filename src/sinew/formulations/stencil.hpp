#pragma once
/// A particle with its neighbors: how their displacements enter its deformation gradient and its hourglass stiffness, and the stiffness that follows. For implicit solvers that assemble a matrix.

#include <sinew/particles/vector_field.hpp>
#include <vector>

namespace sinew {

/// The particle stands first, then its neighbors.
template <int D>
struct Stencil {
  std::vector<int> slots;
  std::vector<Vec<double, D>> X;         ///< from the particle [length]
  std::vector<Vec<double, D>> gradient;  ///< (F - I)_aB = sum_n u_a gradient_B [1/length]; they add up to zero
  std::vector<double>
      hourglass;  ///< weights of the hourglass stiffness of each pair, over that of the particle [1/length^2]; empty: none

  void clear() {
    slots.clear();
    X.clear();
    gradient.clear();
    hourglass.clear();
  }
  int size() const { return static_cast<int>(slots.size()); }
  /// F - I, if the field is the displacements.
  Mat<double, D> gradient_of(const VectorField<D>& field) const {
    Mat<double, D> sum{};
    for (int n = 0; n < size(); ++n) sum += outer(field[slots[n]], gradient[n]);
    return sum;
  }
};

/// Derivative of minus the forces that a particle gives to itself and to its neighbors, with respect to the displacements of all of them. With A = dP/dF, V the volume times the thickness,
/// k_n the stiffness and X_n of each pair, indices m and n over the stencil and c, e over the axes,
///
///     K_mc,ne = V gradient_mJ A_cJeL gradient_nL + delta_ce H_mn,     H_mn = sum_p k_p (delta_mp - delta_m0) (delta_np - delta_n0 - gradient_n.X_p)
///
/// Ren et al. (2020), eq. 29 and 40-43; the factor 2 that is missing in their eq. 29 is in k. H is symmetric with the gradient correction.
template <int D>
class NodalStiffness {
 public:
  /// Row-major, D numbers a particle of the stencil.
  const std::vector<double>& of(const Stencil<D>& stencil, const Mat<double, D * D>& A, double volume, double stiffness) {
    size_ = stencil.size();
    matrix_.assign(static_cast<std::size_t>(size_) * size_ * D * D, 0.0);
    add_stress(stencil, A, volume);
    if (stiffness > 0.0 && !stencil.hourglass.empty()) add_hourglass(stencil, stiffness);
    return matrix_;
  }

 private:
  double& at(int m, int c, int n, int e) { return matrix_[(static_cast<std::size_t>(D) * m + c) * D * size_ + D * n + e]; }

  void add_stress(const Stencil<D>& stencil, const Mat<double, D * D>& A, double volume) {
    for (int n = 0; n < size_; ++n) {
      Mat<double, D> stress[D];  // of a unit displacement of n along each axis, times the volume
      for (int e = 0; e < D; ++e)
        for (int c = 0; c < D; ++c)
          for (int J = 0; J < D; ++J)
            for (int L = 0; L < D; ++L) stress[e][c][J] += volume * A[D * c + J][D * e + L] * stencil.gradient[n][L];
      for (int m = 0; m < size_; ++m)
        for (int e = 0; e < D; ++e) {
          const Vec<double, D> force = stress[e] * stencil.gradient[m];
          for (int c = 0; c < D; ++c) at(m, c, n, e) += force[c];
        }
    }
  }

  void add_hourglass(const Stencil<D>& stencil, double stiffness) {
    for (int p = 1; p < size_; ++p) {
      const double k = stiffness * stencil.hourglass[p];
      for (int n = 0; n < size_; ++n) {
        const double share = k * ((n == p) - (n == 0) - dot(stencil.gradient[n], stencil.X[p]));
        for (int c = 0; c < D; ++c) {
          at(p, c, n, c) += share;
          at(0, c, n, c) -= share;
        }
      }
    }
  }

  int size_ = 0;
  std::vector<double> matrix_;
};

}  // namespace sinew
