#pragma once

#include <sinew/materials/hardening/hardening.hpp>

namespace sinew {

/// sigma_y = yield_stress + H e_p; perfectly plastic with H = 0.
struct LinearHardening {
  static constexpr std::string_view name = "j2_plastic";
  static constexpr std::string_view summary = "Metal plasticity with constant or linearly growing yield stress";
  static constexpr std::string_view source = "Bonet & Wood (2008), sec. 7.6; Ganzenmueller (2015), sec. 4.5";
  static constexpr bool linear = true;
  static constexpr bool depends_on_rate = false;
  double yield_stress = 0.0, hardening_modulus = 0.0;

  static void describe(auto&& field, auto& m) {
    field("yield_stress", m.yield_stress, "Pa", "Yield stress of the virgin material.", positive);
    field("hardening_modulus", m.hardening_modulus, "Pa", "Growth of the yield stress per plastic strain; 0: perfectly plastic.",
          non_negative, optional);
  }

  template <class T>
  SINEW_INLINE FlowStress<T> flow_stress(const PlasticPoint<T>& at) const {
    return {T(yield_stress) + T(hardening_modulus) * at.strain, T(hardening_modulus), T(0.0)};
  }
};

}  // namespace sinew
