#pragma once

#include <optional>
#include <sinew/materials/hardening/hardening.hpp>
#include <string>

namespace sinew {

/// sigma_y = yield_stress + (saturation_stress - yield_stress) (1 - exp(-rate e_p)) + H e_p.
struct VoceHardening {
  static constexpr std::string_view name = "j2_voce";
  static constexpr std::string_view summary = "Metal plasticity whose yield stress saturates, with a linear part besides";
  static constexpr std::string_view source = "Voce (1948); Simo & Hughes (1998), sec. 9.2 (with the linear part)";
  static constexpr bool linear = false;
  static constexpr bool depends_on_rate = false;
  double yield_stress = 0.0, saturation_stress = 0.0, saturation_rate = 0.0, hardening_modulus = 0.0;

  static void describe(auto&& field, auto& m) {
    field("yield_stress", m.yield_stress, "Pa", "Yield stress of the virgin material.", positive);
    field("saturation_stress", m.saturation_stress, "Pa", "Yield stress after much plastic strain, without the linear part.",
          positive);
    field("saturation_rate", m.saturation_rate, "1", "How fast it gets there: the gap falls by e in a plastic strain of 1/rate.",
          positive);
    field("hardening_modulus", m.hardening_modulus, "Pa", "Growth of the yield stress per plastic strain, besides.", non_negative,
          optional);
  }

  /// What does not fit together, or nothing. To be called after reading.
  std::optional<std::string> complete() const {
    if (saturation_stress < yield_stress) return "saturation_stress must not be below yield_stress";
    return std::nullopt;
  }

  template <class T>
  SINEW_INLINE FlowStress<T> flow_stress(const PlasticPoint<T>& at) const {
    using std::exp;
    const T gap = T(saturation_stress - yield_stress) * exp(T(-saturation_rate) * at.strain);
    return {T(saturation_stress) - gap + T(hardening_modulus) * at.strain, T(saturation_rate) * gap + T(hardening_modulus),
            T(0.0)};
  }
};

}  // namespace sinew
