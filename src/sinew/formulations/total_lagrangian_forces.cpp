/// The forces: one sweep over all blocks, and what has to be known before it.

#include <sinew/formulations/sweep_dispatch.hpp>
#include <sinew/formulations/total_lagrangian.hpp>

#include <algorithm>
#include <cmath>
#include <span>

namespace sinew {

/// Room for every thread; only the first call and more threads allocate.
template <int D>
void TotalLagrangian<D>::prepare_scratch() {
  while (scratches_.size() < most_threads())
    scratches_.emplace_back(pairs_, ScratchNeeds{options_.needs_velocities(), options_.averages(), options_.extended()});
}

/// What JST dissipation takes the plain Laplacian of: harmonic v - biharmonic lap v, or the latter alone.
template <int D>
void TotalLagrangian<D>::bring_in_dissipated(const Block& block, const Particles<D>& particles, BlockScratch<D>& scratch) const {
  const JstDissipation::Coefficients coefficients = dissipation_[block.body];
  const double of_velocity = options_.jst->corrected() ? 0.0 : coefficients.harmonic;
  for (int c = 0; c < D; ++c) {
    const double* v = particles.velocity.component(c);
    const double* laplacian = matrices_.laplacian.empty() ? nullptr : matrices_.laplacian.component(c);
    scratch.bring_in_component(block, c, [&](int slot) {
      return laplacian ? of_velocity * v[slot] - coefficients.biharmonic * laplacian[slot] : of_velocity * v[slot];
    });
  }
}

template <int D>
SweepTask<D> TotalLagrangian<D>::task_of(int index, const PairSource<D>& source, const WeightOptions& weights, PointStep step,
                                         RecordedState* record) {
  const Block& block = pairs_.blocks.all[index];
  BlockScratch<D>& scratch = scratches_[this_thread()];
  scratch.bring_in(block, source.particles);
  if (options_.sweeps_velocities()) scratch.bring_in_velocities(block, source.particles);
  if (options_.averages()) scratch.bring_in_matrices(block, matrices_.gradient);
  if (options_.outer_laplacian()) bring_in_dissipated(block, source.particles, scratch);
  if (block.has_list && storage_ == WeightStorage::computed)
    scratch.bring_in_sizes(block, source.particles, weights_.radius.data());
  const AnyMaterial& material = options_.materials[block.body];
  const bool soft = !options_.hourglass || options_.hourglass->plastic_switch;
  return {block,
          source,
          weights_,
          weights,
          material_point<D>(material, options_.damage_of(block.body), options_.plane_stress),
          options_.thickness,
          density_of(material),
          options_.hourglass_coefficient(block.body),
          soft ? 0.0 : youngs_modulus_of(material),
          options_.viscosity ? &*options_.viscosity : nullptr,
          std::sqrt(youngs_modulus_of(material) / density_of(material)),
          options_.wave_speed,
          longitudinal_modulus_of(material),
          scratch,
          history_.of(index),
          step,
          record,
          options_.deformation_gradient,
          matrices_,
          options_.stages ? 0.0 : step.dt,
          laplacian_scale(block.body),
          options_.outer_laplacian(),
          options_.jst && options_.jst->corrected() ? dissipation_[block.body].harmonic : 0.0,
          later_ && later_->renewed() ? later_.get() : nullptr,
          {linearized_.empty() ? nullptr : &linearized_}};
}

/// 0 without JST dissipation.
template <int D>
double TotalLagrangian<D>::laplacian_scale(int body) const {
  return options_.jst && weights_.most_trace[body] > 0.0 ? 2.0 * D / weights_.most_trace[body] : 0.0;
}

/// Calls work(block) for all blocks. Displacements of copies are on their way during the first half of the blocks that do not need them, forces on
/// copies during the second half.
template <int D>
template <class Work>
void TotalLagrangian<D>::sweep_blocks(Particles<D>& particles, Work&& work, const Traffic& traffic) {
  const std::size_t half = edge_.empty() ? inner_.size() : inner_.size() / 2;
  const std::span<const int> inner(inner_), first = inner.first(half), second = inner.subspan(half);
  const bool many = particles.slots >= fewest_for_threads;
  if (traffic.displacements) halo_.displacements.start(particles.displacement);
  for_each_block(first, many, work, [&] {
    if (traffic.displacements) halo_.displacements.progress();
  });
  if (traffic.displacements) halo_.displacements.finish();
  for_each_block(edge_, many, work, [] {});
  if (traffic.forces) halo_.forces.start(spilled_);
  for_each_block(second, many, work, [&] { halo_.forces.progress(); });
  if (traffic.forces) halo_.forces.finish();
}

/// Calls work(block) for all blocks; nothing travels.
template <int D>
template <class Work>
void TotalLagrangian<D>::sweep_all(Particles<D>& particles, Work&& work) {
  sweep_blocks(particles, work, {false, false});
}

/// The same for work that leaves forces in the scratches. `finish`: see internal_forces().
template <int D>
template <class Work>
void TotalLagrangian<D>::sweep_to_forces(Particles<D>& particles, VectorField<D>& forces, Finish finish, const Traffic& traffic,
                                         Work&& work) {
  const auto complete = [&](int index) {
    add_spilled(pairs_.blocks, index, spilled_, forces);
    finish(pairs_.blocks.all[index].begin, pairs_.blocks.all[index].end);
  };
  countdown_->start();
  sweep_blocks(
      particles,
      [&](int index) {
        work(index);
        scratches_[this_thread()].hand_out(pairs_.blocks.all[index], forces, spilled_);
        countdown_->done(index, complete);
      },
      traffic);
  for_each_block(
      pairs_.blocks.awaiting, true, [&](int index) { countdown_->received(index, complete); }, [] {});
}

/// Displacements and velocities of copies, for sweeps that come before the one of the forces.
template <int D>
void TotalLagrangian<D>::bring_copies(Particles<D>& particles) {
  if (options_.needs_velocities()) {
    halo_.displacements.start(particles.velocity);
    halo_.displacements.finish();
  }
  if (!options_.averages()) return;
  halo_.displacements.start(particles.displacement);
  halo_.displacements.finish();
}

template <int D>
NeighborTask<D> TotalLagrangian<D>::neighbor_task(int index, const PairSource<D>& source) {
  const Block& block = pairs_.blocks.all[index];
  return {block, source, weights_, scratches_[this_thread()], matrices_, laplacian_scale(block.body)};
}

/// Gradients of a field of which the values of copies are here, of all particles and copies.
template <int D>
void TotalLagrangian<D>::find_gradients_of(const VectorField<D>& field, Particles<D>& particles, MatrixField<D>& gradients) {
  const PairSource<D> source{particles, pairs_};
  sweep_all(particles, [&](int index) {
    const NeighborTask<D> task = neighbor_task(index, source);
    task.scratch.bring_in_vectors(task.block, field);
    find_gradients<D>(task, gradients);
  });
  halo_.matrices.start(gradients);
  halo_.matrices.finish();
}

/// Laplacians of the velocities, which are here of copies as well, of all particles.
template <int D>
void TotalLagrangian<D>::find_laplacians_of_all(Particles<D>& particles) {
  const PairSource<D> source{particles, pairs_};
  if (!options_.corrects_laplacian())
    return sweep_all(particles, [&](int index) {
      const NeighborTask<D> task = neighbor_task(index, source);
      task.scratch.bring_in_vectors(task.block, particles.velocity);
      find_laplacians<D>(task);
    });
  VectorField<D>& laplacian = matrices_.laplacian;
  const auto over_volume = [&](int begin, int end) {
    for (int c = 0; c < D; ++c)
      for (int slot = begin; slot < end; ++slot) laplacian.at(c, slot) /= particles.volume[slot];
  };
  sweep_to_forces(particles, laplacian, over_volume, {false, true}, [&](int index) {
    const NeighborTask<D> task = neighbor_task(index, source);
    task.scratch.bring_in(task.block, particles);
    task.scratch.bring_in_velocities(task.block, particles);
    for (int c = 0; c < D; ++c)
      std::fill(laplacian.component(c) + task.block.begin, laplacian.component(c) + task.block.end, 0.0);
    exchange_corrected_laplacians<D>(task);
  });
}

/// Everything that the sweep of the forces needs to know of neighbors beside their displacements.
template <int D>
void TotalLagrangian<D>::prepare(Particles<D>& particles) {
  prepare_scratch();
  bring_copies(particles);
  if (options_.averages()) find_gradients_of(particles.displacement, particles, matrices_.gradient);
  if (matrices_.laplacian.empty()) return;
  find_laplacians_of_all(particles);
  halo_.displacements.start(matrices_.laplacian);
  halo_.displacements.finish();
}

template <int D>
ForceSummary TotalLagrangian<D>::internal_forces(Particles<D>& all, VectorField<D>& forces, PointStep step, Finish finish,
                                                 RecordedState* record) {
  Particles<D>& particles = seen(all);
  const PairSource<D> source{particles, pairs_};
  const WeightOptions weights = weight_options();
  const bool variational = options_.deformation_gradient == DeformationGradient::bond_variational;
  const auto later = [](int, int) {};
  prepare(particles);
  sweep_to_forces(particles, forces, variational ? Finish(later) : finish, {!options_.averages(), true},
                  [&](int index) { summaries_[index] = sweep_block<D>(task_of(index, source, weights, step, record)); });
  if (variational) add_adjoint_forces(particles, forces, finish);
  return total_of(summaries_);
}

template <int D>
void TotalLagrangian<D>::tangent_forces(Particles<D>& particles, VectorField<D>& forces, PointStep step) {
  const PairSource<D> source{particles, pairs_};
  const WeightOptions weights = weight_options();
  prepare_scratch();
  const auto later = [](int, int) {};
  sweep_to_forces(particles, forces, later, {true, true}, [&](int index) {
    SweepTask<D> task = task_of(index, source, weights, step, nullptr);
    task.linear.applies = true;
    task.linear.tangent = tangent_point<D>(options_.materials[task.block.body], options_.plane_stress);
    sweep_block<D>(task);
  });
}

/// What follows when the stresses of all particles are known.
template <int D>
void TotalLagrangian<D>::add_adjoint_forces(Particles<D>& particles, VectorField<D>& forces, Finish finish) {
  const PairSource<D> source{particles, pairs_};
  halo_.matrices.start(matrices_.stress);
  halo_.matrices.finish();
  sweep_to_forces(particles, forces, finish, {false, true}, [&](int index) {
    const NeighborTask<D> task = neighbor_task(index, source);
    task.scratch.bring_in(task.block, particles);
    task.scratch.bring_in_matrices(task.block, matrices_.stress);
    give_adjoint_forces<D>(task);
  });
}

template <int D>
ForceSummary TotalLagrangian<D>::record(Particles<D>& all, RecordedState& state) {
  Particles<D>& particles = seen(all);
  const PairSource<D> source{particles, pairs_};
  const WeightOptions weights = weight_options();
  recorded_.resize(summaries_.size());
  prepare(particles);
  sweep_blocks(particles,
               [&](int index) {
                 const SweepTask<D> task = task_of(index, source, weights, {}, &state);
                 recorded_[index] = sweep_block<D>(task);
                 task.scratch.discard(task.block);
               },
               {!options_.averages(), false});
  return total_of(recorded_);
}

template <int D>
void TotalLagrangian<D>::begin(Particles<D>& particles) {
  if (options_.deformation_gradient != DeformationGradient::rate) return;
  prepare_scratch();
  halo_.displacements.start(particles.displacement);
  halo_.displacements.finish();
  find_gradients_of(particles.displacement, particles, matrices_.gradient);
}

#define SINEW_INSTANTIATE(D)                                                                                                     \
  template void TotalLagrangian<D>::prepare_scratch();                                                                           \
  template void TotalLagrangian<D>::bring_in_dissipated(const Block&, const Particles<D>&, BlockScratch<D>&) const;              \
  template SweepTask<D> TotalLagrangian<D>::task_of(int, const PairSource<D>&, const WeightOptions&, PointStep, RecordedState*); \
  template double TotalLagrangian<D>::laplacian_scale(int) const;                                                                \
  template void TotalLagrangian<D>::bring_copies(Particles<D>&);                                                                 \
  template NeighborTask<D> TotalLagrangian<D>::neighbor_task(int, const PairSource<D>&);                                         \
  template void TotalLagrangian<D>::find_gradients_of(const VectorField<D>&, Particles<D>&, MatrixField<D>&);                    \
  template void TotalLagrangian<D>::find_laplacians_of_all(Particles<D>&);                                                       \
  template void TotalLagrangian<D>::add_adjoint_forces(Particles<D>&, VectorField<D>&, Finish);                                  \
  template void TotalLagrangian<D>::prepare(Particles<D>&);                                                                      \
  template ForceSummary TotalLagrangian<D>::internal_forces(Particles<D>&, VectorField<D>&, PointStep, Finish, RecordedState*);  \
  template void TotalLagrangian<D>::tangent_forces(Particles<D>&, VectorField<D>&, PointStep);                                   \
  template ForceSummary TotalLagrangian<D>::record(Particles<D>&, RecordedState&);                                               \
  template void TotalLagrangian<D>::begin(Particles<D>&);
SINEW_INSTANTIATE(2)
SINEW_INSTANTIATE(3)

}  // namespace sinew
