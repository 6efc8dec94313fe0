#pragma once
/// What a reference configuration knows about its pairs, computed once: gradient weights, hourglass weights, the correction of each
/// particle, the length that limits its time step.

#include <sinew/core/params.hpp>
#include <sinew/corrections/registry.hpp>
#include <sinew/formulations/map_field.hpp>
#include <sinew/formulations/pair_weight.hpp>
#include <sinew/kernels/registry.hpp>
#include <sinew/neighbors/block_pairs.hpp>
#include <string>
#include <vector>

namespace sinew {

/// How the weights of listed pairs are kept. All give the same results to rounding but `single`, whose weights are rounded to float before
/// the correction is built from them: gradients stay exact for linear fields.
enum class WeightStorage {
  stored,    ///< double precision
  single,    ///< single precision, half the memory
  computed,  ///< not at all: from the reference positions in each step
  automatic  ///< stored up to `most_stored_bytes`, computed beyond: a property of the case, not of the machine
};
inline constexpr std::size_t most_stored_bytes = std::size_t{8} << 30;

/// "stored", "single" or "computed".
std::string_view name_of(WeightStorage storage);

/// Weight of a pair in the hourglass force of i, besides its coefficient, E_i and V_i.
enum class HourglassWeight {
  none,
  conservative,  ///< V_j a_ij / sum_k V_k a_ik r_ik^2
  central        ///< V_j W_ij / r_ij^2
};

/// What is kept for averages over bonds.
enum class BondAverage {
  none,
  own,    ///< the weights of a particle's own average
  mutual  ///< those of its neighbors' averages besides
};

/// Number of independent components of a symmetric D x D matrix.
template <int D>
inline constexpr int symmetric_size = D*(D + 1) / 2;

struct WeightOptions {
  AnyKernel kernel;
  AnyCorrection correction;
  HourglassWeight hourglass = HourglassWeight::conservative;
  WeightStorage storage = WeightStorage::stored;  ///< not automatic
  BondAverage average = BondAverage::none;
  bool symmetric = false;    ///< force vectors 1/2 (g_ij - g_ji)
  bool vectors = false;      ///< for other reasons
  bool dissipation = false;  ///< weights of a Laplacian
  bool lenient =
      false;  ///< particles that see too few others have no gradient and no hourglass stiffness; otherwise that is an error
  bool by_distance = false;  ///< the length that limits the time step is the nearest distance alone, whatever the volume

  /// Some weights need the neighbor's map besides the particle's own.
  bool mutual() const { return symmetric || average == BondAverage::mutual; }
  /// One number a pair is enough for the gradient; otherwise vectors are stored.
  bool radial() const {
    return std::visit([](const auto& c) { return c.radial; }, correction) && !vectors && !mutual() &&
           average == BondAverage::none;
  }
  /// Pairs need a second number: V_j W_ij / r_ij^2, or any hourglass weight where gradients are vectors.
  bool hourglass_weights() const {
    return hourglass == HourglassWeight::central || (!radial() && hourglass == HourglassWeight::conservative);
  }
};

/// Of listed pairs: entry e, lane k stands at 8 e + k.
template <class Scalar>
struct StoredPairs {
  AlignedArray<Scalar> gradient;   ///< V_j a_ij [1/length^2]; vectors: D times as many, V_j g_ij component by component
  AlignedArray<Scalar> hourglass;  ///< hourglass weight [1/length^2]; empty where not needed
  // likewise empty where not needed
  AlignedArray<Scalar> force;             ///< vectors that carry the stress in the place of those of the gradient [1/length]
  AlignedArray<Scalar> average;           ///< V_j W1_ij / r_ij^2, W1 the corrected kernel [1/length^2]
  AlignedArray<Scalar> average_of_other;  ///< V_i W1_ji / r_ij^2 [1/length^2]
  AlignedArray<Scalar> dissipation;       ///< V_j a_ij [1/length^2]
  std::size_t bytes() const {
    return gradient.bytes() + hourglass.bytes() + force.bytes() + average.bytes() + average_of_other.bytes() +
           dissipation.bytes();
  }
};

/// A symmetric matrix of eight particles: upper triangle.
template <int D>
struct SymmetricPack {
  Pack upper[symmetric_size<D>];

  SINEW_INLINE Mat<Pack, D> matrix() const {
    Mat<Pack, D> full;
    for (int i = 0, c = 0; i < D; ++i)
      for (int j = i; j < D; ++j, ++c) full[i][j] = full[j][i] = upper[c];
    return full;
  }
  void set(const Mat<Pack, D>& full) {
    for (int i = 0, c = 0; i < D; ++i)
      for (int j = i; j < D; ++j, ++c) upper[c] = full[i][j];
  }
};

/// What eight particles need besides their pairs, in the layout in which it is kept.
template <int D>
struct SliceConstants {
  SymmetricPack<D> correction;  ///< L; the identity where pairs have vectors
  Pack volume;                  ///< V_i [length^D]
  Pack hourglass_scale;         ///< 1 / sum_k V_k a_ik r_ik^2 for the conservative form, 1 for the central one [1]
  Pack inverse_length2;         ///< 1 / length^2, length the smaller of V^(1/D) and the nearest distance, or that alone

  SINEW_INLINE Mat<Pack, D> correction_matrix() const { return correction.matrix(); }
};

template <int D>
struct PairWeights {
  StoredPairs<double> pairs;
  StoredPairs<float> single_pairs;
  std::vector<BondWeight<double, D, true>> bonds;  ///< of LatticePatterns::bonds
  AlignedArray<SliceConstants<D>> constants;       ///< one a lattice pattern, then one a slice with a pair list
  std::vector<int> constants_of;                   ///< slice -> its constants
  AlignedArray<double> radius;                     ///< per slot: support radius R_i [length]
  std::vector<double> most_stiffness;              ///< per body: largest sum of the hourglass weights of a particle [1/length^2]
  std::vector<double> most_trace;                  ///< per body: largest trace of the moments sum V_j a_ij X_ij (x) X_ij [1]
  std::vector<double> most_slope;                  ///< per body: largest sum V_j a_ij [1/length^2]
  AlignedArray<SymmetricPack<D>>
      own_average;  ///< like `constants`: sum_j V_j W1_ij (I - N_ij (x) N_ij) / 2 + V_i W1_ii I; or empty
  std::size_t bytes() const {
    return pairs.bytes() + single_pairs.bytes() + constants.bytes() + constants_of.size() * sizeof(int) + radius.bytes() +
           own_average.bytes();
  }
};

/// Where the pairs are.
template <int D>
struct PairSource {
  const Particles<D>& particles;
  const BlockPairs<D>& pairs;
};

/// Computes the weights. A particle whose neighbors do not allow the correction is a CaseError that names it. `support_radius`: per slot [length]. `maps`: to be filled for the
/// own particles; nullptr: not wanted.
template <int D>
PairWeights<D> make_pair_weights(const PairSource<D>& source, const std::vector<double>& support_radius,
                                 const WeightOptions& options, MapField<D>* maps = nullptr);

/// Anew for slices of a block of which pairs have been cut. Returns the slots that are left with too few neighbors, or nearly all in one line or plane.
template <int D>
std::vector<int> renew_weights(const PairSource<D>& source, const Block& block, const std::vector<int>& slices,
                               const WeightOptions& options, PairWeights<D>& weights);

}  // namespace sinew
