#include <sinew/formulations/boundary/loads.hpp>

namespace sinew {

template <int D>
Loads<D>::Loads(std::vector<LoadCondition> conditions) {
  for (LoadCondition& condition : conditions) {
    Applied applied{condition.component, std::move(condition.function), {}};
    for (std::size_t k = 0; k < condition.slots.size(); ++k) applied.entries.push_back({condition.slots[k], condition.share[k]});
    conditions_.push_back(std::move(applied));
  }
}

template <int D>
void Loads<D>::remember(const Particles<D>& particles) {
  for (Applied& applied : conditions_)
    for (Entry& entry : applied.entries) entry.previous_u = particles.displacement.at(applied.component, entry.slot);
}

template <int D>
void Loads<D>::add(const Particles<D>& particles, double t, double dt, VectorField<D>& forces) {
  for (Applied& applied : conditions_) {
    double value = 0.0;
    for (std::size_t k = 0; k < applied.entries.size(); ++k) {
      Entry& entry = applied.entries[k];
      if (k == 0 || applied.function.depends_on_place)
        value = applied.function(particles.reference(entry.slot), particles.current(entry.slot), t);
      const double force = entry.share * value;
      forces.at(applied.component, entry.slot) += force;
      if (dt > 0.0)
        work_ += 0.5 * (entry.force + force) * (particles.displacement.at(applied.component, entry.slot) - entry.previous_u);
      entry.force = force;
    }
  }
}

template <int D>
std::vector<double> Loads<D>::forces() const {
  std::vector<double> all;
  for (const Applied& applied : conditions_)
    for (const Entry& entry : applied.entries) all.push_back(entry.force);
  return all;
}

template <int D>
void Loads<D>::restore(const std::vector<double>& forces, double work) {
  std::size_t k = 0;
  for (Applied& applied : conditions_)
    for (Entry& entry : applied.entries) entry.force = forces.at(k++);
  work_ = work;
}

template class Loads<2>;
template class Loads<3>;

}  // namespace sinew
