#pragma once

#include <limits>
#include <sinew/core/pack.hpp>
#include <sinew/core/params.hpp>
#include <sinew/core/vec.hpp>
#include <string_view>

namespace sinew {

/// A repulsion between particles under tension, against the clumping of conventional SPH:
///
///     a_i -= sum_j m_j gamma (p_i / rho_i^2 + p_j / rho_j^2) (W_ij / W(d))^n grad_i W_ij,   p = max(tr(sigma) / 3, 0)
///
/// d: particle spacing. For the formulation on the current configuration only. Monaghan (2000); Islam & Peng (2019), eq. 24.
struct ArtificialPressure {
  static constexpr std::string_view name = "artificial_pressure";
  static constexpr std::string_view summary = "Repulsion under tension by an isotropic pressure (current configuration only)";
  static constexpr std::string_view source = "Monaghan (2000); Islam & Peng (2019), eq. 24";
  static constexpr bool in_reference = false, in_current = true;  ///< configurations for which it is made

  double gamma = 0.6;
  double exponent = std::numeric_limits<double>::quiet_NaN();

  static void describe(auto&& field, auto& m) {
    field("gamma", m.gamma, "1", "Part of the tension that becomes repulsion.", non_negative, optional);
    field("exponent", m.exponent, "1", "Exponent n of the weight; W(0) / W(d) if not given.", positive, optional);
  }

  /// R, what goes into the momentum equation beside sigma / rho^2, times (W_ij / W(d))^n.
  template <class T, int D>
  SINEW_INLINE Mat<T, D> repulsion(const Mat<T, D>& /*in_plane*/, const T& mean_stress, const T& specific_volume) const {
    return (T(-gamma) * max(mean_stress, T(0.0)) * specific_volume * specific_volume) * Mat<T, D>::identity();
  }
};

}  // namespace sinew
