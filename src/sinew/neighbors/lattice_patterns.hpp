#pragma once
/// Regular arrangements without a pair list. Where particles stand in lattice rows, the eight particles of a slice have their neighbors at the
/// same distances in places and at the same X_ij, but for those that are missing at a surface. Such a slice needs only the number of its pattern; a
/// block has a few dozen of them. A slice that fits no pattern stays in the pair list: which way a slice goes is a property of
/// the particles, not of the formulation, and changes results by rounding only.

#include <array>
#include <cstdint>
#include <sinew/core/pack.hpp>
#include <sinew/core/vec.hpp>
#include <vector>

namespace sinew {

/// What all pairs of one kind have in common.
template <int D>
struct Bond {
  Vec<double, D> X;     ///< X_j - X_i [length]
  double volume = 0.0;  ///< V_j [length^D]
  double radius = 0.0;  ///< R_i, the support radius [length]
};

/// All own particles have a neighbor at `forward` places from them with X_ij = X of the bond, and one at `backward` with X_ij = -X.
struct MirrorPair {
  int forward, backward, bond;
};
/// Those particles whose bit is set in `members` have a neighbor at `offset` places from them.
struct SinglePair {
  int offset, bond;
  std::uint8_t members;
};

/// Pairs of a slice: ranges of LatticePatterns::mirrored and ::single.
struct LatticePattern {
  int first_mirrored = 0, end_mirrored = 0, first_single = 0, end_single = 0;
};
/// Volumes of the particles of a slice; 0: not one of the block's own, or padding.
using SliceVolumes = std::array<double, lanes>;

template <int D>
struct LatticePatterns {
  static constexpr int none = -1;
  std::vector<int> of_slice;  ///< slice -> pattern, or `none`
  std::vector<LatticePattern> patterns;
  std::vector<SliceVolumes> volumes;  ///< of each pattern
  std::vector<MirrorPair> mirrored;
  std::vector<SinglePair> single;
  std::vector<Bond<D>> bonds;

  int farthest = 0;  ///< largest distance in places

  int slices() const;  ///< that have a pattern
  /// Adds the slices of another block with their patterns. Blocks share none: what a block computes depends on nothing but itself.
  void append(const LatticePatterns& block);
  /// Distances in places from a particle of a slice to its neighbors.
  std::vector<int> offsets(int pattern, int lane) const;
  std::size_t bytes() const;
};

extern template struct LatticePatterns<2>;
extern template struct LatticePatterns<3>;

}  // namespace sinew
