#pragma once

#include <cmath>
#include <limits>
#include <sinew/core/params.hpp>
#include <string_view>

namespace sinew {

/// A quadratic energy of the part of a pair's motion that the deformation gradient does not see, with a modulus of its own:
///
///     E = sum_i V_i mu_p sum_j V_j w_ij |F_i X_ij - x_ij|^2,   w_ij = a_ij / sum_k V_k a_ik r_ik^2,   a_ij = |dW/dr| / r
///
/// Ren et al. (2020), eq. 21-29; mu_p is the "penalty" [Pa]. It is the conservative HourglassStiffness with alpha = 64 mu_p / E, and computed as that. It does not give way to
/// plastic flow or damage. With the gradient correction F_i minimizes the sum of i, so that the derivative through F_i vanishes; the tangent is constant, symmetric and zero for linear fields.
struct HourglassEnergy {
  static constexpr std::string_view name = "hourglass_energy";
  static constexpr std::string_view summary = "Quadratic energy against zero-energy modes, with a penalty modulus";
  static constexpr std::string_view source = "Ren et al. (2020), eq. 21-29";
  static constexpr bool in_reference = true, in_current = false;  ///< configurations for which it is made

  double penalty = std::numeric_limits<double>::quiet_NaN();

  static void describe(auto&& field, auto& m) {
    field("penalty", m.penalty, "Pa", "Modulus of the energy; the shear modulus of each body if not given.", non_negative,
          optional);
  }

  /// Of the hourglass stiffness that is this energy, for a material with these constants.
  double alpha(double youngs_modulus, double shear_modulus) const {
    return 64.0 * (std::isnan(penalty) ? shear_modulus : penalty) / youngs_modulus;
  }
};

}  // namespace sinew
