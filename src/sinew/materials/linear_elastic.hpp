#pragma once

#include <sinew/materials/material.hpp>

namespace sinew {

/// Small-strain linear elasticity: P = lambda tr(e) I + 2 mu e, e = sym(F) - I, energy lambda/2 tr(e)^2 + mu e:e.
/// Ren et al. (2020), eq. 45. Limits: small strains AND small rotations (a rigid rotation gives stress).
struct LinearElastic {
  static constexpr std::string_view name = "linear_elastic";
  static constexpr std::string_view summary = "Small-strain linear elasticity (not rotation invariant)";
  static constexpr std::string_view source = "Ren et al. (2020), eq. 45";
  double density = 0.0;
  ElasticConstants elastic;

  static void describe(auto&& field, auto& m) {
    field("density", m.density, "kg/m^3", "Reference mass density.", positive);
    ElasticConstants::describe(field, m.elastic);
  }

  template <class M>
  SINEW_INLINE Response<M> respond(const M& F) const {
    using T = ScalarOf<M>;
    const M I = M::identity();
    const M e = T(0.5) * (F + transpose(F)) - I;
    const T dilation = trace(e);
    Response<M> r;
    r.P = (T(elastic.lambda()) * dilation) * I + T(2.0 * elastic.mu()) * e;
    r.energy = T(0.5 * elastic.lambda()) * dilation * dilation + T(elastic.mu()) * double_dot(e, e);
    return r;
  }

  /// A_iJkL = lambda d_iJ d_kL + mu (d_ik d_JL + d_iL d_Jk).
  template <class T>
  SINEW_POINTWISE Tangent<T> tangent(const Mat3<T>&) const {
    const Mat3<T> I = Mat3<T>::identity();
    Tangent<T> A = T(elastic.lambda()) * dyad(I, I) + T(elastic.mu()) * Tangent<T>::identity();
    for (int i = 0; i < 3; ++i)
      for (int J = 0; J < 3; ++J) A[3 * i + J][3 * J + i] += T(elastic.mu());
    return A;
  }

  /// The tangent is constant: lambda + 2 mu.
  template <class M>
  SINEW_INLINE ScalarOf<M> acoustic_bound(const M&) const {
    return elastic.lambda() + 2.0 * elastic.mu();
  }
};

}  // namespace sinew
