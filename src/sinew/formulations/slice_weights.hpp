#pragma once
/// Weights and correction of the eight particles of a slice, from their neighbors in the reference configuration.

#include <sinew/formulations/pair_weights.hpp>

namespace sinew {

/// Everything that the neighbors of eight particles say about them.
template <int D>
struct NeighborSums {
  Pack shepard{0.0};        ///< sum V_j W_ij, the particle itself included [1]
  Vec<Pack, D> gradient;    ///< sum V_j a_ij X_ij [1/length]
  Mat<Pack, D> moment;      ///< sum V_j a_ij X_ij (x) X_ij [1]
  Pack hourglass{0.0};      ///< sum of the hourglass weights before their scale [1/length^2]
  Pack nearest2{infinity};  ///< squared distance of the nearest neighbor [length^2]

  Moments<D> lane(int k) const {
    Moments<D> m{shepard[k], {}, {}};
    for (int i = 0; i < D; ++i) {
      m.gradient_sum[i] = gradient[i][k];
      for (int j = 0; j < D; ++j) m.first[i][j] = moment[i][j][k];
    }
    return m;
  }
};

template <int D, class Kernel, class Correction>
class SliceWeights {
 public:
  SliceWeights(const PairSource<D>& source, const WeightOptions& options, const Correction& correction, PairWeights<D>& weights)
      : source_(source),
        options_(options),
        correction_(correction),
        w_(weights) {}

  /// Fills weights and constants of a slice. Returns the first slot whose neighbors do not allow the correction, or the number of slots.
  int fill(int slice) {
    const NeighborSums<D> sums = sum_neighbors(slice);
    int bad = source_.particles.slots;
    Vec<Pack, D> shift;
    Pack scale(0.0);
    Mat<Pack, D> L;
    for (int k = lanes - 1; k >= 0; --k) {
      const int slot = lanes * slice + k;
      if (source_.particles.user_index[slot] < 0) continue;
      const GradientMap<D> map = correction_.map(sums.lane(k));
      if (!map.valid) bad = slot;
      scale.set(k, map.scale);
      for (int i = 0; i < D; ++i) {
        shift[i].set(k, map.shift[i]);
        for (int j = 0; j < D; ++j) L[i][j].set(k, map.L[i][j]);
      }
      finish(slice, k, sums);
    }
    if constexpr (Correction::radial)
      store(L, slice);
    else
      store_vectors(slice, L, scale, shift);
    return bad;
  }
  /// Largest sum of the hourglass weights of one of the particles [1/length^2].
  double most_stiffness() const { return most_stiffness_; }

 private:
  /// use(entry, X_ij, V_j) for all neighbors; X = 0 where a particle has fewer than the others. `entry`: of the list, if there is one.
  template <class Use>
  void for_each_neighbor(int slice, Use&& use) const {
    const int pattern = source_.lattice.of_slice[slice];
    if (pattern == LatticePatterns<D>::none) return for_each_listed(slice, use);
    const LatticePattern& p = source_.lattice.patterns[pattern];
    for (int k = p.first_mirrored; k < p.end_mirrored; ++k) {
      const Bond<D>& bond = source_.lattice.bonds[source_.lattice.mirrored[k].bond];
      const Vec<Pack, D> X = everywhere(bond.X, PackMask::from_bits(0xff));
      use(std::size_t{0}, X, Pack(bond.volume));
      use(std::size_t{0}, -X, Pack(bond.volume));
    }
    for (int k = p.first_single; k < p.end_single; ++k) {
      const Bond<D>& bond = source_.lattice.bonds[source_.lattice.single[k].bond];
      use(std::size_t{0}, everywhere(bond.X, PackMask::from_bits(source_.lattice.single[k].members)), Pack(bond.volume));
    }
  }
  template <class Use>
  void for_each_listed(int slice, Use&& use) const {
    const Particles<D>& particles = source_.particles;
    Vec<Pack, D> own;
    for (int c = 0; c < D; ++c) own[c] = Pack::load(particles.position.component(c) + lanes * slice);
    for (std::size_t e = source_.list.first_entry[slice]; e < source_.list.first_entry[slice + 1]; ++e) {
      const int* index = source_.list.entry(e);
      Vec<Pack, D> X;
      for (int c = 0; c < D; ++c) X[c] = Pack::gather(particles.position.component(c), index) - own[c];
      use(e, X, Pack::gather(particles.volume.data(), index));
    }
  }
  static Vec<Pack, D> everywhere(const Vec<double, D>& X, PackMask mask) {
    Vec<Pack, D> all;
    for (int c = 0; c < D; ++c) all[c] = select(mask, Pack(X[c]), Pack(0.0));
    return all;
  }
  Pack radius(int slice) const { return Pack::load(w_.radius.data() + lanes * slice); }

