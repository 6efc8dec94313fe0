#include <sinew/formulations/mutual_weights.hpp>

#include <cmath>

namespace sinew {

namespace {

/// Pairs one by one, in double precision: this is done once.
template <int D, class Kernel>
class MutualWeights {
 public:
  MutualWeights(const PairSource<D>& source, const WeightOptions& options, MapField<D>& maps, PairWeights<D>& weights)
      : source_(source),
        options_(options),
        maps_(maps),
        w_(weights) {}

  void fill(const Block& block) {
    const BlockPairs<D>& pairs = source_.pairs;
    const int* slots = pairs.blocks.slots_of(block);
    for (int slice = block.first_slice; slice < block.end_slice; ++slice)
      for (int lane = 0; lane < lanes; ++lane) {
        const int place = pairs.blocks.place_of_slice[slice] + lane;
        if (!block.owns(slots[place])) continue;
        const int i = slots[place];
        const GradientMap<D> own = maps_.get(i);
        for (std::size_t e = pairs.first_entry[slice]; e < pairs.first_entry[slice + 1]; ++e)
          if (const int neighbor = pairs.entry(e)[lane]; neighbor != place) fill_pair(i, slots[neighbor], own, {e, lane});
      }
  }

 private:
  struct Place {
    std::size_t entry;
    int lane;
  };

  void fill_pair(int i, int j, const GradientMap<D>& own, const Place& at) {
    const Vec<double, D> X = source_.particles.position[j] - source_.particles.position[i];
    const double r2 = dot(X, X), r = std::sqrt(r2), R = w_.radius[i];
    const double V_i = source_.particles.volume[i], V_j = source_.particles.volume[j];
    const double W = Kernel::template value<D>(r, R), a = -Kernel::template slope<D>(r, R) / r;
    const GradientMap<D> other = maps_.get(j);
    if (options_.average == BondAverage::mutual) {
      put((own.kernel(V_j * W, X) / r2) * X, at);
      w_.pairs.average_of_other[lanes * at.entry + at.lane] = other.kernel(V_i * W, -X) / r2;
    } else {
      put(0.5 * (own.apply(V_j * a, V_j * W, X) - other.apply(V_j * a, V_j * W, -X)), at);
    }
  }
  void put(const Vec<double, D>& force, const Place& at) {
    for (int c = 0; c < D; ++c) w_.pairs.force[lanes * (D * at.entry + c) + at.lane] = force[c];
  }

  const PairSource<D>& source_;
  const WeightOptions& options_;
  MapField<D>& maps_;
  PairWeights<D>& w_;
};

}  // namespace

template <int D>
void add_mutual_weights(const PairSource<D>& source, const WeightOptions& options, MapField<D>& maps, PairWeights<D>& weights) {
  std::visit(
      [&]<class Kernel>(const Kernel&) {
        MutualWeights<D, Kernel> mutual(source, options, maps, weights);
        const std::vector<Block>& blocks = source.pairs.blocks.all;
#pragma omp parallel for schedule(dynamic, 1) if (source.particles.slots >= fewest_for_threads)
        for (std::size_t b = 0; b < blocks.size(); ++b) mutual.fill(blocks[b]);
      },
      options.kernel);
}

template void add_mutual_weights<2>(const PairSource<2>&, const WeightOptions&, MapField<2>&, PairWeights<2>&);
template void add_mutual_weights<3>(const PairSource<3>&, const WeightOptions&, MapField<3>&, PairWeights<3>&);

}  // namespace sinew
