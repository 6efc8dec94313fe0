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
      source.list.neighbor_count[slot], correction));
}

template <int D>
PairWeights<D> room_for(const PairSource<D>& source, const WeightOptions& options) {
  PairWeights<D> w;
  const std::size_t entries = source.list.entries() * lanes;
  const std::size_t numbers = options.radial() ? 1 : D;
  if (!options.radial() || options.storage == WeightStorage::stored) {
    w.pairs.gradient = AlignedArray<double>(entries * numbers);
    if (options.hourglass_weights()) w.pairs.hourglass = AlignedArray<double>(entries);
  } else if (options.storage == WeightStorage::single) {
    w.single_pairs.gradient = AlignedArray<float>(entries);
    if (options.hourglass_weights()) w.single_pairs.hourglass = AlignedArray<float>(entries);
  }
  w.radius = AlignedArray<double>(source.particles.slots);
  return w;
}

template <class Kernel, int D>
BondWeight<double, D, true> bond_weight(const Bond<D>& bond) {
  const RadialWeight<double, true> w = radial_weight<Kernel, true>(bond.X, bond.volume, bond.radius);
  return {w.gradient, w.gradient * bond.X, w.hourglass};
}

/// Numbers the constants of all slices. Returns the first slice of each.
template <int D>
std::vector<int> number_constants(const PairSource<D>& source, PairWeights<D>& w) {
  std::vector<int> first(source.lattice.patterns.size(), -1);
  for (int slice = 0; slice < source.list.slices(); ++slice) {
    const int pattern = source.lattice.of_slice[slice];
    const bool regular = pattern != LatticePatterns<D>::none;
    w.constants_of.push_back(regular ? pattern : static_cast<int>(first.size()));
    if (!regular)
      first.push_back(slice);
    else if (first[pattern] < 0)
      first[pattern] = slice;
  }
  w.constants = AlignedArray<SliceConstants<D>>(first.size());
  return first;
}

}  // namespace

template <int D>
PairWeights<D> make_pair_weights(const PairSource<D>& source, const std::vector<double>& support_radius,
                                 const WeightOptions& options) {
  PairWeights<D> w = room_for(source, options);
  std::copy(support_radius.begin(), support_radius.end(), w.radius.begin());
  const std::vector<int> first_slice = number_constants(source, w);
  std::vector<double> stiffness(first_slice.size(), 0.0);  // largest sum of the hourglass weights
  int bad = source.particles.slots;
  std::visit(
      [&]<class Kernel, class Correction>(const Kernel&, const Correction& correction) {
        for (const Bond<D>& bond : source.lattice.bonds) w.bonds.push_back(bond_weight<Kernel>(bond));
#pragma omp parallel for schedule(dynamic, 64) reduction(min : bad)
        for (std::size_t k = 0; k < first_slice.size(); ++k) {
          if (first_slice[k] < 0) continue;
          SliceWeights<D, Kernel, Correction> slice(source, options, correction, w);
          bad = std::min(bad, slice.fill(first_slice[k]));
          stiffness[k] = slice.most_stiffness();
        }
        if (bad < source.particles.slots) too_few_neighbors(source, bad, Correction::name);
      },
      options.kernel, options.correction);
  for (const BodyRange& body : source.particles.bodies) {
    double most = 0.0;
    for (int slice = body.begin / lanes; slice < body.end / lanes; ++slice)
      most = std::max(most, stiffness[w.constants_of[slice]]);
    w.most_stiffness.push_back(most);
  }
  return w;
}

template PairWeights<2> make_pair_weights<2>(const PairSource<2>&, const std::vector<double>&, const WeightOptions&);
template PairWeights<3> make_pair_weights<3>(const PairSource<3>&, const std::vector<double>&, const WeightOptions&);

}  // namespace sinew
