#pragma once

#include <optional>
#include <sinew/materials/hardening/hardening.hpp>
#include <string>

namespace sinew {

/// sigma_y = (A + B e_p^n) (1 + C ln(rate / rate_0)) (1 - theta^m), theta = (T - T_0) / (T_melt - T_0) in [0, 1]. Rates below rate_0 count as
/// rate_0. Without exchange of heat, a share of the plastic work warms the material: T = T_0 + chi w_p / (rho c).
struct JohnsonCookHardening {
  static constexpr std::string_view name = "johnson_cook";
  static constexpr std::string_view summary = "Metal plasticity with hardening by strain and rate and softening by its own heat";
  static constexpr std::string_view source = "Johnson & Cook (1983)";
  static constexpr bool linear = false;
  static constexpr bool depends_on_rate = true;
  double yield_stress = 0.0, hardening_modulus = 0.0, hardening_exponent = 1.0;
  double rate_coefficient = 0.0, reference_rate = infinity;
  double thermal_exponent = 1.0, reference_temperature = 293.15, melting_temperature = infinity, specific_heat = infinity,
         taylor_quinney = 0.9;

  static void describe(auto&& field, auto& m) {
    field("yield_stress", m.yield_stress, "Pa", "A: yield stress of the virgin material at the reference rate and temperature.",
          positive);
    field("hardening_modulus", m.hardening_modulus, "Pa", "B: factor of the hardening by strain.", non_negative, optional);
    field("hardening_exponent", m.hardening_exponent, "1", "n: exponent of the hardening by strain.", positive, optional);
    field("rate_coefficient", m.rate_coefficient, "1", "C: factor of the hardening by rate.", non_negative, optional);
    field("reference_rate", m.reference_rate, "1/s",
          "Plastic strain rate at which A and B were measured; needed for hardening by rate.", positive, optional);
    field("thermal_exponent", m.thermal_exponent, "1", "m: exponent of the softening by heat.", positive, optional);
    field("reference_temperature", m.reference_temperature, "K", "Temperature at the start, at which A and B were measured.",
          positive, optional);
    field("melting_temperature", m.melting_temperature, "K", "Temperature without strength; if not given, heat does not soften.",
          positive, optional);
    field("specific_heat", m.specific_heat, "J/(kg K)", "Heat per mass and temperature; needed for softening by heat.", positive,
          optional);
    field("taylor_quinney", m.taylor_quinney, "1", "Share of the plastic work that becomes heat.", unit_interval, optional);
  }

  /// What does not fit together, or nothing. To be called after reading.
  std::optional<std::string> complete() const {
    if (rate_coefficient > 0.0 && reference_rate == infinity) return "rate_coefficient needs \"reference_rate\"";
    if (melting_temperature < infinity && specific_heat == infinity) return "melting_temperature needs \"specific_heat\"";
    if (melting_temperature <= reference_temperature) return "melting_temperature has to be above reference_temperature";
    return std::nullopt;
  }

  template <class T>
  SINEW_INLINE T temperature(const T& plastic_work, double density) const {
    return T(reference_temperature) + T(taylor_quinney / (density * specific_heat)) * plastic_work;
  }

  template <class T>
  SINEW_INLINE T strength_left(const T& temperature) const {
    const T heated = (temperature - T(reference_temperature)) / T(melting_temperature - reference_temperature);
    return T(1.0) - power(min(max(heated, T(0.0)), T(1.0)), thermal_exponent);
  }

  template <class T>
  SINEW_INLINE FlowStress<T> flow_stress(const PlasticPoint<T>& at) const {
    using std::log;
    const T strain = max(at.strain, T(1e-14));  // the slope at 0 is not finite for n < 1
    const T hardened = T(hardening_modulus) * power(strain, hardening_exponent);
    const T fast = max(at.rate * T(1.0 / reference_rate), T(1.0));
    const T by_rate = at.strength_left * (T(1.0) + T(rate_coefficient) * log(fast));
    const T slow = T(yield_stress) + hardened, by_fast = at.strength_left * slow * T(rate_coefficient);
    return {slow * by_rate, T(hardening_exponent) * hardened / strain * by_rate,
            select(fast > T(1.0), by_fast / max(at.rate, T(reference_rate)), T(0.0))};
  }
};

}  // namespace sinew
