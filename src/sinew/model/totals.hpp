#pragma once
/// Sums over all particles, eight at a time in computing order: the same bits for any number of threads.

#include <sinew/core/pack.hpp>
#include <sinew/model/simulation.hpp>
#include <sinew/particles/particles.hpp>

namespace sinew {

/// Sum of m v^2 / 2 [energy]. Padding has no mass.
template <int D>
double kinetic_energy(const Particles<D>& particles) {
  Pack twice;
  for (int slot = 0; slot < particles.slots; slot += lanes) {
    Pack square;
    for (int c = 0; c < D; ++c) {
      const Pack v = Pack::load(particles.velocity.component(c) + slot);
      square += v * v;
    }
    twice += Pack::load(particles.mass.data() + slot) * square;
  }
  return 0.5 * sum(twice);
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

/// Momenta: sums of m v, of x cross m v about the origin, and of |m v|.
template <int D>
Momenta momenta_of(const Particles<D>& particles) {
  Vec<Pack, 3> linear, angular;
  Pack scale;
  for (int slot = 0; slot < particles.slots; slot += lanes) {
    const Pack mass = Pack::load(particles.mass.data() + slot);
    Vec<Pack, 3> x, p;
    for (int c = 0; c < D; ++c) {
      x[c] = Pack::load(particles.position.component(c) + slot) + Pack::load(particles.displacement.component(c) + slot);
      p[c] = mass * Pack::load(particles.velocity.component(c) + slot);
    }
    for (int c = 0; c < 3; ++c) {
      const int next = (c + 1) % 3, after = (c + 2) % 3;
      linear[c] += p[c];
      angular[c] += x[next] * p[after] - x[after] * p[next];
    }
    scale += sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
  }
  Momenta m;
  for (int c = 0; c < 3; ++c) m.linear[c] = sum(linear[c]), m.angular[c] = sum(angular[c]);
  m.linear_scale = sum(scale);
  return m;
}

}  // namespace sinew
