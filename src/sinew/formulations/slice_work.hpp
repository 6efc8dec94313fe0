#pragma once
/// What the sweep over the particles of a block has in hand.

#include <sinew/formulations/sweep_dispatch.hpp>

namespace sinew {

/// Sums and extremes over the slices of a block, lane by lane.
struct SweepSums {
  Pack energy{0.0}, hourglass_energy{0.0}, released{0.0}, plastic_work{0.0}, damage_work{0.0}, viscous_power{0.0};
  Pack jacobian{infinity}, stiffness_rate{0.0}, left{1.0};

  ForceSummary total(double density) const {
    return {sum(energy),          sum(hourglass_energy), sum(released),      sum(plastic_work),
            sum(damage_work),     sum(viscous_power),    smallest(jacobian), largest(stiffness_rate) / density,
            smallest(left) == 0.0};
  }
};

/// A slice on its way through the sweep.
template <int D>
struct SliceInWork {
  Mat<Pack, D> S, F;
  Mat<Pack, D> direct;  ///< of the displacements, where F is an average over bonds
  PointResponse<D> point;
  Pack volume;  ///< reference volume [length^D]
  Pack
      material;  ///< that of the material, in which it stores energy: the first one if the reference configuration has been renewed

  /// What pairs are compared with.
  template <class Pairs>
  SINEW_INLINE const Mat<Pack, D>& of_pairs(DeformationGradient form) const {
    if constexpr (Pairs::vectors)
      if (form >= DeformationGradient::bond) return direct;
    return F;
  }
};

}  // namespace sinew
