#pragma once
/// The time step of an explicit run: dt = min( cfl min_i (length_i / c_i), 0.8 * 2 / omega_hourglass ), where c_i is the fastest wave of the
/// current state in the reference frame and length_i the smaller of V^(1/D) and the distance of the nearest neighbor.

#include <cmath>
#include <sinew/formulations/total_lagrangian.hpp>
#include <string_view>

namespace sinew {

struct StepSize {
  double cfl = 0.3;
  double hourglass_limit = infinity;  ///< 2 / omega of the stiffest hourglass mode [time]
  double fixed = 0.0;                 ///< a step that the user fixed; 0: adaptive

  double operator()(const ForceSummary& state) const {
    return fixed > 0.0 ? fixed : min(wave_limit(state), safety * hourglass_limit);
  }
  /// What decides: "fixed", "wave speed" or "hourglass stiffness".
  std::string_view limit(const ForceSummary& state) const {
    if (fixed > 0.0) return "fixed";
    return wave_limit(state) <= safety * hourglass_limit ? "wave speed" : "hourglass stiffness";
  }

 private:
  static constexpr double safety = 0.8;
  double wave_limit(const ForceSummary& state) const { return cfl / std::sqrt(state.largest_rate2); }
};

}  // namespace sinew
