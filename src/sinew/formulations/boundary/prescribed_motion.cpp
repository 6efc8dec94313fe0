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

/// What a condition asks of a particle, from a time step of length dt; all zero but a given velocity if dt is 0.
struct Motion {
  double velocity = 0.0, acceleration = 0.0;
};
template <int D>
Motion motion_of(const MotionCondition& c, const Particles<D>& particles, int slot, double t, double dt) {
  const Samples s = sample(c.function, particles, slot, t, dt);
  const double rate = dt > 0.0 ? (s.after - s.before) / dt : 0.0;
  if (c.kind == MotionCondition::Kind::velocity) return {s.now, rate};
  return {rate, dt > 0.0 ? 4.0 * (s.after - 2.0 * s.now + s.before) / (dt * dt) : 0.0};
}

}  // namespace

template <int D>
PrescribedMotion<D>::PrescribedMotion(std::vector<MotionCondition> conditions, const Particles<D>& particles)
    : work_(particles.blocks.size(), 0.0) {
  for (MotionCondition& condition : conditions) {
    Held held{std::move(condition), {}};
    for (int slot : held.condition.slots) held.entries.push_back({slot, particles.block_of(slot)});
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
      if (dt > 0.0) particles.velocity.at(c.component, entry.slot) = (u - entry.previous_u) / dt;
    }
  }
}

template <int D>
void PrescribedMotion<D>::begin(Particles<D>& particles, double dt, double damping) {
  for (Held& held : conditions_)
    for (Entry& entry : held.entries) {
      const Motion motion = motion_of(held.condition, particles, entry.slot, 0.0, dt);
      double& v = particles.velocity.at(held.condition.component, entry.slot);
      double& a = particles.acceleration.at(held.condition.component, entry.slot);
      entry.reaction += particles.mass[entry.slot] * (motion.acceleration - a + damping * (motion.velocity - v));
      v = motion.velocity;
      a = motion.acceleration;
    }
}

template <int D>
void PrescribedMotion<D>::impose(Particles<D>& particles, double t, double dt) const {
  for (const Held& held : conditions_) {
    const MotionCondition& c = held.condition;
    const bool displacement = c.kind == MotionCondition::Kind::displacement;
    Samples s;
    for (std::size_t k = 0; k < held.entries.size(); ++k) {
      const int slot = held.entries[k].slot;
      if (k == 0 || c.function.depends_on_place) s = sample(c.function, particles, slot, t, dt);
      particles.velocity.at(c.component, slot) = displacement ? (s.after - s.before) / dt : s.now;
      if (displacement) particles.displacement.at(c.component, slot) = s.now;
    }
  }
}

template <int D>
void PrescribedMotion<D>::hold(Particles<D>& particles, double t, double dt, double damping) {
  for (Held& held : conditions_) {
    const MotionCondition& c = held.condition;
    Motion motion;
    for (std::size_t k = 0; k < held.entries.size(); ++k) {
      Entry& entry = held.entries[k];
      if (k == 0 || c.function.depends_on_place) motion = motion_of(c, particles, entry.slot, t, dt);
      double& a = particles.acceleration.at(c.component, entry.slot);
      const double reaction = particles.mass[entry.slot] * (motion.acceleration + damping * motion.velocity - a);
      work_[entry.block] += 0.5 * (entry.reaction + reaction) *
                            (particles.displacement.at(c.component, entry.slot) - entry.previous_u) * (dt > 0.0);
      entry.reaction = reaction;
      particles.velocity.at(c.component, entry.slot) = motion.velocity;
      a = motion.acceleration;
    }
  }
}

template <int D>
void PrescribedMotion<D>::hold_still(Particles<D>& particles, bool counts) {
  for (Held& held : conditions_) {
    const int component = held.condition.component;
    for (Entry& entry : held.entries) {
      double& a = particles.acceleration.at(component, entry.slot);
      const double reaction = -particles.mass[entry.slot] * a;
      if (counts)
        work_[entry.block] +=
            0.5 * (entry.reaction + reaction) * (particles.displacement.at(component, entry.slot) - entry.previous_u);
      entry.reaction = reaction;
      particles.velocity.at(component, entry.slot) = 0.0;
      a = 0.0;
    }
  }
}

template <int D>
void PrescribedMotion<D>::for_each(FunctionRef<void(int, int)> use) const {
  for (const Held& held : conditions_)
    for (const Entry& entry : held.entries) use(entry.slot, held.condition.component);
}

template <int D>
std::vector<Vec<double, D>> PrescribedMotion<D>::reactions_on(const std::vector<int>& slots) const {
  std::vector<Vec<double, D>> sums(work_.size());
  for (const Held& held : conditions_) {
    auto wanted = slots.begin();
    for (const Entry& entry : held.entries) {
      while (wanted != slots.end() && *wanted < entry.slot) ++wanted;
      if (wanted != slots.end() && *wanted == entry.slot) sums[entry.block][held.condition.component] += entry.reaction;
    }
  }
  return sums;
}

template <int D>
std::vector<typename PrescribedMotion<D>::Reaction> PrescribedMotion<D>::reactions() const {
  std::vector<Reaction> all;
  for (std::size_t c = 0; c < conditions_.size(); ++c)
    for (const Entry& entry : conditions_[c].entries) all.push_back({static_cast<int>(c), entry.slot, entry.reaction});
  return all;
}

template <int D>
void PrescribedMotion<D>::restore(FunctionRef<double(int, int)> reaction, std::vector<double> work) {
  for (std::size_t c = 0; c < conditions_.size(); ++c)
    for (Entry& entry : conditions_[c].entries) entry.reaction = reaction(static_cast<int>(c), entry.slot);
  work_ = std::move(work);
}

template class PrescribedMotion<2>;
template class PrescribedMotion<3>;

}  // namespace sinew
