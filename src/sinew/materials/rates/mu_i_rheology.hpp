#pragma once

#include <cmath>
#include <sinew/materials/rates/rate_law.hpp>

namespace sinew {

/// Dry grains whose friction grows with the rate of shear:
///
///     sqrt(J2) = mu(I) p where they flow;   mu(I) = mu_s + (mu_2 - mu_s) / (I_0 / I + 1),   I = rate d / sqrt(p / rho_s)
///
/// rate: sqrt(2 d:d) of the plastic deviatoric rate of deformation d, and d the diameter of the grains, rho_s their density. Flow keeps the volume. No tension: grains that are pulled apart have
/// no stress. The return from t* to t = sqrt(J2) solves t* - t = G dt rate(t), a quadratic equation: t = 2 H / (B + sqrt(B^2 - 4 H)), B = S_2 + t* + a, H = S_2 t* + S_s a, S = mu p,
/// a = G dt I_0 sqrt(p / rho_s) / d. Jop, Forterre & Pouliquen (2006); Dunatunga & Kamrin (2015), sec. 3.
struct MuIRheology {
  static constexpr std::string_view name = "mu_i_rheology";
  static constexpr std::string_view summary = "Dry grains: friction that grows with the rate of shear, no tension";
  static constexpr std::string_view source = "Jop, Forterre & Pouliquen (2006); Dunatunga & Kamrin (2015)";
  double static_friction = 0.0, dynamic_friction = 0.0, inertial_number = 0.0, grain_diameter = 0.0, grain_density = 0.0;

  static void describe(auto&& field, auto& m) {
    field("static_friction", m.static_friction, "1", "mu_s, friction of slow flow.", positive);
    field("dynamic_friction", m.dynamic_friction, "1", "mu_2, friction of fast flow; not below static_friction.", positive);
    field("inertial_number", m.inertial_number, "1", "I_0, at which friction is half way between.", positive);
    field("grain_diameter", m.grain_diameter, "m", "Diameter d of the grains.", positive);
    field("grain_density", m.grain_density, "kg/m^3", "Density rho_s of the grains themselves.", positive);
  }

  template <class M>
  SINEW_INLINE Flowed<M> flow(const M& trial, const ElasticConstants& elastic, double dt) const {
    using T = ScalarOf<M>;
    using std::sqrt;
    const StressInvariants<M> at(trial);
    const T pressure = max(at.pressure, T(0.0)), slow = T(static_friction) * pressure;
    const T fast = T(std::fmax(dynamic_friction, static_friction)) * pressure;
    const T a = T(elastic.shear_modulus * dt * inertial_number / (grain_diameter * std::sqrt(grain_density))) *
                sqrt(pressure + T(1e-300));
    const T B = fast + at.shear + a, H = fast * at.shear + slow * a;
    const T flowing = T(2.0) * H / (B + sqrt(max(B * B - T(4.0) * H, T(1e-300))));
    const T shear = select(at.shear > slow, min(flowing, at.shear), at.shear);
    const T l = T(1.0 / elastic.shear_modulus) * (at.shear - shear),
            opening = T(1.0 / elastic.bulk_modulus) * (pressure - at.pressure);
    return {(shear / at.shear) * at.deviator - pressure * M::identity(),
            T(std::sqrt(1.0 / 3.0)) * l + T(std::sqrt(2.0) / 3.0) * opening, l * shear};
  }

  template <class M>
  SINEW_INLINE ScalarOf<M> flow_stress(const M& stress) const {
    using T = ScalarOf<M>;
    return T(static_friction * std::sqrt(3.0)) * max(T(-1.0 / 3.0) * trace(stress), T(0.0));
  }
};

}  // namespace sinew
