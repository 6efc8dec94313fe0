#pragma once

#include <sinew/corrections/correction.hpp>

namespace sinew {

/// g_ij = M_i^-1 (a_ij X_ij), M_i = sum V_j a_ij X_ij (x) X_ij: the gradient of every linear field is exact, since
/// sum V_j X_ij (x) g_ij = I. Randles & Libersky (1996); Bonet & Lok (1999); Ganzenmueller (2015), eq. 14-16.
///
/// A plane surface of a lattice has a roundness of M_i of about 0.5.
struct GradientCorrection {
  static constexpr std::string_view name = "gradient";
  static constexpr std::string_view summary = "Corrected gradient: exact for linear fields";
  static constexpr std::string_view source = "Randles & Libersky (1996); Bonet & Lok (1999); Ganzenmueller (2015), eq. 14-16";
  static constexpr bool radial = true, higher_moments = false;
  static void describe(auto&&, auto&) {}

  template <int D>
  SINEW_POINTWISE GradientMap<D> map(const Moments<D>& moments) const {
    GradientMap<D> map;
    map.kernel_scale = partition_of_unity(moments);
    map.valid = roundness(moments.first) > flattest_moment;
    if (map.valid) map.L = inverse(moments.first);
    return map;
  }
};

}  // namespace sinew
