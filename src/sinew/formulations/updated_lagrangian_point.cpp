/// What happens at the particles between the two sweeps.

#include <sinew/formulations/updated_lagrangian.hpp>

#include <cmath>

namespace sinew {

namespace {

/// The modulus of shear waves.
double shear_modulus_of(const AnyMaterial& material) {
  return std::visit([](const auto& m) { return m.elastic.mu(); }, material);
}

/// Per reference volume, for small changes of the volume: J p^2 / (2 K).
template <int D>
Pack volumetric_energy(const AnyMaterial& material, const CauchyStress<D>& sigma, const PointResponse<D>& point) {
  const double K = std::visit([](const auto& m) { return m.elastic.bulk_modulus; }, material);
  return K > 0.0 ? (0.5 / K) * point.jacobian * sigma.mean * sigma.mean : Pack(0.0);
}

}  // namespace

/// Eight particles from their velocity gradients to their stresses.
template <int D>
void UpdatedLagrangian<D>::update_slice(int b, const SliceSlots<D>& slots, const Particles<D>& particles, PointStep step,
                                        RecordedState* record, UpdateSums& sums) {
  const Block& block = pairs_.blocks.all[b];
  const AnyMaterial& any = options_.materials[block.body];
  const MaterialPoint<D> material = material_point<D>(any, options_.damage_of(block.body), false);
  Mat<Pack, D> G = slots.load_matrix(deformation_);
  if (step.keep() && step.dt != 0.0) {
    G += change_of_gradient(slots.load_matrix(gradient_), step.dt) * (Mat<Pack, D>::identity() + G);
  }
  Mat<Pack, D> F = Mat<Pack, D>::identity() + G;
  PointResponse<D> point{};
  const Mat<Pack, D> reached = F;
  const SliceHistory<D> history{history_.of(b), slots, step, radius_.data(), step.keep() ? &F : nullptr};
  material(reached, material.numbers > 0 ? &history : nullptr, point);
  if (step.keep()) slots.store_matrix(F - Mat<Pack, D>::identity(), deformation_);
  const Pack volume = slots.load(particles.volume.data()) * thickness_;
  sums.energy += volume * (options_.pressure_only() ? volumetric_energy(any, CauchyStress<D>(point, F), point) : point.energy);
  sums.plastic_work += volume * point.plastic.work;
  sums.damage_work += volume * point.damage.work;
  sums.jacobian = min(sums.jacobian, point.jacobian);
  if (record) keep_record(slots, F, point, *record);
  if (!step.keep()) return;
  slots.store((1.0 / density_of(any)) * point.acoustic_stiffness, speed2_.data());
  give_stress(block.body, slots, F, point);
}

/// What neighbors will see of it.
template <int D>
void UpdatedLagrangian<D>::give_stress(int body, const SliceSlots<D>& slots, const Mat<Pack, D>& F,
                                       const PointResponse<D>& point) {
  const AnyMaterial& any = options_.materials[body];
  const CauchyStress<D> sigma(point, F);
  const Pack specific_volume = (1.0 / density_of(any)) * point.jacobian;
  Mat<Pack, D> T = options_.pressure_only() ? sigma.mean * Mat<Pack, D>::identity() : sigma.in_plane;
  if (options_.corrected) T = T * transpose(slots.load_matrix(correction_));
  T = (specific_volume * specific_volume) * T;
  for (int c = 0; c < D * D; ++c) slots.store(T[c / D][c % D], stress_.component(c));
  slots.store(Pack(std::sqrt(youngs_modulus_of(any) / density_of(any))), stress_.component(D * D));
  if (options_.repels()) {
    const Mat<Pack, D> R = options_.pressure ? options_.pressure->repulsion(sigma.in_plane, sigma.mean, specific_volume)
                                             : options_.stress->repulsion(sigma.in_plane, sigma.mean, specific_volume);
    for (int c = 0; c < D; ++c) slots.store(R[c][c], repulsion_.component(c));
    slots.store(R[0][1], repulsion_.component(D));
    if constexpr (D == 3) slots.store(R[1][2], repulsion_.component(4)), slots.store(R[0][2], repulsion_.component(5));
  }
  if (options_.shear) {
    const double stiffness = shear_modulus_of(any), modulus = youngs_modulus_of(any);
    const Pack left = modulus > 0.0 ? (1.0 / modulus) * point.hourglass_modulus * point.damage.left : Pack(0.0);
    slots.store(stiffness * left, modulus_.data());
    slots.store(point.hourglass_left, left_.data());
  }
  if (options_.explains()) {
    for (int c = 0; c < D * D; ++c) slots.store(slots.load(gradient_.component(c)), explained_.component(c));
    slots.store(slots.load(modulus_.data()), explained_.component(D * D));
  }
}

template <int D>
void UpdatedLagrangian<D>::keep_record(const SliceSlots<D>& slots, const Mat<Pack, D>& F, const PointResponse<D>& point,
                                       RecordedState& state) const {
  const Mat3<Pack> F3 = embed(F, point.thickness_stretch), P3 = embed(point.P, point.thickness_stress);
  for (int c = 0; c < 9; ++c) {
    slots.store(F3[c / 3][c % 3], state.deformation_gradient.component(c));
    slots.store(P3[c / 3][c % 3], state.stress.component(c));
  }
  slots.store(point.energy, state.energy_density.data());
  if (state.inelastic.empty()) return;
  slots.store(point.plastic.strain, state.inelastic.component(0));
  slots.store(point.plastic.work, state.inelastic.component(1));
  slots.store(point.plastic.temperature, state.inelastic.component(2));
  slots.store(point.damage.now, state.inelastic.component(3));
}

template <int D>
ForceSummary UpdatedLagrangian<D>::update_block(int b, const Particles<D>& particles, PointStep step, RecordedState* record) {
  const Block& block = pairs_.blocks.all[b];
  UpdateSums sums;
  for (int slice = block.first_slice; slice < block.end_slice; ++slice)
    update_slice(b, SliceSlots<D>(pairs_, block, slice), particles, step, record, sums);
  ForceSummary summary;
  summary.strain_energy = sum(sums.energy);
  summary.plastic_work = sum(sums.plastic_work);
  summary.damage_work = sum(sums.damage_work);
  summary.smallest_jacobian = smallest(sums.jacobian);
  return summary;
}

#define SINEW_INSTANTIATE(D)                                                                                                  \
  template void UpdatedLagrangian<D>::update_slice(int, const SliceSlots<D>&, const Particles<D>&, PointStep, RecordedState*, \
                                                   UpdateSums&);                                                              \
  template void UpdatedLagrangian<D>::give_stress(int, const SliceSlots<D>&, const Mat<Pack, D>&, const PointResponse<D>&);   \
  template void UpdatedLagrangian<D>::keep_record(const SliceSlots<D>&, const Mat<Pack, D>&, const PointResponse<D>&,         \
                                                  RecordedState&) const;                                                      \
  template ForceSummary UpdatedLagrangian<D>::update_block(int, const Particles<D>&, PointStep, RecordedState*);
SINEW_INSTANTIATE(2)
SINEW_INSTANTIATE(3)

}  // namespace sinew
