#pragma once
/// The time step of an explicit run: dt = min( cfl min_i (length_i / c_i), 0.8 * 2 / omega_hourglass, 0.5 / rate_contact, 0.2 r / v ), where c_i is
/// the fastest wave of the current state in the reference frame and length_i the smaller of V^(1/D) and the distance of the nearest neighbor, and v the
/// speed with which particles of radius r come together.

#include <cmath>
#include <sinew/contact/contact_sums.hpp>
#include <sinew/formulations/total_lagrangian.hpp>
#include <string_view>

namespace sinew {

struct StepSize {
  double cfl = 0.3;
  double hourglass_limit = infinity;  ///< 2 / omega of the stiffest hourglass mode [time]
  double fixed = 0.0;                 ///< a step that the user fixed; 0: adaptive

  double operator()(const ForceSummary& state, const ContactSums& contact) const {
    return fixed > 0.0 ? fixed : min(contact_limit(contact), min(wave_limit(state), safety * hourglass_limit));
  }
  /// What decides: "fixed", "contact", "wave speed" or "hourglass stiffness".
  std::string_view limit(const ForceSummary& state, const ContactSums& contact) const {
    if (fixed > 0.0) return "fixed";
    if (contact_limit(contact) < min(wave_limit(state), safety * hourglass_limit)) return "contact";
    return wave_limit(state) <= safety * hourglass_limit ? "wave speed" : "hourglass stiffness";
  }

 private:
  static constexpr double safety = 0.8;
  static double contact_limit(const ContactSums& contact) {
    return min(0.5 / std::sqrt(contact.rate2), 0.2 / max(contact.approach, 0.0));
  }
  double wave_limit(const ForceSummary& state) const { return cfl / std::sqrt(state.largest_rate2); }
};

}  // namespace sinew
