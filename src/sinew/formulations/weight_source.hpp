#pragma once
/// Where the sweep takes the weights of a pair from: stored, computed, or a constant of the bond. For ListedPairs and LatticePairs.

#include <sinew/formulations/pair_weights.hpp>

namespace sinew {

/// Stored in double or single precision.
template <class Scalar, bool with_hourglass>
struct StoredWeights {
  using Weight = RadialWeight<Pack, with_hourglass>;
  static constexpr bool computed = false, radial = true;
  const Scalar* gradient;
  const Scalar* hourglass;

  using Shared = int;
  SINEW_INLINE int of_slice(int place) const { return place; }
  SINEW_INLINE void prefetch(std::size_t entry) const {
    __builtin_prefetch(gradient + lanes * entry);
    if constexpr (with_hourglass) __builtin_prefetch(hourglass + lanes * entry);
  }
  SINEW_INLINE Weight stored(std::size_t entry) const {
    Weight w{Pack::load(gradient + lanes * entry)};
    if constexpr (with_hourglass) w.hourglass = Pack::load(hourglass + lanes * entry);
    return w;
  }
  template <int D>
  SINEW_INLINE Weight at(std::size_t entry, const PlaceIndex*, const Vec<Pack, D>&, int) const {
    return stored(entry);
  }
};

/// Computed from X_ij, V_j and R_i: the same numbers as stored ones.
template <class Kernel, bool with_hourglass>
struct ComputedWeights {
  using Weight = RadialWeight<Pack, with_hourglass>;
  static constexpr bool computed = true, radial = true;
  const double* volume;  ///< by place
  const double* radius;

  using Shared = Pack;
  SINEW_INLINE void prefetch(std::size_t) const {}
  SINEW_INLINE Pack of_slice(int place) const { return Pack::load(radius + place); }
  template <int D>
  SINEW_INLINE Weight at(std::size_t, const PlaceIndex* index, const Vec<Pack, D>& X, const Pack& R) const {
    return radial_weight<Kernel, with_hourglass>(X, Pack::gather(volume, index), R);
  }
};

/// Stored vectors, and other weights as they are needed.
template <int D>
struct StoredVectors {
  using Weight = VectorWeight<D>;
  static constexpr bool computed = false, radial = false;
  const double* gradient;
  const double* force;                ///< vectors that carry the stress: those of the gradient, or others
  const double* hourglass = nullptr;  ///< nullptr: none
  // not read unless they are asked for
  const double* average = nullptr;
  const double* dissipation = nullptr;
  SINEW_INLINE void prefetch(std::size_t) const {}

  using Shared = int;
  SINEW_INLINE int of_slice(int place) const { return place; }
  SINEW_INLINE Weight stored(std::size_t entry) const {
    return {gradient + lanes * D * entry, force + lanes * D * entry, hourglass ? hourglass + lanes * entry : nullptr,
            average + lanes * entry, dissipation + lanes * entry};
  }
  SINEW_INLINE Weight at(std::size_t entry, const PlaceIndex*, const Vec<Pack, D>&, int) const { return stored(entry); }
};

/// Of a lattice.
template <int D, bool with_hourglass>
struct BondWeights {
  using Weight = BondWeight<Pack, D, with_hourglass>;
  const BondWeight<double, D, true>* bonds;

  SINEW_INLINE Weight of(int bond) const {
    Weight w{Pack(bonds[bond].gradient), {}};
    for (int c = 0; c < D; ++c) w.gradient_vector[c] = Pack(bonds[bond].gradient_vector[c]);
    if constexpr (with_hourglass) w.hourglass = Pack(bonds[bond].hourglass);
    return w;
  }
};

}  // namespace sinew
