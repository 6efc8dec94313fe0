#pragma once
/// Weights and correction of the eight particles of a slice, from their neighbors in the reference configuration.

#include <sinew/formulations/pair_weights.hpp>

namespace sinew {

template <int D>
Vec<double, D> lane_of(const Vec<Pack, D>& v, int k) {
  Vec<double, D> lane;
  for (int i = 0; i < D; ++i) lane[i] = v[i][k];
  return lane;
}
template <int D>
Mat<double, D> lane_of(const Mat<Pack, D>& m, int k) {
  Mat<double, D> lane;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) lane[i][j] = m[i][j][k];
  return lane;
}

/// Everything that the neighbors of eight particles say about them.
template <int D>
struct NeighborSums {
  Pack shepard{0.0};        ///< sum V_j W_ij, the particle itself included [1]
  Vec<Pack, D> gradient;    ///< sum V_j a_ij X_ij [1/length]
  Mat<Pack, D> moment;      ///< sum V_j a_ij X_ij (x) X_ij [1]
  Pack hourglass{0.0};      ///< sum of the hourglass weights before their scale [1/length^2]
  Pack slope{0.0};          ///< sum V_j a_ij [1/length^2]
  Pack nearest2{infinity};  ///< squared distance of the nearest neighbor [length^2]
  // for corrections that ask for them, see Moments
  Vec<Pack, D> kernel_first;
  Mat<Pack, D> kernel_second, second[D];

  void add_higher(const Vec<Pack, D>& X, const Pack& VW, const Pack& Va) {
    kernel_first += VW * X;
    kernel_second += outer(VW * X, X);
    for (int g = 0; g < D; ++g) second[g] += outer((Va * X[g]) * X, X);
  }
  Moments<D> lane(int k) const {
    Moments<D> m;
    m.shepard_sum = shepard[k];
    m.gradient_sum = lane_of(gradient, k);
    m.first = lane_of(moment, k);
    m.kernel_first = lane_of(kernel_first, k);
    m.kernel_second = lane_of(kernel_second, k);
    for (int g = 0; g < D; ++g) m.second[g] = lane_of(second[g], k);
    return m;
  }
};

/// GradientMap of eight particles.
template <int D>
struct GradientMaps {
  Mat<Pack, D> L, bend;
  Vec<Pack, D> shift, tilt;
  Pack scale{0.0}, kernel_scale{0.0};

  void set(int k, const GradientMap<D>& map) {
    scale.set(k, map.scale);
    kernel_scale.set(k, map.kernel_scale);
    for (int i = 0; i < D; ++i) {
      shift[i].set(k, map.shift[i]);
      tilt[i].set(k, map.tilt[i]);
      for (int j = 0; j < D; ++j) {
        L[i][j].set(k, map.L[i][j]);
        bend[i][j].set(k, map.bend[i][j]);
      }
    }
  }
  Vec<Pack, D> apply(const Pack& a, const Pack& W, const Vec<Pack, D>& X) const {
    return ((scale + dot(tilt, X)) * a) * (L * X) - W * (shift + bend * X);
  }
  Pack kernel(const Pack& W, const Vec<Pack, D>& X) const { return W * (kernel_scale + dot(tilt, X)); }
};

/// The reference configuration of a block by place. One for each thread; it keeps its memory.
template <int D>
struct BlockReference {
  VectorField<D> position;
  AlignedArray<double> volume, radius;
  const int* slots = nullptr;

  explicit BlockReference(int most_places) : position(most_places), volume(most_places), radius(most_places) {}
  void take(const PairSource<D>& source, const AlignedArray<double>& support_radius, const Block& block) {
    slots = source.pairs.blocks.slots_of(block);
    for (int place = 0; place < block.places; ++place) {
      const int slot = slots[place];
      for (int c = 0; c < D; ++c) position.at(c, place) = slot < 0 ? 0.0 : source.particles.position.at(c, slot);
      volume[place] = slot < 0 ? 0.0 : source.particles.volume[slot];
      radius[place] = block.owns(slot) ? support_radius[slot] : 1.0;
    }
  }
};

/// The largest of one of some particles.
struct Most {
  double stiffness = 0.0;  ///< sum of its hourglass weights [1/length^2]
  double trace = 0.0;      ///< of its moments [1]
  double slope = 0.0;      ///< sum V_j a_ij [1/length^2]

  void include(const Most& other) {
    stiffness = std::max(stiffness, other.stiffness);
    trace = std::max(trace, other.trace);
    slope = std::max(slope, other.slope);
  }
};