  NeighborSums<D> sum_neighbors(int slice) {
    NeighborSums<D> sums;
    const Pack R = radius(slice);
    if constexpr (!Correction::radial)
      sums.shepard = Pack::load(source_.particles.volume.data() + lanes * slice) * Kernel::template value<D>(Pack(0.0), R);
    const bool listed = source_.lattice.of_slice[slice] == LatticePatterns<D>::none;
    const bool central = options_.hourglass == HourglassWeight::central;
    for_each_neighbor(slice, [&](std::size_t entry, const Vec<Pack, D>& X, const Pack& V) {
      RadialWeight<Pack, true> w = radial_weight<Kernel, true>(X, V, R);
      if (Correction::radial && listed) keep(entry, w);
      const Pack r2 = dot(X, X);
      sums.gradient += w.gradient * X;
      sums.moment += outer(w.gradient * X, X);
      sums.hourglass += central ? w.hourglass : w.gradient;
      sums.nearest2 = min(sums.nearest2, select(r2 > Pack(0.0), r2, Pack(infinity)));
      if constexpr (!Correction::radial)
        sums.shepard += select(r2 > Pack(0.0), V * Kernel::template value<D>(sqrt(r2), R), Pack(0.0));
    });
    return sums;
  }

  /// Stores the weights of eight pairs and rounds them as they are stored.
  void keep(std::size_t entry, RadialWeight<Pack, true>& w) {
    const auto put = [entry](auto& array, Pack& value) {
      if (array.size() == 0) return;
      for (int k = 0; k < lanes; ++k) {
        array[lanes * entry + k] = static_cast<std::decay_t<decltype(array[0])>>(value[k]);
        value.set(k, array[lanes * entry + k]);
      }
    };
    put(w_.pairs.gradient, w.gradient);
    put(w_.pairs.hourglass, w.hourglass);
    put(w_.single_pairs.gradient, w.gradient);
    put(w_.single_pairs.hourglass, w.hourglass);
  }

  /// g_ij = L (scale a_ij X_ij) - W_ij shift, times V_j; and the hourglass weights.
  void store_vectors(int slice, const Mat<Pack, D>& L, const Pack& scale, const Vec<Pack, D>& shift) {
    const Pack R = radius(slice);
    store(Mat<Pack, D>::identity(), slice);
    for_each_neighbor(slice, [&](std::size_t entry, const Vec<Pack, D>& X, const Pack& V) {
      const RadialWeight<Pack, true> w = radial_weight<Kernel, true>(X, V, R);
      const Pack r2 = dot(X, X);
      const Pack VW = select(r2 > Pack(0.0), V * Kernel::template value<D>(sqrt(r2), R), Pack(0.0));
      const Vec<Pack, D> g = (scale * w.gradient) * (L * X) - VW * shift;
      for (int c = 0; c < D; ++c) g[c].store(w_.pairs.gradient.data() + lanes * (D * entry + c));
      if (!options_.hourglass_weights()) return;
      const Pack weight = options_.hourglass == HourglassWeight::central ? w.hourglass : w.gradient;
      weight.store(w_.pairs.hourglass.data() + lanes * entry);
    });
  }

  SliceConstants<D>& constants(int slice) { return w_.constants[w_.constants_of[slice]]; }

  void store(const Mat<Pack, D>& L, int slice) {
    for (int i = 0, c = 0; i < D; ++i)
      for (int j = i; j < D; ++j, ++c) constants(slice).correction[c] = L[i][j];
  }

  /// The other constants of one particle.
  void finish(int slice, int k, const NeighborSums<D>& sums) {
    SliceConstants<D>& own = constants(slice);
    const double volume = source_.particles.volume[lanes * slice + k];
    const double size = std::pow(volume, 1.0 / D);
    double trace = 0.0;
    for (int i = 0; i < D; ++i) trace += sums.moment[i][i][k];
    double scale = options_.hourglass == HourglassWeight::central ? 1.0 : 0.0;
    if (options_.hourglass == HourglassWeight::conservative && trace > 0.0) scale = 1.0 / trace;
    own.volume.set(k, volume);
    own.inverse_length2.set(k, 1.0 / std::min(sums.nearest2[k], size * size));
    own.hourglass_scale.set(k, scale);
    most_stiffness_ = std::max(most_stiffness_, sums.hourglass[k] * scale);
  }

  const PairSource<D>& source_;
  const WeightOptions& options_;
  const Correction& correction_;
  PairWeights<D>& w_;
  double most_stiffness_ = 0.0;
};

}  // namespace sinew
