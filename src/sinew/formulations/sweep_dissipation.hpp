#pragma once
/// Forces that depend on velocities: artificial viscosity and JST dissipation.

#include <sinew/formulations/pair_force.hpp>
#include <sinew/formulations/slice_slots.hpp>
#include <sinew/formulations/slice_work.hpp>

namespace sinew {

/// Viscous forces of eight particles and their pairs. Returns what they add to the squared rate of the time step: with a rate of damping of at most four times the
/// resistance over the mass (both halves of a pair, both ends of it), cfl = 0.3 makes steps of 0.75 over that rate, and 2 would be the limit.
template <int D, class Pairs>
SINEW_INLINE Pack give_viscous_forces(const SweepTask<D>& task, const SliceConstants<D>& constants, Pairs& pairs,
                                      const SliceInWork<D>& slice, int slice_number, SweepSums& sums) {
  const PointResponse<D>& point = slice.point;
  const SliceSlots<D> slots(task.source.pairs, task.block, slice_number);
  const Pack h = 0.5 * slots.load(task.weights.radius.data()), volume = slice.material * task.thickness;
  const Pack jacobian = task.later ? determinant(slice.F) : point.jacobian;
  const Pack size = (-0.5 * task.density) * volume * jacobian * jacobian;
  ViscousShares<D> shares{size * (transpose(inverse(slice.F)) * constants.correction_matrix()), h, *task.viscosity,
                          task.sound_speed};
  pairs.exchange_moving(shares);
  sums.viscous_power += shares.power;
  const Pack rate = (1.6 / task.density) * shares.resistance / max(volume, Pack(1e-300));
  return select(volume > Pack(0.0), rate * rate, Pack(0.0));
}

/// Forces of JstDissipation on eight particles, and of the corrected harmonic term on their pairs.
template <int D, class Pairs>
SINEW_INLINE void give_dissipation(const SweepTask<D>& task, const SliceConstants<D>& constants, Pairs& pairs, int number,
                                   SweepSums& sums) {
  const StoredPairs<double>& weights = task.weights.pairs;
  const Pack scale = (task.density * task.thickness * task.laplacian_scale) * constants.volume;
  if constexpr (Pairs::vectors)
    if (task.corrected_harmonic > 0.0) {
      const VectorRows<D> velocities{task.scratch.velocity_rows()};
      UnexplainedVelocities<D> shares{pairs.gradient(velocities, weights.gradient.data()),
                                      (0.5 * task.corrected_harmonic) * scale};
      pairs.exchange_moving(shares);
      sums.viscous_power += shares.power;
    }
  if (!task.outer_laplacian) return;
  const SliceSlots<D> slots(task.source.pairs, task.block, number);
  const Vec<Pack, D> force = scale * pairs.sum_differences(task.scratch.vectors(), weights.dissipation.data());
  pairs.add_to_own(force);
  for (int c = 0; c < D; ++c) sums.viscous_power -= force[c] * slots.load(task.source.particles.velocity.component(c));
}

}  // namespace sinew
