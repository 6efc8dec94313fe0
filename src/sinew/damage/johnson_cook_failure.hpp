#pragma once

#include <optional>
#include <sinew/damage/damage.hpp>
#include <string>

namespace sinew {

/// Begins where sum (increment of plastic strain) / e_f reaches 1, with the failure strain of the current state
///
///     e_f = (d1 + d2 exp(d3 s)) (1 + d4 ln(rate / rate_0)) (1 + d5 theta),   s = mean stress / von Mises stress, at most 1.5
///
/// and rates below rate_0 counted as rate_0, theta = (T - T_0) / (T_melt - T_0).
struct JohnsonCookFailure {
  static constexpr std::string_view name = "johnson_cook";
  static constexpr std::string_view summary =
      "Failure by plastic strain that depends on stress triaxiality, rate and temperature";
  static constexpr std::string_view source = "Johnson & Cook (1985)";
  static constexpr bool needs_flow = true;
  static constexpr int numbers = 1;  ///< the sum
  double d1 = 0.0, d2 = 0.0, d3 = 0.0, d4 = 0.0, d5 = 0.0;
  double reference_rate = infinity, reference_temperature = 293.15, melting_temperature = infinity;
  CrackGrowth growth;

  static void describe(auto&& field, auto& m) {
    field("d1", m.d1, "1", "Failure strain far from tension.", any_number);
    field("d2", m.d2, "1", "Factor of the part that depends on triaxiality.", any_number, optional);
    field("d3", m.d3, "1", "Its exponent; negative: less strain in tension.", any_number, optional);
    field("d4", m.d4, "1", "Growth with the logarithm of the rate.", any_number, optional);
    field("d5", m.d5, "1", "Growth with temperature.", any_number, optional);
    field("reference_rate", m.reference_rate, "1/s", "Rate at which d1 to d3 were measured; needed for d4.", positive, optional);
    field("reference_temperature", m.reference_temperature, "K", "Temperature at which they were measured.", positive, optional);
    field("melting_temperature", m.melting_temperature, "K", "Where theta is 1; needed for d5.", positive, optional);
    CrackGrowth::describe(field, m.growth);
  }
  std::optional<std::string> complete() const {
    if (d4 != 0.0 && reference_rate == infinity) return "d4 needs \"reference_rate\"";
    if (d5 != 0.0 && melting_temperature == infinity) return "d5 needs \"melting_temperature\"";
    if (melting_temperature <= reference_temperature) return "melting_temperature has to be above reference_temperature";
    if (d1 < 0.0) return "d1 must not be negative";
    return std::nullopt;
  }

  template <class T>
  SINEW_INLINE T failure_strain(const T& triaxiality, const T& rate, const T& temperature) const {
    using std::exp, std::log;
    const T theta = (temperature - T(reference_temperature)) / T(melting_temperature - reference_temperature);
    return (T(d1) + T(d2) * exp(T(d3) * min(triaxiality, T(1.5)))) *
           (T(1.0) + T(d4) * log(max(rate * T(1.0 / reference_rate), T(1.0)))) *
           (T(1.0) + T(d5) * min(max(theta, T(0.0)), T(1.0)));
  }

  template <class M>
  SINEW_INLINE auto begins(const DamagePoint<M>& at, ScalarOf<M>* remembered) const {
    using std::sqrt;
    using T = ScalarOf<M>;
    if (any(at.plastic_increment > T(0.0))) {
      const M tau = at.P * transpose(at.F);
      const T mean = trace(tau) * T(1.0 / 3.0);
      const M s = tau - mean * M::identity();
      const T triaxiality = mean / (sqrt(T(1.5) * double_dot(s, s)) + T(1e-300));
      const T rate = at.dt > 0.0 ? at.plastic_increment * T(1.0 / at.dt) : T(0.0);
      *remembered = *remembered + at.plastic_increment / max(failure_strain(triaxiality, rate, at.temperature), T(1e-6));
    }
    return *remembered >= T(1.0);
  }
};

}  // namespace sinew
