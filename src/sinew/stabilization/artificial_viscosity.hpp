#pragma once

#include <cmath>
#include <sinew/core/pack.hpp>
#include <sinew/core/params.hpp>
#include <sinew/core/vec.hpp>
#include <string_view>

namespace sinew {

/// Monaghan's viscosity between particles that come together, pulled back to the reference configuration:
///
///     pi_ij = (-alpha c mu + beta mu^2) / rho where mu = h v_ij.x_ij / (|x_ij|^2 + h^2/100) < 0, else 0;   Pi_ij = pi_ij (J_i F_i^-T + J_j F_j^-T) / 2
///     f_i = -sum_j m_i m_j Pi_ij g_ij
///
/// c = sqrt(E / rho_0), h half the kernel radius, rho that of each of the two halves. Each half belongs to one particle, so that linear momentum is conserved by construction; a half
/// that would give energy (its F turns x_ij by more than a right angle) is left out. Off unless asked for: it also damps what should not be damped.
/// Monaghan & Gingold (1983); Islam & Peng (2019), eq. 22-23 and 31, with F^-T in the place of the printed F^-1.
struct ArtificialViscosity {
  static constexpr std::string_view name = "artificial_viscosity";
  static constexpr std::string_view summary = "Monaghan's viscosity against shocks and ringing";
  static constexpr std::string_view source = "Monaghan & Gingold (1983); Islam & Peng (2019), eq. 22-23, 31";
  static constexpr bool in_reference = true, in_current = true;  ///< configurations for which it is made

  double alpha = 2.5, beta = 2.5;

  static void describe(auto&& field, auto& m) {
    field("alpha", m.alpha, "1", "Coefficient of the linear part.", non_negative, optional);
    field("beta", m.beta, "1", "Coefficient of the quadratic part, for shocks.", non_negative, optional);
  }

  /// mu [length/time], at most 0. x: x_j - x_i, v: v_j - v_i, h: smoothing length.
  template <class T, int D>
  static SINEW_INLINE T approach(const Vec<T, D>& x, const Vec<T, D>& v, const T& h) {
    return min(h * dot(v, x) / (dot(x, x) + T(0.01) * h * h + T(1e-200)), T(0.0));  // 0 for x = h = 0
  }
  /// rho pi [(length/time)^2].
  template <class T, class Speed>
  SINEW_INLINE T strength(const T& mu, const Speed& sound_speed) const {
    return mu * (T(beta) * mu - T(alpha * sound_speed));
  }
  /// How fast the force of a pair takes the motion along it away, over |H w X|: derivative of strength by v.x / |x| [1/time times length].
  template <class T, int D, class Speed>
  SINEW_INLINE T resistance(const Vec<T, D>& x, const T& mu, const T& h, const Speed& sound_speed) const {
    using std::sqrt;
    const T square = dot(x, x);
    return (T(alpha * sound_speed) - T(2.0 * beta) * mu) * h * sqrt(square) / (square + T(0.01) * h * h + T(1e-200));
  }
};

}  // namespace sinew
