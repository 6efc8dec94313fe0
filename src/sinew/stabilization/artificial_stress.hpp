#pragma once

#include <limits>
#include <sinew/core/pack.hpp>
#include <sinew/core/params.hpp>
#include <sinew/core/spectral.hpp>
#include <sinew/core/vec.hpp>
#include <string_view>

namespace sinew {

/// A repulsion between particles under tension, along the principal stresses that pull:
///
///     a_i += sum_j m_j (R_i + R_j) (W_ij / W(d))^n grad_i W_ij,   R_a = -epsilon max(sigma_a, 0) / rho^2 in the principal axes of sigma
///
/// d: particle spacing. In two dimensions those of the plane. For the formulation on the current configuration only. Gray, Monaghan & Swift (2001).
struct ArtificialStress {
  static constexpr std::string_view name = "artificial_stress";
  static constexpr std::string_view summary = "Repulsion under tension along principal stresses (current configuration only)";
  static constexpr std::string_view source = "Gray, Monaghan & Swift (2001)";
  static constexpr bool in_reference = false, in_current = true;  ///< configurations for which it is made

  double epsilon = 0.3, exponent = 4.0;

  static void describe(auto&& field, auto& m) {
    field("epsilon", m.epsilon, "1", "Part of the tension that becomes repulsion.", non_negative, optional);
    field("exponent", m.exponent, "1", "Exponent n of the weight.", positive, optional);
  }

  /// R, what goes into the momentum equation beside sigma / rho^2, times (W_ij / W(d))^n. `stress`: symmetric.
  template <class T>
  SINEW_INLINE Mat<T, 3> repulsion(const Mat<T, 3>& stress, const T& /*mean_stress*/, const T& specific_volume) const {
    const Spectrum<Mat<T, 3>> s = spectrum(stress);
    return compose(s.directions, pulls(s.values, specific_volume));
  }
  template <class T>
  SINEW_INLINE Mat<T, 2> repulsion(const Mat<T, 2>& stress, const T& /*mean_stress*/, const T& specific_volume) const {
    const Spectrum<PlaneMatrix<T>> s = spectrum(PlaneMatrix<T>{stress, T(0.0)});
    return compose(s.directions, pulls(s.values, specific_volume)).in_plane;
  }

 private:
  template <class T>
  SINEW_INLINE Vec3<T> pulls(const Vec3<T>& stresses, const T& specific_volume) const {
    Vec3<T> R;
    for (int a = 0; a < 3; ++a) R[a] = T(-epsilon) * max(stresses[a], T(0.0)) * specific_volume * specific_volume;
    return R;
  }
};

}  // namespace sinew
