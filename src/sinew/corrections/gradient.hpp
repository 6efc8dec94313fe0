#pragma once

#include <sinew/corrections/correction.hpp>

namespace sinew {

/// g_ij = M_i^-1 (a_ij X_ij), M_i = sum V_j a_ij X_ij (x) X_ij: the gradient of every linear field is exact, since
/// sum V_j X_ij (x) g_ij = I. Randles & Libersky (1996); Bonet & Lok (1999); Ganzenmueller (2015), eq. 14-16.
///
/// M_i counts as singular when det M <= `singular_limit` (tr M / D)^D. The quotient is 1 for equal eigenvalues, about the ratio
/// of the smallest to the largest otherwise, and independent of units, spacing and kernel; a plane surface of a lattice has about
/// 0.5.
struct GradientCorrection {
  static constexpr std::string_view name = "gradient";
  static constexpr std::string_view summary = "Corrected gradient: exact for linear fields";
  static constexpr std::string_view source = "Randles & Libersky (1996); Bonet & Lok (1999); Ganzenmueller (2015), eq. 14-16";
  static constexpr bool radial = true;
  static constexpr double singular_limit = 1e-6;
  static void describe(auto&&, auto&) {}

  template <int D>
  SINEW_POINTWISE GradientMap<D> map(const Moments<D>& moments) const {
    const Mat<double, D>& M = moments.first;
    double isotropic = 1.0;
    for (int i = 0; i < D; ++i) isotropic *= trace(M) / D;
    GradientMap<D> map;
    map.valid = trace(M) > 0.0 && determinant(M) > singular_limit * isotropic;
    if (map.valid) map.L = inverse(M);
    return map;
  }
};

}  // namespace sinew
