#include <sinew/core/error.hpp>
#include <sinew/formulations/pair_weights.hpp>
#include <sinew/formulations/slice_weights.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace sinew {

std::string_view name_of(WeightStorage storage) {
  constexpr std::string_view names[] = {"stored", "single", "computed", "automatic"};
  return names[static_cast<int>(storage)];
}

namespace {

template <int D>
[[noreturn]] void too_few_neighbors(const PairSource<D>& source, int slot, std::string_view correction) {
  const Particles<D>& particles = source.particles;
  const Point X = particles.reference(slot);
  throw CaseError(fmt::format(
      "body \"{}\": particle {} at ({:.6g}, {:.6g}, {:.6g}) has {} neighbors, too few (or all in one line) to correct its "
      "gradient. Make [formulation] support larger or spacing smaller, fill the shape there, or choose another correction than "
      "\"{}\".",
      particles.bodies[particles.body_of(slot)].name, particles.user_index[slot], X[0], X[1], X[2],
      source.pairs.neighbor_count[slot], correction));
}

template <int D>
PairWeights<D> room_for(const PairSource<D>& source, const WeightOptions& options) {
  PairWeights<D> w;
  const std::size_t entries = source.pairs.entries() * lanes;
  const std::size_t numbers = options.radial() ? 1 : D;
  if (!options.radial() || options.storage == WeightStorage::stored) {
    w.pairs.gradient = AlignedArray<double>(entries * numbers);
    if (options.hourglass_weights()) w.pairs.hourglass = AlignedArray<double>(entries);
  } else if (options.storage == WeightStorage::single) {
    w.single_pairs.gradient = AlignedArray<float>(entries);
    if (options.hourglass_weights()) w.single_pairs.hourglass = AlignedArray<float>(entries);
  }
  if (options.mutual()) w.pairs.force = AlignedArray<double>(entries * D);
  if (options.average != BondAverage::none) w.pairs.average = AlignedArray<double>(entries);
  if (options.average == BondAverage::mutual) w.pairs.average_of_other = AlignedArray<double>(entries);
  if (options.dissipation) w.pairs.dissipation = AlignedArray<double>(entries);
  return w;
}

template <class Kernel, int D>
BondWeight<double, D, true> bond_weight(const Bond<D>& bond) {
  const RadialWeight<double, true> w = radial_weight<Kernel, true>(bond.X, bond.volume, bond.radius);
  return {w.gradient, w.gradient * bond.X, w.hourglass};
}

/// Numbers the constants of all slices: those of the patterns, then one for each slice with a list. Returns a slice of each pattern.
template <int D>
std::vector<int> number_constants(const BlockPairs<D>& pairs, PairWeights<D>& w) {
  std::vector<int> slice_of(pairs.lattice.patterns.size(), -1);
  int next = static_cast<int>(slice_of.size());
  for (int slice = 0; slice < pairs.blocks.slices(); ++slice) {
    const int pattern = pairs.lattice.of_slice[slice];
    w.constants_of.push_back(pairs.listed(slice) ? next++ : pattern);
    if (!pairs.listed(slice)) slice_of[pattern] = slice;
  }
  w.constants = AlignedArray<SliceConstants<D>>(next);
  if (w.pairs.average.size() > 0) w.own_average = AlignedArray<SymmetricPack<D>>(next);
  return slice_of;
}

/// Weights and constants of all slices with one kernel and one correction.
template <int D, class Kernel, class Correction>
class AllWeights {
 public:
  AllWeights(const PairSource<D>& source, const WeightOptions& options, const Correction& correction, PairWeights<D>& w,
             MapField<D>* maps)
      : source_(source),
        options_(options),
        correction_(correction),
        w_(w),
        maps_(maps) {}

  void fill() {
    for (const Bond<D>& bond : source_.pairs.lattice.bonds) w_.bonds.push_back(bond_weight<Kernel>(bond));
    const std::vector<int> slice_of_pattern = number_constants(source_.pairs, w_);
    most_.assign(w_.constants.size(), {});
    for (std::size_t pattern = 0; pattern < slice_of_pattern.size(); ++pattern)
      if (slice_of_pattern[pattern] >= 0) fill_slice(slice_of_pattern[pattern], source_.pairs.lattice.volumes[pattern], nullptr);
    const std::vector<Block>& blocks = source_.pairs.blocks.all;
#pragma omp parallel if (source_.particles.slots >= fewest_for_threads)
    {
      BlockReference<D> reference(source_.pairs.blocks.most_places());
#pragma omp for schedule(dynamic, 1)
      for (std::size_t b = 0; b < blocks.size(); ++b)
        if (blocks[b].has_list) fill_block(blocks[b], reference);
    }
    if (bad_ < source_.particles.slots) too_few_neighbors(source_, bad_, Correction::name);
    find_most();
  }

