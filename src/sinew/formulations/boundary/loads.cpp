#include <sinew/formulations/boundary/loads.hpp>

namespace sinew {

template <int D>
Loads<D>::Loads(std::vector<LoadCondition> conditions, const Particles<D>& particles) : work_(particles.blocks.size(), 0.0) {
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
}

template <int D>
void Loads<D>::add(const Particles<D>& particles, double t, VectorField<D>& forces) {
  for_each(particles, t,
           [&](const Applied& applied, const Entry& entry, double force) { forces.at(applied.component, entry.slot) += force; });
}

template <int D>
void Loads<D>::restore(const Particles<D>& particles, double t, std::vector<double> work) {
  for_each(particles, t, [](const Applied&, Entry& entry, double force) { entry.force = force; });
  work_ = std::move(work);
}

template class Loads<2>;
template class Loads<3>;

}  // namespace sinew
