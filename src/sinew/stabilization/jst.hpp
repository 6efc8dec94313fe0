#pragma once

#include <cmath>
#include <sinew/core/pack.hpp>
#include <sinew/core/params.hpp>
#include <sinew/core/vec.hpp>
#include <string_view>

namespace sinew {

/// Dissipation after Jameson, Schmidt and Turkel, of the velocities:
///
///     f_i = rho_0 V_i (eta2 c h lap v - eta4 c h^3 lap(lap v))_i,   (lap v)_i = sum_j w_ij (v_j - v_i),   w_ij = V_j 2 C a_ij,   C = D / max_k tr M_k
///
/// c = sqrt((lambda + 2 mu) / rho_0), h the smallest smoothing length of the body (the kernel radius over R / h as customary for the kernel), a_ij = |dW/dr| / r. M as for the
/// correction "gradient": with C the Laplacian of |X|^2 is exact inside of a lattice. V_i w_ij is symmetric, so linear momentum is conserved, and both terms take energy. The second
/// derivative of the kernel would not do: on short waves its sign is the wrong one. At surfaces this Laplacian does not vanish for a field that is linear, and would brake rotations.
/// "corrected", the default, counts what the gradients of both ends do not explain,
///
///     (lap v)_i = sum_j w_ij (v_j - v_i - (grad v_i + grad v_j) X_ij / 2),
///
/// for eta2, and for the inner one of eta4. Momentum is conserved as before. Brookshaw (1985); Jameson, Schmidt & Turkel (1981); Wiragunarsa et al. (2024), eq. 25-28.
struct JstDissipation {
  static constexpr std::string_view name = "jst";
  static constexpr std::string_view summary = "Jameson-Schmidt-Turkel dissipation: harmonic and biharmonic damping of velocities";
  static constexpr std::string_view source = "Wiragunarsa et al. (2024), eq. 25-28; Brookshaw (1985)";
  static constexpr bool in_reference = true, in_current = false;  ///< configurations for which it is made

  double eta2 = 0.0, eta4 = 1.0 / 64.0;
  Choice laplacian{"corrected", {"corrected", "plain"}};

  static void describe(auto&& field, auto& m) {
    field("eta2", m.eta2, "1", "Coefficient of the harmonic term. From 0.01 on it lowers the order of convergence.", non_negative,
          optional);
    field("eta4", m.eta4, "1",
          "Coefficient of the biharmonic term; the default is for a smoothing length of 1.2 spacings, 0.0625 is for 2.",
          non_negative, optional);
    field("laplacian", m.laplacian, "1",
          "corrected: leaves linear fields of velocities alone, rotations above all; plain: brakes them at surfaces, and costs "
          "less.",
          any_number, optional);
  }

  bool corrected() const { return laplacian.value == "corrected"; }

  /// f = rho_0 V (harmonic lap v - biharmonic lap(lap v)).
  struct Coefficients {
    double harmonic = 0.0;    ///< eta2 c h [length^2/time]
    double biharmonic = 0.0;  ///< eta4 c h^3 [length^4/time]

    /// Fastest damping, where -lap has the eigenvalues 0 to `most` [1/length^2].
    SINEW_INLINE double rate(double most) const { return (harmonic + biharmonic * most) * most; }
  };
  /// c: wave speed, h: smoothing length.
  Coefficients coefficients(double c, double h) const { return {eta2 * c * h, eta4 * c * h * h * h}; }
};

}  // namespace sinew
