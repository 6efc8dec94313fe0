/// The forces: two sweeps over pairs, and between them what happens at the particles.

#include <sinew/formulations/updated_lagrangian.hpp>
#include <sinew/neighbors/eight_of_block.hpp>

#include <algorithm>
#include <cmath>

namespace sinew {

namespace {

/// value(point, row) of all places into rows of `width`.
template <int D, class Value>
void fill_rows(const MovingNeighbors<D>& neighbors, int width, AlignedArray<double>& rows, const Value& value) {
  const int places = neighbors.places();
#pragma omp parallel for schedule(static) if (places >= fewest_for_threads)
  for (int place = 0; place < places; ++place)
    value(neighbors.point_at(place), rows.data() + static_cast<std::size_t>(width) * place);
}

template <int width>
void bring_copies(Exchange& exchange, VectorField<width>& field) {
  exchange.start(field.component(0));
  exchange.finish();
}

}  // namespace

template <int D>
template <class Work>
void UpdatedLagrangian<D>::of_all_blocks(Work&& work) {
  const int count = pairs_.blocks.count(), slots = static_cast<int>(radius_.size());
#pragma omp parallel for schedule(dynamic, 1) if (count > 1 && slots >= fewest_for_threads)
  for (int b = 0; b < count; ++b) work(b);
}

/// Positions, velocities and densities before the step, to where the sweeps find them.
template <int D>
void UpdatedLagrangian<D>::show_motion(const Particles<D>& particles) {
  of_all_blocks([&](int b) {
    const Block& block = pairs_.blocks.all[b];
    const double volume = 1.0 / density_of(options_.materials[block.body]);
    for (int slice = block.first_slice; slice < block.end_slice; ++slice) {
      const SliceSlots<D> slots(pairs_, block, slice);
      slots.store(volume * determinant(Mat<Pack, D>::identity() + slots.load_matrix(deformation_)), motion_.component(2 * D));
    }
  });
  for_each_piece(particles.slots, [&](int begin, int end) {
    for (int c = 0; c < D; ++c) {
      const double *X = particles.position.component(c), *u = particles.displacement.component(c);
      double* x = motion_.component(c);
      for (int slot = begin; slot < end; ++slot) x[slot] = X[slot] + u[slot];
      std::copy(particles.velocity.component(c) + begin, particles.velocity.component(c) + end, motion_.component(D + c) + begin);
    }
  });
  bring_copies(motion_exchange_, motion_);
  fill_rows(neighbors_, moving_row, motion_rows_, [this](int point, double* row) {
    for (int c = 0; c < D; ++c) row[c] = motion_.at(c, point), row[4 + c] = motion_.at(D + c, point);
    row[D] = mass_[point];
    row[D == 3 ? 7 : 3] = motion_.at(2 * D, point);
  });
}

template <int D>
void UpdatedLagrangian<D>::find_velocity_gradients(double dt) {
  sweep_velocity_gradients<D>(gradient_sweep(neighbors_, dt, gradient_));
  if (walls_.any()) mind_walls_in_gradients(dt);
}

template <int D>
GradientSweep<D> UpdatedLagrangian<D>::gradient_sweep(const MovingNeighbors<D>& neighbors, double dt, MatrixField<D>& gradient) {
  return {{neighbors, options_.kernel, options_.radius, motion_rows_.data()},
          0.5 * dt,
          options_.corrected,
          options_.pressure_only(),
          gradient,
          correction_,
          pull_};
}

/// Stresses to where the second sweep finds them.
template <int D>
void UpdatedLagrangian<D>::show_stress() {
  bring_copies(stress_exchange_, stress_);
  if (walls_.any()) {
    walls_.extrapolate(points(), stress_);
    bring_copies(stress_exchange_, stress_);
  }
  if (options_.repels()) bring_copies(repulsion_exchange_, repulsion_);
  if (options_.explains()) bring_copies(explained_exchange_, explained_);
  constexpr int upper[] = {0, D + 1, D == 3 ? 8 : 1, D == 3 ? 1 : 4, 5, 2, 9}, lower[] = {D, 7, 6};  // components of the rows
  fill_rows(neighbors_, moving_row, stress_rows_, [&](int point, double* row) {
    for (int c = 0; c < (D == 3 ? 7 : 4); ++c) row[c] = stress_.at(upper[c], point);
  });
  if (options_.has_rest())
    fill_rows(neighbors_, rest_row, rest_rows_, [&](int point, double* row) {
      for (int c = 0; c < (D == 3 ? 3 : 1); ++c) row[rest_lower + c] = stress_.at(lower[c], point);
      for (int c = 0; options_.repels() && c < D * (D + 1) / 2; ++c) row[rest_repulsion + c] = repulsion_.at(c, point);
      for (int c = 0; options_.explains() && c <= D * D; ++c) row[rest_gradient + c] = explained_.at(c, point);
    });
}

template <int D>
RepulsionRange UpdatedLagrangian<D>::repulsion_range() const {
  return std::visit(
      [&](const auto& kernel) -> RepulsionRange {
        const double at_spacing = kernel.template value<D>(options_.spacing, options_.radius);
        const double given = options_.pressure ? options_.pressure->exponent : options_.stress ? options_.stress->exponent : 1.0;
        return {1.0 / at_spacing, std::isnan(given) ? kernel.template value<D>(0.0, options_.radius) / at_spacing : given};
      },
      options_.kernel);
}

template <int D>
ForceSweep<D> UpdatedLagrangian<D>::force_sweep(const MovingNeighbors<D>& neighbors, double dt, VectorField<D>& forces) {
  const double customary = std::visit([](const auto& kernel) { return kernel.customary_h; }, options_.kernel);
  return {{neighbors, options_.kernel, options_.radius, motion_rows_.data()},
          stress_rows_.data(),
          rest_rows_.data(),
          options_.corrected,
          options_.repels(),
          options_.explains(),
          repulsion_range(),
          options_.viscosity ? &*options_.viscosity : nullptr,
          options_.radius / customary,
          0.5 * dt,
          thickness_,
          forces,
          pull_,
          viscous_power_.data(),
          viscous_rate_.data(),
          repulsive_power_.data()};
}

/// The force of NonNestedShear turns with the material, fades as it flows, and grows. Returns the work that it has taken in the step of the leapfrog.
template <int D>
Pack UpdatedLagrangian<D>::hold_shear(const SliceSlots<D>& slots, const Particles<D>& particles, VectorField<D>& forces,
                                      double dt) {
  const NonNestedShear& shear = *options_.shear;
  Vec<Pack, D> held, growth, before;
  for (int c = 0; c < D; ++c) held[c] = slots.load(held_.component(c)), growth[c] = slots.load(pull_.component(c));
  before = held;
  if (shear.printed()) {
    growth = (slots.load(modulus_.data()) * slots.load(particles.mass.data())) * growth;
  } else {
    held = slots.load(left_.data()) * (rotation_of(slots.load_matrix(gradient_), dt) * held);
  }
  held += Pack(dt * shear.coefficient(D)) * growth;
  Pack work(0.0);
  for (int c = 0; c < D; ++c) {
    slots.store(held[c], held_.component(c));
    slots.store(slots.load(forces.component(c)) + held[c], forces.component(c));
    work -= (before[c] + held[c]) * slots.load(particles.velocity.component(c));
  }
  return Pack(0.5 * dt) * work;
}

/// What is left to do for a block when its pair forces are known.
template <int D>
void UpdatedLagrangian<D>::complete_block(int b, const Particles<D>& particles, VectorField<D>& forces, double dt) {
  const Block& block = pairs_.blocks.all[b];
  Pack power(0.0), rate2(0.0), released(0.0);
  for (int slice = block.first_slice; slice < block.end_slice; ++slice) {
    const SliceSlots<D> slots(pairs_, block, slice);
    if (options_.shear) released += hold_shear(slots, particles, forces, dt);
    Pack rate = slots.load(speed2_.data()) * slots.load(inverse_length2_.data());
    if (options_.viscosity) {
      constexpr double share = 1.6;  // of the limit of the leapfrog that damping takes, see sweep_dissipation.hpp
      const Pack viscous = share * slots.load(viscous_rate_.data());
      rate += viscous * viscous;
      power += slots.load(viscous_power_.data());
    }
    if (options_.repels()) power += slots.load(repulsive_power_.data());
    rate2 = max(rate2, rate);
  }
  summaries_[b].viscous_power = sum(power);
  summaries_[b].released = sum(released);
  summaries_[b].largest_rate2 = largest(rate2);
}

template <int D>
ForceSummary UpdatedLagrangian<D>::internal_forces(Particles<D>& particles, VectorField<D>& forces, PointStep step, Finish finish,
                                                   RecordedState* record) {
  find_neighbors(particles);
  show_motion(particles);
  find_velocity_gradients(step.dt);
  of_all_blocks([&](int b) { summaries_[b] = update_block(b, particles, step, record); });
  show_stress();
  sweep_moving_forces<D>(force_sweep(neighbors_, step.dt, forces));
  if (walls_.any()) mind_walls_in_forces(step.dt, forces);
  of_all_blocks([&](int b) {
    complete_block(b, particles, forces, step.dt);
    finish(pairs_.blocks.all[b].begin, pairs_.blocks.all[b].end);
  });
  return total_of(summaries_);
}

template <int D>
ForceSummary UpdatedLagrangian<D>::record(Particles<D>& particles, RecordedState& state) {
  recorded_.resize(summaries_.size());
  of_all_blocks([&](int b) { recorded_[b] = update_block(b, particles, {0.0, HistoryUse::recall}, &state); });
  return total_of(recorded_);
}

#define SINEW_INSTANTIATE(D)                                                                                          \
  template void UpdatedLagrangian<D>::show_motion(const Particles<D>&);                                               \
  template void UpdatedLagrangian<D>::find_velocity_gradients(double);                                                \
  template void UpdatedLagrangian<D>::show_stress();                                                                  \
  template RepulsionRange UpdatedLagrangian<D>::repulsion_range() const;                                              \
  template GradientSweep<D> UpdatedLagrangian<D>::gradient_sweep(const MovingNeighbors<D>&, double, MatrixField<D>&); \
  template ForceSweep<D> UpdatedLagrangian<D>::force_sweep(const MovingNeighbors<D>&, double, VectorField<D>&);       \
  template Pack UpdatedLagrangian<D>::hold_shear(const SliceSlots<D>&, const Particles<D>&, VectorField<D>&, double); \
  template void UpdatedLagrangian<D>::complete_block(int, const Particles<D>&, VectorField<D>&, double);              \
  template ForceSummary UpdatedLagrangian<D>::internal_forces(Particles<D>&, VectorField<D>&, PointStep, Finish,      \
                                                              RecordedState*);                                        \
  template ForceSummary UpdatedLagrangian<D>::record(Particles<D>&, RecordedState&);
SINEW_INSTANTIATE(2)
SINEW_INSTANTIATE(3)

}  // namespace sinew
