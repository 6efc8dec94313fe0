#pragma once

#include <sinew/corrections/correction.hpp>

namespace sinew {

/// The kernel that is corrected to be exact for linear fields, and its exact gradient. With y = X_i - X_j and sums over all j with i itself,
///
///     m0 = sum V_j W_ij;   m1 = sum V_j W_ij y;   m2 = sum V_j W_ij y (x) y;   beta = -m2^-1 m1;   alpha = 1 / (m0 + beta.m1)
///     W1_ij = W_ij alpha (1 + beta.y):   sum V_j W1_ij = 1,   sum V_j W1_ij X_j = X_i
///     d_g W1_ij = alpha (1 + beta.y) d_g W_ij + W_ij [d_g alpha (1 + beta.y) + alpha (beta_g + y.d_g beta)]
///
/// so that sum V_j X_ij (x) g_ij = I and sum V_j g_ij = 0 with i itself, whose own gradient is not zero near surfaces. Liu, Jun & Zhang (1995); Bonet &
/// Kulasegaram (2000); Wiragunarsa et al. (2024), eq. 6-8 and appendix A. The kernel may be negative near surfaces.
struct LinearCorrection {
  static constexpr std::string_view name = "linear";
  static constexpr std::string_view summary = "Kernel corrected to be exact for linear fields, and its exact gradient";
  static constexpr std::string_view source = "Liu, Jun & Zhang (1995); Wiragunarsa et al. (2024), eq. 6-8, appendix A";
  static constexpr bool radial = false, higher_moments = true;
  static void describe(auto&&, auto&) {}

  template <int D>
  SINEW_POINTWISE GradientMap<D> map(const Moments<D>& moments) const {
    GradientMap<D> map;
    map.valid = roundness(moments.kernel_second) > flattest_moment;
    if (!map.valid) return map;
    const double m0 = moments.shepard_sum;
    const Vec<double, D> m1 = -moments.kernel_first;
    const Mat<double, D> inverse_m2 = inverse(moments.kernel_second);
    const Vec<double, D> beta = -(inverse_m2 * m1);
    const double alpha = 1.0 / (m0 + dot(beta, m1));
    map.valid = alpha > 0.0;
    map.scale = map.kernel_scale = alpha;
    map.tilt = -alpha * beta;
    for (int g = 0; g < D; ++g) {
      Vec<double, D> axis{}, d_m1{};
      axis[g] = 1.0;
      for (int k = 0; k < D; ++k) d_m1[k] = m0 * axis[k] - moments.first[k][g];
      const Mat<double, D> d_m2 = moments.second[g] + outer(m1, axis) + outer(axis, m1);
      const Vec<double, D> d_beta = inverse_m2 * (d_m2 * (inverse_m2 * m1) - d_m1);
      const double d_alpha = -alpha * alpha * (moments.gradient_sum[g] + dot(d_beta, m1) + dot(beta, d_m1));
      map.shift[g] = -(d_alpha + alpha * beta[g]);
      for (int k = 0; k < D; ++k) map.bend[g][k] = d_alpha * beta[k] + alpha * d_beta[k];
    }
    return map;
  }
};

}  // namespace sinew