template <int D, class Kernel, class Correction>
class SliceWeights {
 public:
  /// `reference`: of the block of the slice; nullptr for slices with a pattern only.
  SliceWeights(const PairSource<D>& source, const WeightOptions& options, const Correction& correction,
               const BlockReference<D>* reference, PairWeights<D>& weights, MapField<D>* kept_maps = nullptr)
      : source_(source),
        options_(options),
        correction_(correction),
        reference_(reference),
        w_(weights),
        kept_maps_(kept_maps) {}

  /// Fills weights and constants of a slice. Returns the lanes whose neighbors do not allow the correction, or whose moments are less round than that:
  /// det M / (tr M / D)^D.
  unsigned fill(int slice, const SliceVolumes& volumes, double least_roundness = 0.0) {
    const NeighborSums<D> sums = sum_neighbors(slice, volumes);
    unsigned bad = 0;
    GradientMaps<D> maps;
    for (int k = lanes - 1; k >= 0; --k) {
      if (volumes[k] == 0.0) continue;
      GradientMap<D> map = correction_.map(sums.lane(k));
      if (!map.valid || roundness(sums.lane(k).first) < least_roundness) {
        bad |= 1U << k;
        if (options_.lenient) map = GradientMap<D>::nothing();
      }
      maps.set(k, map);
      if (kept_maps_) kept_maps_->set(reference_->slots[source_.pairs.blocks.place_of_slice[slice] + k], map);
      finish(slice, k, volumes[k], sums, options_.lenient && (bad >> k & 1U) != 0U);
    }
    if (options_.radial())
      constants(slice).correction.set(maps.L);
    else
      store_vectors(slice, maps, volumes);
    return bad;
  }
  const Most& most() const { return most_; }

 private:
  /// use(entry, X_ij, V_j, R_i) for all neighbors; X = 0 where a particle has fewer than the others. `entry`: of the list, if there is one.
  template <class Use>
  void for_each_neighbor(int slice, Use&& use) const {
    if (source_.pairs.listed(slice)) return for_each_listed(slice, use);
    const LatticePatterns<D>& lattice = source_.pairs.lattice;
    const LatticePattern& p = lattice.patterns[lattice.of_slice[slice]];
    for (int k = p.first_mirrored; k < p.end_mirrored; ++k) {
      const Bond<D>& bond = lattice.bonds[lattice.mirrored[k].bond];
      const Vec<Pack, D> X = everywhere(bond.X, PackMask::from_bits(0xff));
      use(std::size_t{0}, X, Pack(bond.volume), Pack(bond.radius));
      use(std::size_t{0}, -X, Pack(bond.volume), Pack(bond.radius));
    }
    for (int k = p.first_single; k < p.end_single; ++k) {
      const Bond<D>& bond = lattice.bonds[lattice.single[k].bond];
      use(std::size_t{0}, everywhere(bond.X, PackMask::from_bits(lattice.single[k].members)), Pack(bond.volume),
          Pack(bond.radius));
    }
  }
  template <class Use>
  void for_each_listed(int slice, Use&& use) const {
    const VectorField<D>& position = reference_->position;
    const int place = source_.pairs.blocks.place_of_slice[slice];
    const Pack R = Pack::load(reference_->radius.data() + place);
    Vec<Pack, D> own;
    for (int c = 0; c < D; ++c) own[c] = Pack::load(position.component(c) + place);
    for (std::size_t e = source_.pairs.first_entry[slice]; e < source_.pairs.first_entry[slice + 1]; ++e) {
      const PlaceIndex* index = source_.pairs.entry(e);
      Vec<Pack, D> X;
      for (int c = 0; c < D; ++c) X[c] = Pack::gather(position.component(c), index) - own[c];
      use(e, X, Pack::gather(reference_->volume.data(), index), R);
    }
  }
  static Vec<Pack, D> everywhere(const Vec<double, D>& X, PackMask mask) {
    Vec<Pack, D> all;
    for (int c = 0; c < D; ++c) all[c] = select(mask, Pack(X[c]), Pack(0.0));
    return all;
  }
  Pack radius(int slice) const { return Pack::load(reference_->radius.data() + source_.pairs.blocks.place_of_slice[slice]); }

