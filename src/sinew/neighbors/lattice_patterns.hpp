#pragma once
/// Regular arrangements without a pair list. Where particles stand in lattice rows, the eight particles of a slice have their neighbors at the
/// same distances in the computing order and at the same X_ij, but for those that are missing at a surface. Such a slice needs only the number
/// of its pattern; a body made of boxes has a few hundred of them. A slice that fits no pattern stays in the pair list: which way a slice goes is
/// a property of the particles, not of the formulation, and changes results by rounding only.

#include <cstdint>
#include <sinew/neighbors/pair_list.hpp>
#include <vector>

namespace sinew {

/// What all pairs of one kind have in common.
template <int D>
struct Bond {
  Vec<double, D> X;     ///< X_j - X_i [length]
  double volume = 0.0;  ///< V_j [length^D]
  double radius = 0.0;  ///< R_i, the support radius [length]
};

/// All eight particles have a neighbor at `forward` slots from them with X_ij = X of the bond, and one at `backward` with X_ij = -X.
struct MirrorPair {
  int forward, backward, bond;
};
/// Those particles whose bit is set in `members` have a neighbor at `offset` slots from them.
struct SinglePair {
  int offset, bond;
  std::uint8_t members;
};

/// Pairs of a slice: ranges of LatticePatterns::mirrored and ::single.
struct LatticePattern {
  int first_mirrored = 0, end_mirrored = 0, first_single = 0, end_single = 0;
};

template <int D>
struct LatticePatterns {
  static constexpr int none = -1;
  std::vector<int> of_slice;  ///< slice -> pattern, or `none`
  std::vector<LatticePattern> patterns;
  std::vector<MirrorPair> mirrored;
  std::vector<SinglePair> single;
  std::vector<Bond<D>> bonds;

  int slices() const;  ///< that have a pattern
  std::size_t bytes() const;
};

/// Finds the patterns. A body of which less than half of the slices have one keeps its pair list whole.
template <int D>
LatticePatterns<D> find_lattice_patterns(const Particles<D>& particles, const PairList& list,
                                         const std::vector<double>& support_radius);

/// No slice has a pattern.
template <int D>
LatticePatterns<D> no_lattice_patterns(const Particles<D>& particles);

/// Takes the entries of slices that have a pattern out of the list; the counts stay.
template <int D>
void drop_lattice_slices(PairList& list, const LatticePatterns<D>& lattice);

/// The slots of the neighbors of one particle, ascending, wherever they are kept.
template <int D>
std::vector<int> neighbors_of(int slot, const PairList& list, const LatticePatterns<D>& lattice);

}  // namespace sinew
