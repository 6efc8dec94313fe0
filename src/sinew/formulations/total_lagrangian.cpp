#include <sinew/formulations/sweep_dispatch.hpp>
#include <sinew/formulations/total_lagrangian.hpp>

#include <algorithm>
#include <cmath>

namespace sinew {

namespace {

double density_of(const AnyMaterial& material) {
  return std::visit([](const auto& m) { return m.density; }, material);
}
double youngs_modulus_of(const AnyMaterial& material) {
  return std::visit([](const auto& m) { return m.elastic.youngs_modulus; }, material);
}

/// 2 / omega of the stiffest hourglass mode. Each pair has the shares of both ends, and a mode may move both ends against each other:
/// omega^2 <= 4 c E / rho sum_j w_ij, c the coefficient and w_ij the weights; only 1/D of it where the force is along the pair.
template <int D>
double hourglass_limit(const Particles<D>& particles, const PairWeights<D>& weights, const TotalLagrangianOptions& options) {
  double omega2 = 0.0;
  for (std::size_t b = 0; b < particles.bodies.size(); ++b) {
    const AnyMaterial& material = options.materials[b];
    const double stiffness = options.hourglass->coefficient() * youngs_modulus_of(material) * weights.most_stiffness[b];
    omega2 = std::max(omega2, 4.0 * stiffness / density_of(material) / (options.hourglass->conservative() ? 1.0 : D));
  }
  return omega2 > 0.0 ? 2.0 / std::sqrt(omega2) : infinity;
}

}  // namespace

template <int D>
TotalLagrangian<D>::TotalLagrangian(const Particles<D>& particles, const std::vector<double>& support_radius,
                                    TotalLagrangianOptions options)
    : options_(std::move(options)),
      pairs_(make_block_pairs(particles, build_pair_list(particles, support_radius), support_radius,
                              options_.lattice && weight_options().radial())),
      countdown_(pairs_.blocks),
      summaries_(pairs_.blocks.all.size()),
      spilled_(pairs_.blocks.ghosts) {
  choose_weights();
  weights_ = make_pair_weights<D>({particles, pairs_}, support_radius, weight_options());
  if (options_.hourglass) hourglass_time_step_ = hourglass_limit(particles, weights_, options_);
}

template <int D>
void TotalLagrangian<D>::choose_weights() {
  const WeightOptions options = weight_options();
  const std::size_t bytes = pairs_.entries() * lanes * sizeof(double) * (options.hourglass_weights() ? 2 : 1);
  if (!options.radial())
    options_.weights = WeightStorage::stored;
  else if (options.storage == WeightStorage::automatic)
    options_.weights = bytes <= most_stored_bytes ? WeightStorage::stored : WeightStorage::computed;
}

template <int D>
WeightOptions TotalLagrangian<D>::weight_options() const {
  HourglassWeight hourglass = HourglassWeight::none;
  if (options_.hourglass)
    hourglass = options_.hourglass->conservative() ? HourglassWeight::conservative : HourglassWeight::central;
  return {options_.kernel, options_.correction, hourglass, options_.weights};
}

/// Room for every thread; only the first call and more threads allocate.
template <int D>
void TotalLagrangian<D>::prepare_scratch() const {
  while (scratches_.size() < most_threads()) scratches_.emplace_back(pairs_);
}

template <int D>
SweepTask<D> TotalLagrangian<D>::task_of(int number, const PairSource<D>& source, const WeightOptions& weights,
                                         RecordedState* record) const {
  const Block& block = pairs_.blocks.all[number];
  BlockScratch<D>& scratch = scratches_[this_thread()];
  scratch.bring_in(block, source.particles);
  if (block.has_list && options_.weights == WeightStorage::computed)
    scratch.bring_in_sizes(block, source.particles, weights_.radius.data());
  const AnyMaterial& material = options_.materials[block.body];
  const double hourglass = options_.hourglass ? options_.hourglass->coefficient() * youngs_modulus_of(material) : 0.0;
  return {block,
          source,
          weights_,
          weights,
          material_point<D>(material, options_.plane_stress),
          options_.thickness,
          density_of(material),
          hourglass,
          scratch,
          record};
}

template <int D>
ForceSummary TotalLagrangian<D>::total() const {
  ForceSummary total;
  for (const ForceSummary& part : summaries_) {
    total.strain_energy += part.strain_energy;
    total.hourglass_energy += part.hourglass_energy;
    total.smallest_jacobian = std::min(total.smallest_jacobian, part.smallest_jacobian);
    total.largest_rate2 = std::max(total.largest_rate2, part.largest_rate2);
  }
  return total;
}

/// One sweep over all blocks: keep(block, scratch) takes what a block has added up, complete(number) is called once nobody adds to that block any more.
template <int D>
template <class Keep, class Complete>
ForceSummary TotalLagrangian<D>::sweep(const Particles<D>& particles, RecordedState* record, Keep&& keep,
                                       Complete&& complete) const {
  prepare_scratch();
  const PairSource<D> source{particles, pairs_};
  const WeightOptions weights = weight_options();
  const auto work = [&](int number) {
    const SweepTask<D> task = task_of(number, source, weights, record);
    summaries_[number] = sweep_block<D>(task);
    keep(task.block, task.scratch);
  };
  for_each_block(pairs_.blocks, countdown_, work, complete);
  return total();
}

template <int D>
ForceSummary TotalLagrangian<D>::internal_forces(const Particles<D>& particles, VectorField<D>& forces, Finish finish,
                                                 RecordedState* record) const {
  const auto hand_out = [&](const Block& block, BlockScratch<D>& scratch) { scratch.hand_out(block, forces, spilled_); };
  return sweep(particles, record, hand_out, [&](int number) {
    add_spilled(pairs_.blocks, number, spilled_, forces);
    finish(pairs_.blocks.all[number].begin, pairs_.blocks.all[number].end);
  });
}

template <int D>
ForceSummary TotalLagrangian<D>::internal_forces(const Particles<D>& particles, VectorField<D>& forces) const {
  return internal_forces(particles, forces, [](int, int) {});
}

template <int D>
ForceSummary TotalLagrangian<D>::record(const Particles<D>& particles, RecordedState& state) const {
  const auto discard = [](const Block& block, BlockScratch<D>& scratch) { scratch.discard(block); };
  return sweep(particles, &state, discard, [](int) {});
}

template <int D>
Vec<double, D> TotalLagrangian<D>::toward_neighbors(const Particles<D>& particles, int slot) const {
  Vec<double, D> sum;
  std::visit(
      [&]<class Kernel>(const Kernel&) {
        for (int j : pairs_.neighbors(slot, particles)) {
          const Vec<double, D> X = particles.position[j] - particles.position[slot];
          sum += radial_weight<Kernel, false>(X, particles.volume[j], weights_.radius[slot]).gradient * X;
        }
      },
      options_.kernel);
  return sum;
}

template <int D>
std::size_t TotalLagrangian<D>::bytes() const {
  std::size_t bytes = pairs_.bytes() + weights_.bytes() + spilled_.bytes();
  for (const BlockScratch<D>& scratch : scratches_) bytes += scratch.bytes();
  return bytes;
}

template class TotalLagrangian<2>;
template class TotalLagrangian<3>;

}  // namespace sinew