  NeighborSums<D> sum_neighbors(int slice, const SliceVolumes& volumes) {
    NeighborSums<D> sums;
    if (!options_.radial())
      sums.shepard = Pack::load_unaligned(volumes.data()) * Kernel::template value<D>(Pack(0.0), radius(slice));
    const bool listed = source_.pairs.listed(slice);
    const bool central = options_.hourglass == HourglassWeight::central;
    for_each_neighbor(slice, [&](std::size_t entry, const Vec<Pack, D>& X, const Pack& V, const Pack& R) {
      RadialWeight<Pack, true> w = radial_weight<Kernel, true>(X, V, R);
      if (options_.radial() && listed) keep(entry, w);
      if (options_.dissipation && listed) w.gradient.store(w_.pairs.dissipation.data() + lanes * entry);
      const Pack r2 = dot(X, X);
      sums.gradient += w.gradient * X;
      sums.moment += outer(w.gradient * X, X);
      sums.hourglass += central ? w.hourglass : w.gradient;
      sums.slope += w.gradient;
      sums.nearest2 = min(sums.nearest2, select(r2 > Pack(0.0), r2, Pack(infinity)));
      if (!options_.radial()) sums.shepard += select(r2 > Pack(0.0), V * Kernel::template value<D>(sqrt(r2), R), Pack(0.0));
      if constexpr (Correction::higher_moments) sums.add_higher(X, V * Kernel::template value<D>(sqrt(r2), R), w.gradient);
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

  /// V_j g_ij, the hourglass weights, and those of averages.
  void store_vectors(int slice, const GradientMaps<D>& maps, const SliceVolumes& volumes) {
    constants(slice).correction.set(Mat<Pack, D>::identity());
    if (options_.average != BondAverage::none) store_averages(slice, maps, volumes);
    for_each_neighbor(slice, [&](std::size_t entry, const Vec<Pack, D>& X, const Pack& V, const Pack& R) {
      const RadialWeight<Pack, true> w = radial_weight<Kernel, true>(X, V, R);
      const Pack r2 = dot(X, X);
      const Pack VW = select(r2 > Pack(0.0), V * Kernel::template value<D>(sqrt(r2), R), Pack(0.0));
      const Vec<Pack, D> g = maps.apply(w.gradient, VW, X);
      for (int c = 0; c < D; ++c) g[c].store(w_.pairs.gradient.data() + lanes * (D * entry + c));
      if (!options_.hourglass_weights()) return;
      const Pack weight = options_.hourglass == HourglassWeight::central ? w.hourglass : w.gradient;
      weight.store(w_.pairs.hourglass.data() + lanes * entry);
    });
  }

  /// V_j W1_ij / r_ij^2, and what a particle's own gradient counts in its average.
  void store_averages(int slice, const GradientMaps<D>& maps, const SliceVolumes& volumes) {
    const Pack W0 = Kernel::template value<D>(Pack(0.0), radius(slice));
    const Mat<Pack, D> I = Mat<Pack, D>::identity();
    Mat<Pack, D> own = (Pack::load_unaligned(volumes.data()) * W0 * maps.kernel_scale) * I;
    for_each_neighbor(slice, [&](std::size_t entry, const Vec<Pack, D>& X, const Pack& V, const Pack& R) {
      const Pack r2 = dot(X, X);
      const auto apart = r2 > Pack(0.0);
      const Pack w = maps.kernel(V * Kernel::template value<D>(sqrt(r2), R), X);
      const Pack b = select(apart, w / select(apart, r2, Pack(1.0)), Pack(0.0));
      b.store(w_.pairs.average.data() + lanes * entry);
      own += (0.5 * b) * (r2 * I - outer(X, X));
    });
    w_.own_average[w_.constants_of[slice]].set(own);
  }

  SliceConstants<D>& constants(int slice) { return w_.constants[w_.constants_of[slice]]; }

  /// The other constants of one particle.
  void finish(int slice, int k, double volume, const NeighborSums<D>& sums, bool alone) {
    SliceConstants<D>& own = constants(slice);
    const double size = options_.by_distance ? infinity : std::pow(volume, 1.0 / D);
    double trace = 0.0;
    for (int i = 0; i < D; ++i) trace += sums.moment[i][i][k];
    double scale = options_.hourglass == HourglassWeight::central ? 1.0 : 0.0;
    if (options_.hourglass == HourglassWeight::conservative && trace > 0.0) scale = 1.0 / trace;
    if (alone) scale = 0.0;
    own.volume.set(k, volume);
    own.inverse_length2.set(k, 1.0 / std::min(sums.nearest2[k], size * size));
    own.hourglass_scale.set(k, scale);
    most_.stiffness = std::max(most_.stiffness, sums.hourglass[k] * scale);
    most_.trace = std::max(most_.trace, trace);
    most_.slope = std::max(most_.slope, sums.slope[k]);
  }

  const PairSource<D>& source_;
  const WeightOptions& options_;
  const Correction& correction_;
  const BlockReference<D>* reference_;
  PairWeights<D>& w_;
  MapField<D>* kept_maps_;
  Most most_;
};

}  // namespace sinew
