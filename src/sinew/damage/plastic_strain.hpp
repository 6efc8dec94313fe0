#pragma once

#include <sinew/damage/damage.hpp>

namespace sinew {

/// Begins where the equivalent plastic strain is above a limit.
struct PlasticStrainDamage {
  static constexpr std::string_view name = "plastic_strain";
  static constexpr std::string_view summary = "Failure where the equivalent plastic strain is above a limit";
  static constexpr std::string_view source = "e.g. Johnson & Cook (1985) with constant failure strain";
  static constexpr bool needs_flow = true;
  static constexpr int numbers = 0;
  double limit = 0.0;
  CrackGrowth growth;

  static void describe(auto&& field, auto& m) {
    field("limit", m.limit, "1", "Equivalent plastic strain that the material bears.", positive);
    CrackGrowth::describe(field, m.growth);
  }

  template <class M>
  SINEW_INLINE auto begins(const DamagePoint<M>& at, ScalarOf<M>*) const {
    return at.plastic_strain > ScalarOf<M>(limit);
  }
};

}  // namespace sinew
