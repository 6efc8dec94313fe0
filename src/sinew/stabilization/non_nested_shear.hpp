#pragma once

#include <cmath>
#include <limits>
#include <sinew/core/pack.hpp>
#include <sinew/core/params.hpp>
#include <sinew/core/vec.hpp>
#include <string_view>

namespace sinew {

/// Shear from a Laplacian of the motion itself instead of a divergence of gradients, which do not see what alternates from particle to particle:
///
///     d a_i / dt = sum_j 2 zeta (G / rho)_ij (e_ij . x_ij / |x_ij|^2) V_j grad_i W_ij,   x_ij = x_j - x_i
///
/// a_i is a vector that every particle keeps. "printed": e_ij = v_j - v_i, and the stress is the pressure alone; zeta = 0.7 D + 2.1 by default. "objective": all of the stress
/// remains, e_ij = v_j - v_i - (L_i + L_j) x_ij / 2 is what the velocity gradients L of both ends do not explain, a_i turns with the material, and G falls as the material
/// flows; zeta = 1 by default. Zhang et al. (2024); the generalized form after
/// Zhang, Hu & coworkers (arXiv 2409.11474).
///
/// With total_lagrangian, the shear force G x_ij of a pair in the place of G F_i X_ij from the gradient: what it has beyond that is a stiffness against x_ij - F_i X_ij,
///
///     f = zeta G V_i V_j a_ij (x_ij - F_i X_ij),   a_ij = |dW/dr| / r,   zeta = 1.07 by default
///
/// which is the conservative HourglassStiffness with alpha = 32 zeta D G / E, where sum_k V_k a_ik r_ik^2 = D as inside of a body. Wu et al. (2023), whose factor J^(-2/D) is left out; any material.
struct NonNestedShear {
  static constexpr std::string_view name = "non_nested_shear";
  static constexpr std::string_view summary = "Shear force without nested gradients, which sees zero-energy modes";
  static constexpr std::string_view source = "Zhang et al. (2024), J. Comput. Phys. 510, 113072; arXiv 2409.11474";
  static constexpr bool in_reference = true, in_current = true;  ///< configurations for which it is made

  double zeta = std::numeric_limits<double>::quiet_NaN();
  Choice form{"objective", {"objective", "printed"}};

  static void describe(auto&& field, auto& m) {
    field("zeta", m.zeta, "1",
          "Coefficient of the force; if not given 1.07 (total_lagrangian), 1 (objective), or 0.7 D + 2.1 (printed).",
          non_negative, optional);
    field("form", m.form, "1",
          "objective: beside the stress, against what velocity gradients do not explain, turning with the material; printed: all "
          "of "
          "the shear, as first published, for small rotations.",
          any_number, optional);
  }

  bool printed() const { return form.value == "printed"; }
  double coefficient(int dimension) const {
    if (!std::isnan(zeta)) return 2.0 * zeta;
    return printed() ? 2.0 * (0.7 * dimension + 2.1) : 2.0;
  }

  /// Of the hourglass stiffness that is this force in the reference configuration; `shear_share`: G / E.
  double alpha(int dimension, double shear_share) const {
    return 32.0 * (std::isnan(zeta) ? 1.07 : zeta) * dimension * shear_share;
  }

  /// What a pair adds to d(m a)/dt of i over the coefficient, G and both volumes. x: x_j - x_i; e: see above; weight: |dW/dr| / r; inverse_square: 1 / |x|^2.
  template <class T, int D>
  static SINEW_INLINE Vec<T, D> pull(const Vec<T, D>& x, const Vec<T, D>& e, const T& weight, const T& inverse_square) {
    return (weight * dot(e, x) * inverse_square) * x;
  }
};

}  // namespace sinew
