#pragma once

#include <sinew/materials/material.hpp>

namespace sinew {

/// Neo-Hookean solid with shape and volume apart: P = mu J^-2/3 F + (kappa (J - 1) - mu/3 J^-5/3 F:F) H, H = cof F;
/// energy mu/2 (J^-2/3 F:F - 3) + kappa/2 (J - 1)^2, kappa the bulk modulus. Ren et al. (2020), eq. 46; Wiragunarsa et al.
/// (2024), eq. 17-18. Limits: J > 0.
struct NeoHookeanIsochoric {
  static constexpr std::string_view name = "neo_hookean_isochoric";
  static constexpr std::string_view summary =
      "Neo-Hookean solid whose shear part does not change with volume; for nearly incompressible rubber";
  static constexpr std::string_view source = "Ren et al. (2020), eq. 46; Wiragunarsa et al. (2024), eq. 17-18";
  double density = 0.0;
  ElasticConstants elastic;

  static void describe(auto&& field, auto& m) {
    field("density", m.density, "kg/m^3", "Reference mass density.", positive);
    ElasticConstants::describe(field, m.elastic);
  }

  template <class M>
  SINEW_INLINE Response<M> respond(const M& F) const {
    using T = ScalarOf<M>;
    const double kappa = elastic.bulk_modulus, mu = elastic.mu();
    const M H = cofactor(F);
    const T J = determinant(F);
    const T square = double_dot(F, F), growth = J - T(1.0), m = shape_modulus(J);
    Response<M> r;
    r.P = m * F + (T(kappa) * growth - T(1.0 / 3.0) * m * square / J) * H;
    r.energy = T(0.5) * (m * square - T(3.0 * mu)) + T(0.5 * kappa) * growth * growth;
    return r;
  }

  /// A = m I - 2m/(3J) (F (x) H + H (x) F) + (kappa + 5m/(9 J^2) F:F) H (x) H + (kappa (J - 1) - m/(3J) F:F) d^2J/dFdF,
  /// m = mu J^-2/3.
  template <class T>
  SINEW_POINTWISE Tangent<T> tangent(const Mat3<T>& F) const {
    const T kappa(elastic.bulk_modulus);
    const Mat3<T> H = cofactor(F);
    const T J = determinant(F);
    const T square = double_dot(F, F), m = shape_modulus(J), third = T(1.0 / 3.0) * m / J;
    return m * Tangent<T>::identity() - (T(2.0) * third) * (dyad(F, H) + dyad(H, F)) +
           (kappa + T(5.0 / 3.0) * third * square / J) * dyad(H, H) +
           (kappa * (J - T(1.0)) - third * square) * determinant_hessian(F);
  }

  /// With b = F N and a = F^-T N (a.b = 1) the acoustic tensor is m I + k a (x) a - 2m/3 (a (x) b + b (x) a), k = kappa J^2 +
  /// 5m/9 F:F. For N along the smallest stretch s the two vectors are parallel and the largest eigenvalue is k / s^2 - m/3. No
  /// other N gives more: in the plane of a and b the last terms have the trace k |a|^2 - 4m/3 and the determinant (2m/3)^2 (1 -
  /// |a|^2 |b|^2), and |b|^2 <= t^2 + s^2 - t^2 s^2 |a|^2 with the largest stretch t; so the claim is k (k / s^2 - 4m/3) >=
  /// (2m/3)^2 (t^2 - s^2), which F:F >= t^2 + 2 s^2 implies.
  /// For vectors N of any length m |N|^2 + k |a|^2 is enough: what it has more than the tensor is 4m/3 |N|^2 along a, k |a|^2 across it, and -2m/3 |a| |b| at most
  /// between the two, where |b|^2 <= F:F |N|^2 and k >= 5m/9 F:F.
  template <class M>
  SINEW_INLINE AcousticBound<ScalarOf<M>> acoustic_bound(const M& F) const {
    using T = ScalarOf<M>;
    const T J = determinant(F), m = shape_modulus(J);
    return {m, T(elastic.bulk_modulus) * J * J + T(5.0 / 9.0) * m * double_dot(F, F), T(4.0 / 3.0) * m};
  }

 private:
  /// mu J^-2/3 [Pa].
  template <class T>
  SINEW_INLINE T shape_modulus(const T& J) const {
    const T root = cbrt(J);
    return T(elastic.mu()) / (root * root);
  }
};

}  // namespace sinew
