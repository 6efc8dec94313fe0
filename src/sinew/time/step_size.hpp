#pragma once
/// The time step of an explicit run: dt = min( cfl min_i (length_i / c_i), 0.8 * 2 / omega_hourglass, 0.8 s / rate_JST, 0.5 / rate_contact, 0.2 r / v ), where c_i is
/// the fastest wave of the current state in the reference frame and length_i the smaller of V^(1/D) and the distance of the nearest neighbor, and v the
/// speed with which particles of radius r come together. s, the damping that the integrator bears: 2.5 for rk3, 1.25 for velocity Verlet, whose limit without waves is 2.

#include <cmath>
#include <sinew/contact/contact_sums.hpp>
#include <sinew/formulations/formulation.hpp>
#include <string_view>

namespace sinew {

struct StepSize {
  double cfl = 0.3;
  double hourglass_limit = infinity;    ///< 2 / omega of the stiffest hourglass mode [time]
  double dissipation_limit = infinity;  ///< s / rate of JST dissipation [time]
  double fixed = 0.0;                   ///< a step that the user fixed; 0: adaptive

  double operator()(const ForceSummary& state, const ContactSums& contact) const {
    return fixed > 0.0 ? fixed
                       : min(contact_limit(contact), min(wave_limit(state), safety * min(hourglass_limit, dissipation_limit)));
  }
  /// What decides: "fixed", "contact", "wave speed", "hourglass stiffness" or "JST dissipation".
  std::string_view limit(const ForceSummary& state, const ContactSums& contact) const {
    const double step = (*this)(state, contact);
    if (fixed > 0.0) return "fixed";
    if (step == contact_limit(contact)) return "contact";
    if (step == wave_limit(state)) return "wave speed";
    return hourglass_limit <= dissipation_limit ? "hourglass stiffness" : "JST dissipation";
  }

 private:
  static constexpr double safety = 0.8;
  static double contact_limit(const ContactSums& contact) {
    return min(0.5 / std::sqrt(contact.rate2), 0.2 / max(contact.approach, 0.0));
  }
  double wave_limit(const ForceSummary& state) const { return cfl / std::sqrt(state.largest_rate2); }
};

}  // namespace sinew
