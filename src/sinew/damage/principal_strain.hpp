#pragma once

#include <sinew/damage/damage.hpp>

namespace sinew {

/// Begins where the largest principal Green-Lagrange strain is above a threshold.
struct PrincipalStrainDamage {
  static constexpr std::string_view name = "principal_strain";
  static constexpr std::string_view summary = "Failure where the largest principal strain is above a threshold";
  static constexpr std::string_view source = "Ganzenmueller (2015), eq. 45-46";
  static constexpr bool needs_flow = false;
  static constexpr int numbers = 0;
  double threshold = 0.0;
  CrackGrowth growth;

  static void describe(auto&& field, auto& m) {
    field("threshold", m.threshold, "1", "Largest principal Green-Lagrange strain that the material bears.", positive);
    CrackGrowth::describe(field, m.growth);
  }

  template <class M>
  SINEW_INLINE auto begins(const DamagePoint<M>& at, ScalarOf<M>*) const {
    using T = ScalarOf<M>;
    const M strain = T(0.5) * (transpose(at.F) * at.F - M::identity());
    const auto never = T(1.0) < T(0.0);
    if (!any(double_dot(strain, strain) > T(threshold * threshold))) return never;
    const Vec3<T> principal = spectrum(strain).values;
    return max(max(principal[0], principal[1]), principal[2]) > T(threshold);
  }
};

}  // namespace sinew
