#pragma once
/// The loops over pairs of a slice that has a lattice pattern, eight particles at once. A neighbor of eight particles is one unaligned load, its X
/// and weight are constants of the bond, and a pair shares work with its mirror image.

#include <sinew/neighbors/block_pairs.hpp>

namespace sinew {

/// What the loops read and write.
template <int D>
struct LatticePairsData {
  const BlockPairs<D>& pairs;
  const double* displacement[D];  ///< by place
  const double* velocity[D];      ///< by place; only for exchange_moving
  double* forces[D];              ///< by place
};

/// One slice at a time, with the same members as ListedPairs. `Weights`: weights.of(bond) gives the weight of the bond.
template <int D, class Weights>
class LatticePairs {
 public:
  using Weight = typename Weights::Weight;
  static constexpr bool listed = false, vectors = false;
  static constexpr int slices_together = 4;  ///< whose first visits may come before their other visits

  SINEW_INLINE LatticePairs(const LatticePairsData<D>& data, const Weights& weights)
      : weights_(weights),
        patterns_(data.pairs.lattice.patterns.data()),
        of_slice_(data.pairs.lattice.of_slice.data()),
        place_of_slice_(data.pairs.blocks.place_of_slice.data()),
        mirrored_(data.pairs.lattice.mirrored.data()),
        single_(data.pairs.lattice.single.data()),
        bonds_(data.pairs.lattice.bonds.data()) {
    for (int c = 0; c < D; ++c) {
      u_[c] = data.displacement[c];
      v_[c] = data.velocity[c];
      f_[c] = data.forces[c];
    }
  }

  SINEW_INLINE void enter(int slice) {
    pattern_ = patterns_[of_slice_[slice]];
    place_ = place_of_slice_[slice];
    for (int c = 0; c < D; ++c) own_[c] = Pack::load(u_[c] + place_);
  }

  /// use(weight, u, X), linear in u and odd in X: for a pair and its mirror image it is called once, with the difference of both u.
  template <class Use>
  SINEW_INLINE void first_visit(Use&& use) const {
    for (int k = pattern_.first_mirrored; k < pattern_.end_mirrored; ++k) {
      const MirrorPair& pair = mirrored_[k];
      use(weights_.of(pair.bond), at(pair.forward) - at(pair.backward), bond_vector(pair.bond));
    }
    for (int k = pattern_.first_single; k < pattern_.end_single; ++k) {
      const SinglePair& pair = single_[k];
      use(masked(pair), at(pair.offset) - own_, bond_vector(pair.bond));
    }
  }

  /// use(weight, u_ij, X_ij), pair by pair; the weight is 0 where there is no neighbor.
  template <class Use>
  SINEW_INLINE void visit(Use&& use) const {
    for (int k = pattern_.first_mirrored; k < pattern_.end_mirrored; ++k) {
      const MirrorPair& pair = mirrored_[k];
      use(weights_.of(pair.bond), at(pair.forward) - own_, bond_vector(pair.bond));
      use(weights_.of(pair.bond).reversed(), at(pair.backward) - own_, -bond_vector(pair.bond));
    }
    for (int k = pattern_.first_single; k < pattern_.end_single; ++k) {
      const SinglePair& pair = single_[k];
      use(masked(pair), at(pair.offset) - own_, bond_vector(pair.bond));
    }
  }

  /// Adds t = share(weight, u_ij, X_ij) to i and subtracts it from j.
  template <class Share>
  SINEW_INLINE void exchange(Share& share) const {
    Vec<Pack, D> total;
    for (int k = pattern_.first_mirrored; k < pattern_.end_mirrored; ++k) {
      const MirrorPair& pair = mirrored_[k];
      const auto t =
          share.mirrored(weights_.of(pair.bond), at(pair.forward) - own_, at(pair.backward) - own_, bond_vector(pair.bond));
      subtract(pair.forward, t.forward);
      subtract(pair.backward, t.backward);
      total += t.forward + t.backward;
    }
    for (int k = pattern_.first_single; k < pattern_.end_single; ++k) {
      const SinglePair& pair = single_[k];
      const Vec<Pack, D> t = share(masked(pair), at(pair.offset) - own_, bond_vector(pair.bond));
      subtract(pair.offset, t);
      total += t;
    }
    subtract(0, -total);
  }

  /// The same with t = share(weight, u_ij, v_ij, X_ij), v_ij the difference of the velocities.
  template <class Share>
  SINEW_INLINE void exchange_moving(Share& share) const {
    Vec<Pack, D> total;
    const Vec<Pack, D> own = velocity_at(0);
    const auto give = [&](const Weight& weight, int offset, const Vec<Pack, D>& X) {
      const Vec<Pack, D> t = share(weight, at(offset) - own_, velocity_at(offset) - own, X);
      subtract(offset, t);
      total += t;
    };
    for (int k = pattern_.first_mirrored; k < pattern_.end_mirrored; ++k) {
      const MirrorPair& pair = mirrored_[k];
      give(weights_.of(pair.bond), pair.forward, bond_vector(pair.bond));
      give(weights_.of(pair.bond).reversed(), pair.backward, -bond_vector(pair.bond));
    }
    for (int k = pattern_.first_single; k < pattern_.end_single; ++k)
      give(masked(single_[k]), single_[k].offset, bond_vector(single_[k].bond));
    subtract(0, -total);
  }

 private:
  SINEW_INLINE Vec<Pack, D> at(int offset) const {
    Vec<Pack, D> u;
    for (int c = 0; c < D; ++c) u[c] = Pack::load_unaligned(u_[c] + place_ + offset);
    return u;
  }
  SINEW_INLINE Vec<Pack, D> velocity_at(int offset) const {
    Vec<Pack, D> v;
    for (int c = 0; c < D; ++c) v[c] = Pack::load_unaligned(v_[c] + place_ + offset);
    return v;
  }
  SINEW_INLINE Vec<Pack, D> bond_vector(int bond) const {
    Vec<Pack, D> X;
    for (int c = 0; c < D; ++c) X[c] = Pack(bonds_[bond].X[c]);
    return X;
  }
  SINEW_INLINE Weight masked(const SinglePair& pair) const {
    return weights_.of(pair.bond).only(PackMask::from_bits(pair.members));
  }
  SINEW_INLINE void subtract(int offset, const Vec<Pack, D>& t) const {
    for (int c = 0; c < D; ++c) {
      double* f = f_[c] + place_ + offset;
      (Pack::load_unaligned(f) - t[c]).store_unaligned(f);
    }
  }

  const Weights weights_;
  const LatticePattern* patterns_;
  const int* of_slice_;
  const int* place_of_slice_;
  const MirrorPair* mirrored_;
  const SinglePair* single_;
  const Bond<D>* bonds_;
  const double* u_[D];
  const double* v_[D];
  double* f_[D];
  LatticePattern pattern_;
  std::ptrdiff_t place_ = 0;
  Vec<Pack, D> own_;
};

}  // namespace sinew