  std::vector<int> renew(const Block& block, const std::vector<int>& slices) {
    BlockReference<D> reference(source_.pairs.blocks.most_places());
    reference.take(source_, w_.radius, block);
    std::vector<int> flat;
    for (const int slice : slices) {
      SliceWeights<D, Kernel, Correction> weights(source_, options_, correction_, &reference, w_);
      const unsigned bad = weights.fill(slice, volumes_of(block, slice, reference), least_roundness);
      w_.most_stiffness[block.body] = std::max(w_.most_stiffness[block.body], weights.most().stiffness);
      const int* slots = source_.pairs.blocks.slots_of(block) + source_.pairs.blocks.place_of_slice[slice];
      for (int k = 0; k < lanes; ++k)
        if ((bad >> k & 1U) != 0U) flat.push_back(slots[k]);
    }
    return flat;
  }

 private:
  /// Of the moments of a particle that has lost neighbors, det M / (tr M / D)^D: a line of particles has 0, a plane surface 0.5. With less than that its
  /// deformation gradient would say little.
  static constexpr double least_roundness = 0.05;

  SliceVolumes volumes_of(const Block& block, int slice, const BlockReference<D>& reference) const {
    SliceVolumes volumes{};
    const int place = source_.pairs.blocks.place_of_slice[slice];
    const int* slots = source_.pairs.blocks.slots_of(block) + place;
    for (int k = 0; k < lanes; ++k)
      if (block.owns(slots[k])) volumes[k] = reference.volume[place + k];
    return volumes;
  }

  void fill_block(const Block& block, BlockReference<D>& reference) {
    reference.take(source_, w_.radius, block);
    for (int slice = block.first_slice; slice < block.end_slice; ++slice)
      if (source_.pairs.listed(slice)) fill_slice(slice, volumes_of(block, slice, reference), &reference);
  }

  void fill_slice(int slice, const SliceVolumes& volumes, const BlockReference<D>* reference) {
    SliceWeights<D, Kernel, Correction> weights(source_, options_, correction_, reference, w_, maps_);
    const unsigned bad = weights.fill(slice, volumes, options_.lenient ? least_roundness : 0.0);
    most_[w_.constants_of[slice]] = weights.most();
    if (bad == 0 || options_.lenient) return;
#pragma omp critical
    bad_ = std::min(bad_, first_slot(slice, bad));
  }

  /// Of the lanes of a slice.
  int first_slot(int slice, unsigned which) const {
    const Blocks& blocks = source_.pairs.blocks;
    int first = source_.particles.slots;
    for (const Block& block : blocks.all)
      for (int k = 0; slice >= block.first_slice && slice < block.end_slice && k < lanes; ++k)
        if ((which >> k & 1U) != 0U) first = std::min(first, blocks.slots_of(block)[blocks.place_of_slice[slice] + k]);
    return first;
  }

  void find_most() {
    std::vector<Most> of_body(source_.particles.bodies.size());
    for (const Block& block : source_.pairs.blocks.all)
      for (int slice = block.first_slice; slice < block.end_slice; ++slice)
        of_body[block.body].include(most_[w_.constants_of[slice]]);
    for (const Most& most : of_body) {
      w_.most_stiffness.push_back(most.stiffness);
      w_.most_trace.push_back(most.trace);
      w_.most_slope.push_back(most.slope);
    }
  }

  const PairSource<D>& source_;
  const WeightOptions& options_;
  const Correction& correction_;
  PairWeights<D>& w_;
  MapField<D>* maps_;
  std::vector<Most> most_;             ///< of each set of constants
  int bad_ = source_.particles.slots;  ///< first slot whose neighbors do not allow the correction
};

}  // namespace

template <int D>
PairWeights<D> make_pair_weights(const PairSource<D>& source, const std::vector<double>& support_radius,
                                 const WeightOptions& options, MapField<D>* maps) {
  PairWeights<D> w = room_for(source, options);
  w.radius = AlignedArray<double>(support_radius.size());
  std::copy(support_radius.begin(), support_radius.end(), w.radius.begin());
  std::visit(
      [&]<class Kernel, class Correction>(const Kernel&, const Correction& correction) {
        AllWeights<D, Kernel, Correction>(source, options, correction, w, maps).fill();
      },
      options.kernel, options.correction);
  return w;
}

template <int D>
std::vector<int> renew_weights(const PairSource<D>& source, const Block& block, const std::vector<int>& slices,
                               const WeightOptions& options, PairWeights<D>& weights) {
  return std::visit(
      [&]<class Kernel, class Correction>(const Kernel&, const Correction& correction) {
        return AllWeights<D, Kernel, Correction>(source, options, correction, weights, nullptr).renew(block, slices);
      },
      options.kernel, options.correction);
}

template std::vector<int> renew_weights<2>(const PairSource<2>&, const Block&, const std::vector<int>&, const WeightOptions&,
                                           PairWeights<2>&);
template std::vector<int> renew_weights<3>(const PairSource<3>&, const Block&, const std::vector<int>&, const WeightOptions&,
                                           PairWeights<3>&);
template PairWeights<2> make_pair_weights<2>(const PairSource<2>&, const std::vector<double>&, const WeightOptions&,
                                             MapField<2>*);
template PairWeights<3> make_pair_weights<3>(const PairSource<3>&, const std::vector<double>&, const WeightOptions&,
                                             MapField<3>*);

}  // namespace sinew
