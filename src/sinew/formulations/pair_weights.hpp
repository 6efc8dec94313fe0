#pragma once
/// What a reference configuration knows about its pairs, computed once: gradient weights, hourglass weights, the correction of each
/// particle, the length that limits its time step.

#include <sinew/core/params.hpp>
#include <sinew/corrections/registry.hpp>
#include <sinew/kernels/registry.hpp>
#include <sinew/neighbors/pair_list.hpp>
#include <string>
#include <vector>

namespace sinew {

/// Weight of a pair in the hourglass force of i, besides its coefficient, E_i and V_i.
enum class HourglassWeight {
  conservative,  ///< V_j a_ij / sum_k V_k a_ik r_ik^2
  central        ///< V_j W_ij / r_ij^2
};

/// Number of independent components of a symmetric D x D matrix.
template <int D>
inline constexpr int symmetric_size = D*(D + 1) / 2;

template <int D>
struct PairWeights {
  /// Radial corrections: entry e, lane k holds V_j |dW/dr| / r [1/length^2]. Others: D times as many, V_j g_ij component by component.
  AlignedArray<double> gradient;
  AlignedArray<double> stiffness;        ///< entry e, lane k: hourglass weight of the pair, see HourglassWeight [1/length^2]
  AlignedArray<double> correction;       ///< slice s, component c, lane k: L, symmetric, upper triangle; not used if not radial
  AlignedArray<double> inverse_length2;  ///< per slot: 1 / length^2, length the smaller of V^(1/D) and the nearest distance
  AlignedArray<double> stiffness_sum;    ///< per slot: sum of `stiffness` over its neighbors [1/length^2]
  bool radial = true;
  std::size_t bytes() const {
    return gradient.bytes() + stiffness.bytes() + correction.bytes() + inverse_length2.bytes() + stiffness_sum.bytes();
  }
};

/// Computes the weights. A particle whose neighbors do not allow the correction is a CaseError that names it.
template <int D>
PairWeights<D> make_pair_weights(const Particles<D>& particles, const PairList& list, const std::vector<double>& support_radius,
                                 const AnyKernel& kernel, const AnyCorrection& correction, HourglassWeight hourglass);

}  // namespace sinew
