#pragma once
/// The one sweep over the particles of a block. The loops over pairs are in neighbors/, the physics of a point in pair_force.hpp and in the materials.

#include <algorithm>
#include <cmath>
#include <sinew/formulations/bond_sums.hpp>
#include <sinew/formulations/sweep_dissipation.hpp>
#include <sinew/formulations/weight_source.hpp>
#include <sinew/neighbors/lattice_pairs.hpp>
#include <sinew/neighbors/listed_pairs.hpp>

namespace sinew {

/// Largest |F X - x| / |X| over the neighbors of eight particles.
template <int D, class Pairs>
Pack hourglass_error(const Mat<Pack, D>& F, const Pairs& pairs) {
  Pack error2(0.0);
  pairs.visit([&](const auto& weight, const Vec<Pack, D>& u, const Vec<Pack, D>& X) {
    const Vec<Pack, D> e = F * X - (X + u);
    error2 = max(error2, select(weight.present(), dot(e, e) / (dot(X, X) + 1e-200), Pack(0.0)));
  });
  return sqrt(error2);
}

/// F of eight particles whose gradients are integrated in time.
template <int D, class Pairs>
SINEW_INLINE void integrate_deformation(const SweepTask<D>& task, Pairs& pairs, int number, SliceInWork<D>& slice) {
  const VectorRows<D> v{task.scratch.velocity_rows()};
  const Vec<Pack, D> v_i = pairs.own(v);
  Mat<Pack, D> rate;
  pairs.first_visit_with(v, [&](const auto& weight, const Vec<Pack, D>&, const Vec<Pack, D>& X, const Vec<Pack, D>& v_j) {
    rate += outer(v_j - v_i, weight.vector(X));
  });
  const SliceSlots<D> slots(task.source.pairs, task.block, number);
  const Mat<Pack, D> G = slots.load_matrix(task.matrices.gradient) + Pack(task.rate_step) * rate;
  slice.F = Mat<Pack, D>::identity() + G;
  if (!task.step.respond()) return;
  slots.store_matrix(rate, task.matrices.rate);
  if (task.rate_step > 0.0) slots.store_matrix(G, task.matrices.gradient);
}

/// F of eight particles as the average over their bonds, each with the gradient
///     F_ij = (F_i + F_j)/2 (I - N_ij (x) N_ij) + x_ij (x) X_ij / r_ij^2
/// and the particle itself. Wiragunarsa et al. (2024), eq. 37 and 39; see GradientOfBonds.
template <int D, class Pairs>
SINEW_INLINE void average_over_bonds(const SweepTask<D>& task, Pairs& pairs, int number, SliceInWork<D>& slice) {
  const Mat<Pack, D> G = SliceSlots<D>(task.source.pairs, task.block, number).load_matrix(task.matrices.gradient);
  GradientOfBonds<D> bonds{G * task.weights.own_average[task.weights.constants_of[number]].matrix()};
  pairs.first_visit_with(task.scratch.matrices(), bonds);
  slice.direct = Mat<Pack, D>::identity() + G;
  slice.F = Mat<Pack, D>::identity() + bonds.sum;
}

/// S and F of eight particles.
template <int D, class Pairs>
SINEW_INLINE void find_deformation(const SweepTask<D>& task, const SliceConstants<D>& constants, Pairs& pairs, int number,
                                   SliceInWork<D>& slice) {
  if constexpr (Pairs::vectors) {
    if (task.form == DeformationGradient::rate) return integrate_deformation(task, pairs, number, slice);
    if (task.form != DeformationGradient::direct) return average_over_bonds(task, pairs, number, slice);
  }
  Mat<Pack, D> S;
  pairs.first_visit([&](const auto& weight, const Vec<Pack, D>& u, const Vec<Pack, D>& X) { S += outer(u, weight.vector(X)); });
  slice.S = S;
  slice.F = Mat<Pack, D>::identity() + S * constants.correction_matrix();
}

/// Of eight particles with history: what flow and damage have taken, also of the energy of the hourglass stiffness.
template <int D>
SINEW_INLINE void count_dissipation(const SweepTask<D>& task, const PointResponse<D>& point, const Pack& volume,
                                    const Pack& hourglass_energy, SweepSums& sums) {
  const Pack left = point.damage.left * (task.fixed_modulus > 0.0 ? Pack(1.0) : point.hourglass_left);
  sums.left = min(sums.left, point.damage.left);
  sums.plastic_work += volume * point.plastic.work;
  sums.damage_work += volume * point.damage.work;
  sums.hourglass_energy += left * hourglass_energy;
  sums.released += hourglass_energy - left * hourglass_energy;
}

/// Density times the squared rate with which a wave passes a particle. For the limit by stretches each particle counts its own speed over the distance of its neighbors:
/// never more time than with the mean speed of both ends.
template <int D, class Pairs>
SINEW_INLINE Pack stiffness_rate(const SweepTask<D>& task, const SliceConstants<D>& constants, const Pairs& pairs,
                                 const SliceInWork<D>& slice) {
  if (task.wave_speed == WaveSpeed::bound) return slice.point.acoustic_stiffness * constants.inverse_length2;
  if (task.wave_speed == WaveSpeed::reference) return Pack(task.stiffness) * constants.inverse_length2;
  Pack nearest2(infinity);
  pairs.visit([&](const auto& weight, const Vec<Pack, D>& u, const Vec<Pack, D>& X) {
    const Vec<Pack, D> x = X + u;
    nearest2 = min(nearest2, select(weight.present() & (dot(X, X) > Pack(0.0)), dot(x, x), Pack(infinity)));
  });
  const Mat3<Pack> F = embed(slice.F, slice.point.thickness_stretch);
  const Vec3<Pack> squares = spectrum(transpose(F) * F).values;
  const Pack least = min(squares[0], min(squares[1], squares[2]));
  return Pack(task.stiffness) / (least * nearest2);
}

/// What eight particles tell about themselves besides their forces, and forces that depend on velocities.
template <int D, class Pairs>
SINEW_INLINE void give_rates(const SweepTask<D>& task, const SliceConstants<D>& constants, Pairs& pairs,
                             const SliceInWork<D>& slice, int slice_number, SweepSums& sums) {
  sums.energy += slice.material * task.thickness * slice.point.energy;
  sums.jacobian = min(sums.jacobian, slice.point.jacobian);
  Pack rate = stiffness_rate(task, constants, pairs, slice);
  if (task.viscosity) rate += task.density * give_viscous_forces(task, constants, pairs, slice, slice_number, sums);
  if constexpr (Pairs::listed)
    if (task.laplacian_scale > 0.0) give_dissipation(task, constants, pairs, slice_number, sums);
  sums.stiffness_rate = max(sums.stiffness_rate, rate);
}

/// Forces of eight particles and their pairs, once the material has answered.
template <int D, class Shares, class Pairs>
SINEW_INLINE void give_forces(const SweepTask<D>& task, const SliceConstants<D>& constants, Pairs& pairs,
                              const SliceInWork<D>& slice, int slice_number, SweepSums& sums) {
  const PointResponse<D>& point = slice.point;
  const Pack volume = slice.material * task.thickness;
  const bool linear = task.linear.applies;
  if (!linear) give_rates(task, constants, pairs, slice, slice_number, sums);

  const Pack modulus = task.fixed_modulus > 0.0 ? Pack(task.fixed_modulus) : point.hourglass_modulus;
  const Pack stiffness = slice.volume * task.thickness * task.hourglass * modulus * constants.hourglass_scale;
  const bool history = task.material.numbers > 0;
  if (task.form == DeformationGradient::bond_variational)
    SliceSlots<D>(task.source.pairs, task.block, slice_number).store_matrix(volume * point.P, task.matrices.stress);
  Shares shares(PointState<D>{(volume * point.P) * constants.correction_matrix(), slice.template of_pairs<Pairs>(task.form),
                              slice.S, history ? stiffness * point.damage.intact : stiffness});
  pairs.exchange(shares);
  if (linear) return;
  if (history)
    count_dissipation(task, point, volume, shares.hourglass_energy(), sums);
  else
    sums.hourglass_energy += shares.hourglass_energy();
}

/// F and P with respect to the first reference configuration.
template <int D>
std::pair<Mat<Pack, D>, Mat<Pack, D>> since_start(const SweepTask<D>& task, const SliceSlots<D>& slots,
                                                  const SliceInWork<D>& slice) {
  if (!task.later) return {slice.F, slice.point.P};
  const Mat<Pack, D> earlier = task.later->earlier(slots);
  return {slice.F * earlier, slice.point.P * inverse(transpose(earlier))};
}

/// Keeps what `record` asks for of a slice.
template <int D, class Pairs>
void keep(const SweepTask<D>& task, int number, const SliceInWork<D>& slice, const Pairs& pairs) {
  const PointResponse<D>& point = slice.point;
  RecordedState& state = *task.record;
  const SliceSlots<D> slots(task.source.pairs, task.block, number);
  const auto [F, P] = since_start(task, slots, slice);
  const Mat3<Pack> F3 = embed(F, point.thickness_stretch), P3 = embed(P, point.thickness_stress);
  for (int c = 0; c < 9; ++c) {
    slots.store(F3[c / 3][c % 3], state.deformation_gradient.component(c));
    slots.store(P3[c / 3][c % 3], state.stress.component(c));
  }
  slots.store(point.energy, state.energy_density.data());
  if (task.material.numbers > 0) {
    slots.store(point.plastic.strain, state.inelastic.component(0));
    slots.store(point.plastic.work, state.inelastic.component(1));
    slots.store(point.plastic.temperature, state.inelastic.component(2));
    slots.store(point.damage.now, state.inelastic.component(3));
  }
  if (state.hourglass_error.size() > 0)
    slots.store(hourglass_error(slice.template of_pairs<Pairs>(task.form), pairs), state.hourglass_error.data());
}

/// Of a reference configuration that has been renewed: the material sees all of the deformation. Its stress turns to the frame of that configuration.
template <int D>
void ask_since_update(const SweepTask<D>& task, int slice, SliceInWork<D>& work) {
  const SliceSlots<D> slots(task.source.pairs, task.block, slice);
  const LaterFrame<D> frame{work.F, task.later->earlier(slots)};
  const SliceHistory<D> history{task.history, slots, task.step, task.weights.radius.data(), nullptr, &frame};
  task.material(frame.since * frame.earlier, &history, work.point);
  work.point.P = work.point.P * transpose(frame.earlier);
  work.material = slots.load(task.later->first_volume());
}

/// The change of the stress with the displacements, from the deformation that was kept.
template <int D>
void ask_tangent(const SweepTask<D>& task, const SliceHistory<D>& history, SliceInWork<D>& work) {
  PointTangent<D> tangent;
  const Mat<Pack, D> I = Mat<Pack, D>::identity();
  task.linear.tangent(I + history.slots.load_matrix(*task.linear.gradient), &history, tangent);
  work.point.P = tangent * (work.F - I);
  work.point.hourglass_modulus = tangent.hourglass_modulus;
}

template <int D>
SINEW_INLINE void ask_material(const SweepTask<D>& task, const SliceConstants<D>& constants, int slice, SliceInWork<D>& work) {
  work.volume = work.material = constants.volume;
  if (task.linear.gradient) {
    const SliceSlots<D> slots(task.source.pairs, task.block, slice);
    if (task.linear.applies) return ask_tangent(task, {task.history, slots, task.step, task.weights.radius.data()}, work);
    slots.store_matrix(work.F - Mat<Pack, D>::identity(), *task.linear.gradient);
  }
  if (task.later) return ask_since_update(task, slice, work);
  if (task.material.numbers == 0) return task.material(work.F, nullptr, work.point);
  const SliceHistory<D> history{task.history, SliceSlots<D>(task.source.pairs, task.block, slice), task.step,
                                task.weights.radius.data()};
  task.material(work.F, &history, work.point);
}

/// Slices [begin, end), all of them with a pair list or all with a lattice pattern. A few go together, so that the long chains of operations in
/// their materials overlap.
template <int D, class Shares, class Pairs>
void sweep_slices(const SweepTask<D>& task, Pairs pairs, int begin, int end, SweepSums& sums) {
  constexpr int together = Pairs::slices_together;
  SliceInWork<D> slices[together];
  const auto constants = [&](int slice) -> const SliceConstants<D>& {
    return task.weights.constants[task.weights.constants_of[slice]];
  };
  for (int first = begin; first < end; first += together) {
    const int count = std::min(together, end - first);
    for (int k = 0; k < count; ++k) {
      pairs.enter(first + k);
      find_deformation(task, constants(first + k), pairs, first + k, slices[k]);
    }
    for (int k = 0; k < count; ++k) ask_material(task, constants(first + k), first + k, slices[k]);
    for (int k = 0; k < count; ++k) {
      pairs.enter(first + k);
      give_forces<D, Shares>(task, constants(first + k), pairs, slices[k], first + k, sums);
      if (task.record) keep(task, first + k, slices[k], pairs);
    }
  }
}

/// Sweeps a block with weights from `listed` and from the bonds of the lattice, each run of slices its own way.
template <int D, class Shares, class Weights>
ForceSummary sweep_runs(const SweepTask<D>& task, const Weights& listed) {
  SweepSums sums;
  const BlockPairs<D>& pairs = task.source.pairs;
  BlockScratch<D>& scratch = task.scratch;
  for (int begin = task.block.first_slice, end; begin < task.block.end_slice; begin = end) {
    for (end = begin + 1; end < task.block.end_slice && pairs.listed(end) == pairs.listed(begin);) ++end;
    if (pairs.listed(begin)) {
      const ListedPairsData<D> data{pairs, scratch.place_rows(), scratch.velocity_rows(), scratch.force_rows(), scratch.kept()};
      sweep_slices<D, Shares>(task, ListedPairs<D, Weights, Shares::of_pairs>(data, listed), begin, end, sums);
    } else if constexpr (Weights::radial) {
      using Bonds = BondWeights<D, Shares::hourglass_weights>;
      LatticePairsData<D> data{pairs, {}, {}, {}};
      for (int c = 0; c < D; ++c)
        data.displacement[c] = scratch.displacement(c), data.velocity[c] = scratch.velocity(c),
        data.forces[c] = scratch.forces(c);
      sweep_slices<D, Shares>(task, LatticePairs<D, Bonds>(data, {task.weights.bonds.data()}), begin, end, sums);
    }
  }
  return sums.total(task.density);
}

/// Chooses by how weights are kept. One choice a block, outside of all loops.
template <int D, class Shares>
ForceSummary sweep_with(const SweepTask<D>& task) {
  constexpr bool hourglass = Shares::hourglass_weights;
  const PairWeights<D>& w = task.weights;
  switch (task.options.storage) {
    case WeightStorage::single:
      return sweep_runs<D, Shares>(
          task, StoredWeights<float, hourglass>{w.single_pairs.gradient.data(), w.single_pairs.hourglass.data()});
    case WeightStorage::computed:
      return std::visit(
          [&]<class Kernel>(const Kernel&) {
            return sweep_runs<D, Shares>(task, ComputedWeights<Kernel, hourglass>{task.scratch.volume(), task.scratch.radius()});
          },
          task.options.kernel);
    default:
      return sweep_runs<D, Shares>(task, StoredWeights<double, hourglass>{w.pairs.gradient.data(), w.pairs.hourglass.data()});
  }
}

/// Chooses by the form of hourglass force.
template <int D>
ForceSummary choose_sweep(const SweepTask<D>& task) {
  const bool central = task.options.hourglass == HourglassWeight::central;
  if (task.options.radial())
    return central ? sweep_with<D, SeparateShares<D, CentralForm>>(task) : sweep_with<D, ConservativeShares<D>>(task);
  const StoredPairs<double>& pairs = task.weights.pairs;
  const double* force = pairs.force.size() > 0 ? pairs.force.data() : pairs.gradient.data();
  const StoredVectors<D> vectors{pairs.gradient.data(), force, pairs.hourglass.data(), pairs.average.data(),
                                 pairs.dissipation.data()};
  if (task.options.hourglass == HourglassWeight::none) return sweep_runs<D, StressShares<D>>(task, vectors);
  if (central) return sweep_runs<D, SeparateShares<D, CentralForm>>(task, vectors);
  return sweep_runs<D, SeparateShares<D, ConservativeForm>>(task, vectors);
}

}  // namespace sinew
