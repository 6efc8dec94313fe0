#pragma once

#include <sinew/corrections/shepard.hpp>

namespace sinew {

/// The gradient of the Shepard kernel, g0_ij, corrected to be exact for linear fields: g_ij = M_i^-T g0_ij with M_i = sum V_j X_ij (x) g0_ij. Since sum V_j g_ij = 0
/// with the particle itself, sums need no differences. The kernel and gradient of order zero of Wiragunarsa et al. (2024), eq. 10-14.
struct MixedCorrection {
  static constexpr std::string_view name = "mixed";
  static constexpr std::string_view summary =
      "The gradient of the normalized kernel, corrected: exact for linear fields, without differences";
  static constexpr std::string_view source = "Bonet & Kulasegaram (2000); Wiragunarsa et al. (2024), eq. 10-14";
  static constexpr bool radial = false, higher_moments = true;
  static void describe(auto&&, auto&) {}

  template <int D>
  SINEW_POINTWISE GradientMap<D> map(const Moments<D>& moments) const {
    const GradientMap<D> shepard = ShepardCorrection{}.map(moments);
    const Mat<double, D> M = shepard.scale * moments.first - outer(moments.kernel_first, shepard.shift);
    GradientMap<D> map = shepard;
    map.valid = shepard.valid && roundness(M) > flattest_moment;
    if (!map.valid) return map;
    map.L = transpose(inverse(M));
    map.shift = map.L * shepard.shift;
    return map;
  }
};

}  // namespace sinew
