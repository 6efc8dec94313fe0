#pragma once
/// Sums over all particles, in computing order: the same bits for any number of threads.

#include <sinew/model/simulation.hpp>
#include <sinew/particles/particles.hpp>

namespace sinew {

/// Sum of m v^2 / 2 [energy].
template <int D>
double kinetic_energy(const Particles<D>& particles) {
  double sum = 0.0;
  for (int slot = 0; slot < particles.slots; ++slot) {
    const Vec<double, D> v = particles.velocity[slot];
    sum += 0.5 * particles.mass[slot] * dot(v, v);
  }
  return sum;
}

/// Work of a constant body force since the reference configuration: sum of m g.u [energy].
template <int D>
double gravity_work(const Vec<double, D>& gravity, const Particles<D>& particles) {
  if (dot(gravity, gravity) == 0.0) return 0.0;
  double sum = 0.0;
  for (int slot = 0; slot < particles.slots; ++slot)
    for (int c = 0; c < D; ++c) sum += particles.mass[slot] * gravity[c] * particles.displacement.at(c, slot);
  return sum;
}

template <int D>
Momenta momenta_of(const Particles<D>& particles) {
  Momenta m;
  for (int slot = 0; slot < particles.slots; ++slot) {
    Point p;
    for (int c = 0; c < D; ++c) p[c] = particles.mass[slot] * particles.velocity.at(c, slot);
    m.linear += p;
    m.angular += cross(particles.current(slot), p);
    m.linear_scale += norm(p);
  }
  return m;
}

}  // namespace sinew
