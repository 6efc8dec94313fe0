#pragma once

#include <sinew/materials/material.hpp>

namespace sinew {

/// St. Venant-Kirchhoff: S = lambda tr(E) I + 2 mu E, E = (F^T F - I) / 2, P = F S; energy lambda/2 tr(E)^2 + mu E:E.
/// Ganzenmueller (2015), eq. 18-20, with tr(E) = E_ii. Limits: large rotations, moderate strains; softens and fails in
/// compression.
struct StVenantKirchhoff {
  static constexpr std::string_view name = "st_venant_kirchhoff";
  static constexpr std::string_view summary = "Linear law between Green-Lagrange strain and second Piola-Kirchhoff stress";
  static constexpr std::string_view source = "Ganzenmueller (2015), eq. 18-20";
  double density = 0.0;
  ElasticConstants elastic;

  static void describe(auto&& field, auto& m) {
    field("density", m.density, "kg/m^3", "Reference mass density.", positive);
    ElasticConstants::describe(field, m.elastic);
  }

  template <class M>
  SINEW_INLINE Response<M> respond(const M& F) const {
    using T = ScalarOf<M>;
    const M E = green_lagrange(F);
    const T dilation = trace(E);
    Response<M> r;
    r.P = F * second_piola_kirchhoff(E);
    r.energy = T(0.5 * elastic.lambda()) * dilation * dilation + T(elastic.mu()) * double_dot(E, E);
    return r;
  }

  /// A_iJkL = d_ik S_JL + lambda F_iJ F_kL + mu (b_ik d_JL + F_iL F_kJ), b = F F^T.
  template <class T>
  SINEW_POINTWISE Tangent<T> tangent(const Mat3<T>& F) const {
    const T mu(elastic.mu());
    const Mat3<T> S = second_piola_kirchhoff(green_lagrange(F));
    const Mat3<T> b = F * transpose(F);
    Tangent<T> A = T(elastic.lambda()) * dyad(F, F);
    for (int i = 0; i < 3; ++i)
      for (int J = 0; J < 3; ++J)
        for (int k = 0; k < 3; ++k)
          for (int L = 0; L < 3; ++L) {
            T& entry = A[3 * i + J][3 * k + L];
            entry += mu * F[i][L] * F[k][J];
            if (i == k) entry += S[J][L];
            if (J == L) entry += mu * b[i][k];
          }
    return A;
  }

  /// The acoustic tensor is (lambda + mu) F N (x) F N + mu b + S_NN I. Each term is largest for N along the largest principal
  /// stretch s, which gives (lambda + 3 mu) s^2 + lambda tr(E) - mu.
  template <class M>
  SINEW_INLINE ScalarOf<M> acoustic_bound(const M& F) const {
    using T = ScalarOf<M>;
    const double lambda = elastic.lambda(), mu = elastic.mu();
    const M C = transpose(F) * F;
    return T(lambda + 3.0 * mu) * largest_eigenvalue_bound(C) + T(0.5 * lambda) * (trace(C) - T(3.0)) - T(mu);
  }

 private:
  template <class M>
  static SINEW_INLINE M green_lagrange(const M& F) {
    return ScalarOf<M>(0.5) * (transpose(F) * F - M::identity());
  }
  template <class M>
  SINEW_INLINE M second_piola_kirchhoff(const M& E) const {
    using T = ScalarOf<M>;
    return (T(elastic.lambda()) * trace(E)) * M::identity() + T(2.0 * elastic.mu()) * E;
  }
};

}  // namespace sinew
