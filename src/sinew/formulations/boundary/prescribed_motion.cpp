#include <sinew/formulations/boundary/prescribed_motion.hpp>

namespace sinew {

namespace {

/// Central differences of the prescribed function over `width` around its time.
struct Samples {
  double before = 0.0, now = 0.0, after = 0.0;
};

template <int D>
Samples sample(const FieldFunction& f, const Particles<D>& particles, int slot, double t, double width) {
  const Point X = particles.reference(slot), x = particles.current(slot);
  return {f(X, x, t - 0.5 * width), f(X, x, t), f(X, x, t + 0.5 * width)};
}

}  // namespace

template <int D>
PrescribedMotion<D>::PrescribedMotion(std::vector<MotionCondition> conditions) {
  for (MotionCondition& condition : conditions) {
    Held held{std::move(condition), {}};
    for (int slot : held.condition.slots) held.entries.push_back({slot});
    conditions_.push_back(std::move(held));
  }
}

template <int D>
void PrescribedMotion<D>::remember(const Particles<D>& particles) {
  for (Held& held : conditions_)
    for (Entry& entry : held.entries) entry.previous_u = particles.displacement.at(held.condition.component, entry.slot);
}

template <int D>
void PrescribedMotion<D>::move(Particles<D>& particles, double t, double dt) {
  for (Held& held : conditions_) {
    const MotionCondition& c = held.condition;
    const bool displacement = c.kind == MotionCondition::Kind::displacement;
    const double when = displacement ? t + dt : t + 0.5 * dt;
    double value = 0.0;
    for (std::size_t k = 0; k < held.entries.size(); ++k) {
      Entry& entry = held.entries[k];
      double& u = particles.displacement.at(c.component, entry.slot);
      u = entry.previous_u;
      if (k == 0 || c.function.depends_on_place)
        value = c.function(particles.reference(entry.slot), particles.current(entry.slot), when);
      u = displacement ? value : entry.previous_u + dt * value;
    }
  }
}

template <int D>
void PrescribedMotion<D>::hold(Particles<D>& particles, double t, double dt, double damping) {
  for (Held& held : conditions_) {
    const MotionCondition& c = held.condition;
    Samples s;
    for (std::size_t k = 0; k < held.entries.size(); ++k) {
      Entry& entry = held.entries[k];
      if (k == 0 || c.function.depends_on_place) s = sample(c.function, particles, entry.slot, t, dt);
      double velocity = s.now, acceleration = dt > 0.0 ? (s.after - s.before) / dt : 0.0;
      if (c.kind == MotionCondition::Kind::displacement) {
        velocity = acceleration;
        acceleration = dt > 0.0 ? 4.0 * (s.after - 2.0 * s.now + s.before) / (dt * dt) : 0.0;
      }
      double& a = particles.acceleration.at(c.component, entry.slot);
      const double reaction = particles.mass[entry.slot] * (acceleration + damping * velocity - a);
      work_ += 0.5 * (entry.reaction + reaction) * (particles.displacement.at(c.component, entry.slot) - entry.previous_u) *
               (dt > 0.0);
      entry.reaction = reaction;
      particles.velocity.at(c.component, entry.slot) = velocity;
      a = acceleration;
    }
  }
}

template <int D>
VectorField<D> PrescribedMotion<D>::reaction_field(int slots) const {
  VectorField<D> field(slots);
  for (const Held& held : conditions_)
    for (const Entry& entry : held.entries) field.at(held.condition.component, entry.slot) += entry.reaction;
  return field;
}

template <int D>
std::vector<double> PrescribedMotion<D>::reactions() const {
  std::vector<double> all;
  for (const Held& held : conditions_)
    for (const Entry& entry : held.entries) all.push_back(entry.reaction);
  return all;
}

template <int D>
void PrescribedMotion<D>::restore(const std::vector<double>& reactions, double work) {
  std::size_t k = 0;
  for (Held& held : conditions_)
    for (Entry& entry : held.entries) entry.reaction = reactions.at(k++);
  work_ = work;
}

template class PrescribedMotion<2>;
template class PrescribedMotion<3>;

}  // namespace sinew
