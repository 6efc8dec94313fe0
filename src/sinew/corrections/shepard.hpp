#pragma once

#include <sinew/corrections/correction.hpp>

namespace sinew {

/// The gradient of the Shepard kernel W_ij / S, S = sum V_j W_ij:  g_ij = a_ij X_ij / S - W_ij (sum_k V_k a_ik X_ik) / S^2.
/// Then sum V_j g_ij = 0 if the particle itself (X = 0, W = W(0)) is counted. Shepard (1968); Bonet & Kulasegaram (2000).
struct ShepardCorrection {
  static constexpr std::string_view name = "shepard";
  static constexpr std::string_view summary = "The gradient of the normalized kernel: exact for constants, without differences";
  static constexpr std::string_view source = "Shepard (1968); Bonet & Kulasegaram (2000)";
  static constexpr bool radial = false, higher_moments = false;
  static void describe(auto&&, auto&) {}

  template <int D>
  SINEW_POINTWISE GradientMap<D> map(const Moments<D>& moments) const {
    GradientMap<D> map;
    map.valid = moments.shepard_sum > 0.0;
    if (!map.valid) return map;
    map.scale = map.kernel_scale = 1.0 / moments.shepard_sum;
    map.shift = (map.scale * map.scale) * moments.gradient_sum;
    return map;
  }
};

}  // namespace sinew
