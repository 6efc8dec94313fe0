/// What changes between steps: particles are cut off, the reference configuration is renewed.

#include <sinew/formulations/separation.hpp>
#include <sinew/formulations/sweep_dispatch.hpp>
#include <sinew/formulations/total_lagrangian.hpp>

namespace sinew {

template <int D>
bool TotalLagrangian<D>::rearrange(Particles<D>& particles) {
  if (later_) return renew_reference(particles);
  return options_.separates() && separate(particles);
}

/// Energies of the blocks that have changed; what they have lost is released.
template <int D>
void TotalLagrangian<D>::measure_again(const Particles<D>& particles, const std::vector<char>& changed) {
  const PairSource<D> source{particles, pairs_};
  const WeightOptions weights = weight_options();
  prepare_scratch();
  for (std::size_t b = 0; b < changed.size(); ++b) {
    if (!changed[b]) continue;
    const SweepTask<D> task = task_of(static_cast<int>(b), source, weights, {}, nullptr);
    const ForceSummary now = sweep_block<D>(task);
    task.scratch.discard(task.block);
    ForceSummary& summary = summaries_[b];
    summary.released += summary.strain_energy + summary.hourglass_energy - now.strain_energy - now.hourglass_energy;
    summary.strain_energy = now.strain_energy;
    summary.hourglass_energy = now.hourglass_energy;
  }
}

template <int D>
Separation<D> TotalLagrangian<D>::separation(const Particles<D>& particles, const WeightOptions& weights) {
  return Separation<D>({comm_, options_, weights, particles, pairs_, weights_, history_, cracks_});
}

template <int D>
bool TotalLagrangian<D>::separate(const Particles<D>& particles) {
  const WeightOptions weights = weight_options();
  const std::vector<char> changed = separation(particles, weights).cut_off_failed(summaries_);
  if (changed.empty()) return false;
  measure_again(particles, changed);
  limit_time_step(particles);
  return true;
}

template <int D>
void TotalLagrangian<D>::restore_cracks(const Particles<D>& particles, const std::vector<double>& failed,
                                        const std::vector<double>& most_stiffness) {
  const WeightOptions weights = weight_options();
  separation(particles, weights).cut_off_again(failed);
  weights_.most_stiffness = most_stiffness;
  limit_time_step(particles);
}

// --- configuration update ------------------------------------------------------------------------------------

/// A run that has lost its meaning ends in this step.
template <int D>
bool TotalLagrangian<D>::renew_reference(Particles<D>& particles) {
  if (!later_->is_due(comm_, seen(particles), pairs_)) return false;
  const ForceSummary total = total_of(summaries_);
  if (comm_.any(!total.finite || !(total.smallest_jacobian > 0.0))) return false;
  remember_deformation(particles);
  const std::vector<double> radius(weights_.radius.begin(), weights_.radius.begin() + particles.slots);
  replace_reference(later_->adopt(comm_, particles, radius), particles, radius);
  for (ForceSummary& block : summaries_) {
    block.released += block.hourglass_energy;
    block.hourglass_energy = 0.0;
  }
  return true;
}

/// F of all particles; what is written in rates keeps its volume only.
template <int D>
void TotalLagrangian<D>::remember_deformation(Particles<D>& particles) {
  RecordedState state(particles.slots);
  if (history_.width() > 0) state.inelastic = VectorField<4>(particles.slots);
  record(particles, state);
  for (std::size_t b = 0; b < pairs_.blocks.all.size(); ++b) {
    const Block& block = pairs_.blocks.all[b];
    const MaterialPoint<D> point = material_point<D>(options_.materials[block.body], nullptr, false);
    for (int slice = block.first_slice; slice < block.end_slice; ++slice) {
      const SliceSlots<D> slots(pairs_, block, slice);
      Mat<Pack, D> F;
      for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) F[i][j] = slots.load(state.deformation_gradient.component(3 * i + j));
      Mat<Pack, D> earlier = F;
      const SliceHistory<D> history{
          history_.of(static_cast<int>(b)), slots, {0.0, HistoryUse::forget}, weights_.radius.data(), &earlier};
      PointResponse<D> response;
      if (point.numbers > 0) point(F, &history, response);
      slots.store_matrix(earlier - Mat<Pack, D>::identity(), later_->earlier());
    }
  }
}

template <int D>
void TotalLagrangian<D>::replace_reference(SharedPairs<D> shared, Particles<D>& particles, std::vector<double> radius) {
  pairs_ = std::move(shared.pairs);
  halo_ = std::move(shared.halo);
  radius.resize(static_cast<std::size_t>(particles.slots) + shared.share.copied(), 0.0);
  take_reference(seen(particles), radius);
}

template <int D>
void TotalLagrangian<D>::restored(Particles<D>& particles) {
  if (!later_ || !later_->renewed()) return;
  const std::vector<double> radius(weights_.radius.begin(), weights_.radius.begin() + particles.slots);
  replace_reference(later_->adopt_again(comm_, particles, radius), particles, radius);
}

#define SINEW_INSTANTIATE(D)                                                                                                     \
  template bool TotalLagrangian<D>::rearrange(Particles<D>&);                                                                    \
  template bool TotalLagrangian<D>::separate(const Particles<D>&);                                                               \
  template Separation<D> TotalLagrangian<D>::separation(const Particles<D>&, const WeightOptions&);                              \
  template void TotalLagrangian<D>::measure_again(const Particles<D>&, const std::vector<char>&);                                \
  template void TotalLagrangian<D>::restore_cracks(const Particles<D>&, const std::vector<double>&, const std::vector<double>&); \
  template bool TotalLagrangian<D>::renew_reference(Particles<D>&);                                                              \
  template void TotalLagrangian<D>::remember_deformation(Particles<D>&);                                                         \
  template void TotalLagrangian<D>::replace_reference(SharedPairs<D>, Particles<D>&, std::vector<double>);                       \
  template void TotalLagrangian<D>::restored(Particles<D>&);
SINEW_INSTANTIATE(2)
SINEW_INSTANTIATE(3)

}  // namespace sinew
