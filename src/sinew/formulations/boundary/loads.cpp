#include <sinew/formulations/boundary/loads.hpp>

namespace sinew {

namespace {

template <int D>
double pressure_on(const FollowerCondition<D>& condition, int slot, const Particles<D>& particles, double t) {
  return condition.pressure(particles.reference(slot), particles.current(slot), t);
}

template <int D>
Vec<double, D> follower_force(const FollowerCondition<D>& condition, const typename FollowerCondition<D>::Surface& surface,
                              const Particles<D>& particles, double t) {
  const Mat<double, D> F = Mat<double, D>::identity() + surface.stencil.gradient_of(particles.displacement);
  return -pressure_on(condition, surface.stencil.slots[0], particles, t) * (cofactor(F) * surface.normal_area);
}

/// What cof F changes by, to first order, if F changes by G. It is linear in F in the plane and of second order in space.
Mat<double, 2> cofactor_change(const Mat<double, 2>& /*F*/, const Mat<double, 2>& G) { return cofactor(G); }
Mat<double, 3> cofactor_change(const Mat<double, 3>& F, const Mat<double, 3>& G) {
  return cofactor(F + G) - cofactor(F) - cofactor(G);
}

}  // namespace

template <int D>
Loads<D>::Loads(std::vector<LoadCondition> conditions, std::vector<FollowerCondition<D>> followers, const Particles<D>& particles)
    : work_(particles.blocks.size(), 0.0) {
  for (FollowerCondition<D>& condition : followers) {
    const std::size_t count = condition.surfaces.size();
    followers_.push_back({std::move(condition), std::vector<Vec<double, D>>(count), std::vector<Vec<double, D>>(count)});
  }
  for (LoadCondition& condition : conditions) {
    Applied applied{condition.component, std::move(condition.function), {}};
    for (std::size_t k = 0; k < condition.slots.size(); ++k)
      applied.entries.push_back({condition.slots[k], particles.block_of(condition.slots[k]), condition.share[k]});
    conditions_.push_back(std::move(applied));
  }
}

template <int D>
void Loads<D>::remember(const Particles<D>& particles) {
  for (Applied& applied : conditions_)
    for (Entry& entry : applied.entries) entry.previous_u = particles.displacement.at(applied.component, entry.slot);
  for (Follower& follower : followers_)
    for (std::size_t k = 0; k < follower.previous_u.size(); ++k)
      follower.previous_u[k] = particles.displacement[follower.condition.surfaces[k].stencil.slots[0]];
}

template <int D>
template <class Use>
void Loads<D>::for_each(const Particles<D>& particles, double t, Use&& use) {
  for (Applied& applied : conditions_) {
    double value = 0.0;
    for (std::size_t k = 0; k < applied.entries.size(); ++k) {
      Entry& entry = applied.entries[k];
      if (k == 0 || applied.function.depends_on_place)
        value = applied.function(particles.reference(entry.slot), particles.current(entry.slot), t);
      use(applied, entry, entry.share * value);
    }
  }
}

template <int D>
void Loads<D>::add(const Particles<D>& particles, double t, double dt, VectorField<D>& forces) {
  for_each(particles, t, [&](const Applied& applied, Entry& entry, double force) {
    forces.at(applied.component, entry.slot) += force;
    if (dt > 0.0)
      work_[entry.block] +=
          0.5 * (entry.force + force) * (particles.displacement.at(applied.component, entry.slot) - entry.previous_u);
    entry.force = force;
  });
  add_followers(particles, t, dt, forces);
}

template <int D>
void Loads<D>::add(const Particles<D>& particles, double t, VectorField<D>& forces) {
  for_each(particles, t,
           [&](const Applied& applied, const Entry& entry, double force) { forces.at(applied.component, entry.slot) += force; });
  for (const Follower& follower : followers_)
    for (const auto& surface : follower.condition.surfaces) {
      const int slot = surface.stencil.slots[0];
      forces.set(slot, forces[slot] + follower_force(follower.condition, surface, particles, t));
    }
}

template <int D>
void Loads<D>::add_followers(const Particles<D>& particles, double t, double dt, VectorField<D>& forces) {
  for (Follower& follower : followers_)
    for (std::size_t k = 0; k < follower.force.size(); ++k) {
      const auto& surface = follower.condition.surfaces[k];
      const int slot = surface.stencil.slots[0];
      const Vec<double, D> force = follower_force(follower.condition, surface, particles, t);
      forces.set(slot, forces[slot] + force);
      if (dt > 0.0)
        work_[particles.block_of(slot)] +=
            0.5 * dot(follower.force[k] + force, particles.displacement[slot] - follower.previous_u[k]);
      follower.force[k] = force;
    }
}

template <int D>
void Loads<D>::add_change(const Particles<D>& particles, const VectorField<D>& direction, double t,
                          VectorField<D>& forces) const {
  for (const Follower& follower : followers_)
    for (const auto& surface : follower.condition.surfaces) {
      const int slot = surface.stencil.slots[0];
      const Mat<double, D> F = Mat<double, D>::identity() + surface.stencil.gradient_of(particles.displacement);
      const double p = pressure_on(follower.condition, slot, particles, t);
      forces.set(slot, forces[slot] - p * (cofactor_change(F, surface.stencil.gradient_of(direction)) * surface.normal_area));
    }
}

template <int D>
void Loads<D>::for_each_stiffness(const Particles<D>& particles, double t,
                                  FunctionRef<void(std::span<const int>, std::span<const double>)> use) const {
  std::vector<double> matrix;
  for (const Follower& follower : followers_)
    for (const auto& surface : follower.condition.surfaces) {
      const Stencil<D>& stencil = surface.stencil;
      const std::size_t size = static_cast<std::size_t>(D) * stencil.size();
      matrix.assign(size * size, 0.0);
      const Mat<double, D> F = Mat<double, D>::identity() + stencil.gradient_of(particles.displacement);
      const double p = pressure_on(follower.condition, stencil.slots[0], particles, t);
      for (std::size_t column = 0; column < size; ++column) {
        Vec<double, D> axis{};
        axis[column % D] = 1.0;
        const Vec<double, D> change = p * (cofactor_change(F, outer(axis, stencil.gradient[column / D])) * surface.normal_area);
        for (int c = 0; c < D; ++c) matrix[c * size + column] = change[c];
      }
      use(stencil.slots, matrix);
    }
}

template <int D>
void Loads<D>::restore(const Particles<D>& particles, double t, std::vector<double> work) {
  for_each(particles, t, [](const Applied&, Entry& entry, double force) { entry.force = force; });
  for (Follower& follower : followers_)
    for (std::size_t k = 0; k < follower.force.size(); ++k)
      follower.force[k] = follower_force(follower.condition, follower.condition.surfaces[k], particles, t);
  work_ = std::move(work);
}

template class Loads<2>;
template class Loads<3>;

}  // namespace sinew
