#pragma once

#include <cmath>
#include <limits>
#include <numbers>
#include <sinew/materials/rates/rate_law.hpp>

namespace sinew {

/// Soil after Drucker and Prager, with a flow that need not be associated. With p = -tr(sigma)/3, s the deviator, J2 = s:s/2:
///
///     f = sqrt(J2) - k_phi p - k_c <= 0;   k_phi = 3 tan(phi) / sqrt(9 + 12 tan^2 phi), k_c = 3 c / sqrt(9 + 12 tan^2 phi);   flow along sqrt(J2) - k_psi p
///
/// k_psi has the dilatancy angle in the place of phi. First p is cut off at the tensile strength; then, with l = f / (G + K k_phi k_psi), sqrt(J2) falls by G l and p grows by
/// K k_psi l. Equivalent plastic strain: l sqrt(1/3 + 2/9 k_psi^2), and sqrt(2)/3 of the volumetric strain of the cut-off. The constants match Mohr and Coulomb's law in plane strain if psi = phi;
/// with psi = 0 the same soil is weaker, sin(phi') = k_phi. Islam & Peng (2019), eq. 4-14.
struct DruckerPrager {
  static constexpr std::string_view name = "drucker_prager";
  static constexpr std::string_view summary = "Soil: friction, cohesion, dilatancy, tension cut-off";
  static constexpr std::string_view source = "Islam & Peng (2019), eq. 4-14; Bui et al. (2008)";
  double friction_angle = 0.0, cohesion = 0.0, dilatancy_angle = 0.0;
  double tensile_strength = std::numeric_limits<double>::quiet_NaN();

  static void describe(auto&& field, auto& m) {
    constexpr Range angle{0.0, 90.0, false, true, "from 0 to below 90 (degrees)"};
    field("friction_angle", m.friction_angle, "deg", "Angle of internal friction phi.", angle);
    field("cohesion", m.cohesion, "Pa", "Cohesion c.", non_negative);
    field("dilatancy_angle", m.dilatancy_angle, "deg", "Dilatancy angle psi; 0: flow keeps the volume.", angle, optional);
    field("tensile_strength", m.tensile_strength, "Pa",
          "Largest mean stress; if not given that of the tip of the cone, c / tan(phi), and 0 without friction.", non_negative,
          optional);
  }

  /// k of an angle in degrees.
  static SINEW_INLINE double slope(double degrees) {
    const double tangent = std::tan(degrees * std::numbers::pi / 180.0);
    return 3.0 * tangent / std::sqrt(9.0 + 12.0 * tangent * tangent);
  }
  /// k_c [Pa].
  SINEW_INLINE double strength() const {
    const double tangent = std::tan(friction_angle * std::numbers::pi / 180.0);
    return 3.0 * cohesion / std::sqrt(9.0 + 12.0 * tangent * tangent);
  }
  /// The least pressure, at most 0.
  SINEW_INLINE double least_pressure() const {
    const double k_phi = slope(friction_angle), tip = k_phi > 0.0 ? strength() / k_phi : 0.0;
    if (std::isnan(tensile_strength)) return -tip;
    return k_phi > 0.0 ? -std::fmin(tensile_strength, tip) : -tensile_strength;
  }

  template <class M>
  SINEW_INLINE Flowed<M> flow(const M& trial, const ElasticConstants& elastic, double) const {
    using T = ScalarOf<M>;
    const double K = elastic.bulk_modulus, G = elastic.shear_modulus;
    const double k_phi = slope(friction_angle), k_psi = slope(dilatancy_angle);
    const StressInvariants<M> at(trial);
    const T cut_off = max(at.pressure, T(least_pressure())), opening = T(1.0 / K) * (cut_off - at.pressure);
    const T excess = at.shear - T(k_phi) * cut_off - T(strength());
    const T l = max(excess, T(0.0)) * T(1.0 / (G + K * k_phi * k_psi));
    const T pressure = cut_off + T(K * k_psi) * l, shear = max(at.shear - T(G) * l, T(0.0));
    return {(shear / at.shear) * at.deviator - pressure * M::identity(),
            T(std::sqrt(1.0 / 3.0 + 2.0 / 9.0 * k_psi * k_psi)) * l + T(std::numbers::sqrt2 / 3.0) * opening,
            l * (shear - T(k_psi) * pressure) - opening * cut_off};
  }

  template <class M>
  SINEW_INLINE ScalarOf<M> flow_stress(const M& stress) const {
    using T = ScalarOf<M>;
    const T pressure = T(-1.0 / 3.0) * trace(stress);
    return T(std::numbers::sqrt3) * max(T(slope(friction_angle)) * pressure + T(strength()), T(0.0));
  }
};

}  // namespace sinew
