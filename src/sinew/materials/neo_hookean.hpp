#pragma once

#include <sinew/materials/material.hpp>

namespace sinew {

/// Compressible neo-Hookean solid: P = mu (F - F^-T) + lambda ln(J) F^-T, energy mu/2 (F:F - 3) - mu ln J + lambda/2 ln(J)^2.
/// Ganzenmueller (2015), eq. 44; Ren et al. (2020), eq. 59. Limits: J > 0 (NaN below); singular as J -> 0.
struct NeoHookean {
  static constexpr std::string_view name = "neo_hookean";
  static constexpr std::string_view summary = "Compressible neo-Hookean solid with a logarithmic volume term";
  static constexpr std::string_view source =
      "Ganzenmueller (2015), eq. 44; Ren et al. (2020), eq. 59; Bonet & Wood (2008), sec. 6.4.3";
  double density = 0.0;
  ElasticConstants elastic;

  static void describe(auto&& field, auto& m) {
    field("density", m.density, "kg/m^3", "Reference mass density.", positive);
    ElasticConstants::describe(field, m.elastic);
  }

  template <class M>
  SINEW_INLINE Response<M> respond(const M& F) const {
    using std::log;
    using T = ScalarOf<M>;
    const T lambda(elastic.lambda()), mu(elastic.mu());
    const M H = cofactor(F);
    const T J = determinant(F);
    const T log_J = log(J);
    Response<M> r;
    r.P = mu * F + ((lambda * log_J - mu) / J) * H;
    r.energy = T(0.5) * mu * (double_dot(F, F) - T(3.0)) + log_J * (T(0.5) * lambda * log_J - mu);
    return r;
  }

  /// A = mu I + ((lambda ln J - mu) / J) d^2J/dFdF + ((lambda + mu - lambda ln J) / J^2) H (x) H, H = cof F. The middle term with
  /// -mu is missing in Ren et al. (2020), eq. 61.
  template <class T>
  SINEW_POINTWISE Tangent<T> tangent(const Mat3<T>& F) const {
    using std::log;
    const T lambda(elastic.lambda()), mu(elastic.mu());
    const Mat3<T> H = cofactor(F);
    const T J = determinant(F);
    const T log_J = log(J);
    return mu * Tangent<T>::identity() + ((lambda * log_J - mu) / J) * determinant_hessian(F) +
           ((lambda + mu - lambda * log_J) / (J * J)) * dyad(H, H);
  }

  /// The acoustic tensor is mu I + (lambda + mu - lambda ln J) a (x) a, a = F^-T N; |a|^2 is at most the largest eigenvalue of
  /// C^-1.
  template <class M>
  SINEW_INLINE AcousticBound<ScalarOf<M>> acoustic_bound(const M& F) const {
    using std::log;
    using T = ScalarOf<M>;
    const T lambda(elastic.lambda()), mu(elastic.mu());
    return {mu, max(lambda + mu - lambda * log(determinant(F)), T(0.0))};
  }
};

}  // namespace sinew
