/// Walls of particles: what they are not to do to the material.

#include <sinew/formulations/updated_lagrangian.hpp>

namespace sinew {

template <int D>
void UpdatedLagrangian<D>::stand_before(WallTable<D> walls) {
  walls_ = WallParticles<D>(std::move(walls));
  if (walls_.slipping().empty()) return;
  const std::size_t slots = radius_.size();
  slip_gradient_ = MatrixField<D>(slots);
  slip_force_ = VectorField<D>(slots);
  slip_power_ = AlignedArray<double>(slots);
}

/// Smooth walls add nothing of the motion along them; walls themselves do not deform.
template <int D>
void UpdatedLagrangian<D>::mind_walls_in_gradients(double dt) {
  for (const auto& [pairs, normal] : walls_.slipping()) {
    GradientSweep<D> part = gradient_sweep(pairs, dt, slip_gradient_);
    part.shear = false;
    sweep_velocity_gradients<D>(part);
    for (const int slot : pairs.own_points()) {
      Mat<double, D> L;
      for (int c = 0; c < D * D; ++c) L[c / D][c % D] = slip_gradient_.at(c, slot);
      const Mat<double, D> along = L - outer(normal, transpose(L) * normal);
      for (int c = 0; c < D * D; ++c) gradient_.at(c, slot) -= along[c / D][c % D];
    }
  }
  for (const int slot : walls_.slots())
    for (int c = 0; c < D * D; ++c) gradient_.at(c, slot) = 0.0;
}

/// Smooth walls push across, not along.
template <int D>
void UpdatedLagrangian<D>::mind_walls_in_forces(double dt, VectorField<D>& forces) {
  for (const auto& [pairs, normal] : walls_.slipping()) {
    ForceSweep<D> part = force_sweep(pairs, dt, slip_force_);
    part.explains = false;
    part.viscous_power = part.viscous_rate = part.repulsive_power = slip_power_.data();
    const std::vector<int>& slots = pairs.own_points();
    for (const int slot : slots) slip_force_.set(slot, {});
    sweep_moving_forces<D>(part);
    for (const int slot : slots) {
      const Vec<double, D> f = slip_force_[slot];
      forces.set(slot, forces[slot] - (f - dot(f, normal) * normal));
    }
  }
}

#define SINEW_INSTANTIATE(D)                                           \
  template void UpdatedLagrangian<D>::stand_before(WallTable<D>);      \
  template void UpdatedLagrangian<D>::mind_walls_in_gradients(double); \
  template void UpdatedLagrangian<D>::mind_walls_in_forces(double, VectorField<D>&);
SINEW_INSTANTIATE(2)
SINEW_INSTANTIATE(3)

}  // namespace sinew
