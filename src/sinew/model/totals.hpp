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
  Pack work;
  for (int slot = 0; slot < particles.slots; slot += lanes) {
    Pack along;
    for (int c = 0; c < D; ++c) along += gravity[c] * Pack::load(particles.displacement.component(c) + slot);
    work += Pack::load(particles.mass.data() + slot) * along;
  }
  return sum(work);
}

/// What follows from the places and velocities of the particles alone.
struct Totals {
  double kinetic = 0.0;  ///< sum m v^2 / 2 [energy]
  Momenta momenta;
  double gravity_work = 0.0;
};

/// Kinetic energy; momenta: sums of m v, of x cross m v about the origin, and of |m v|. All in one pass, since it is limited by memory.
template <int D>
Totals totals_of(const Particles<D>& particles, const Vec<double, D>& gravity) {
  Vec<Pack, 3> linear, angular;
  Pack scale, twice;
  for (int slot = 0; slot < particles.slots; slot += lanes) {
    const Pack mass = Pack::load(particles.mass.data() + slot);
    Vec<Pack, 3> x, v;
    for (int c = 0; c < D; ++c) {
      x[c] = Pack::load(particles.position.component(c) + slot) + Pack::load(particles.displacement.component(c) + slot);
      v[c] = Pack::load(particles.velocity.component(c) + slot);
    }
    const Vec<Pack, 3> p = mass * v;
    const Pack square = dot(v, v);
    linear += p;
    angular += cross(x, p);
    scale += mass * sqrt(square);
    twice += mass * square;
  }
  Totals t;
  for (int c = 0; c < 3; ++c) t.momenta.linear[c] = sum(linear[c]), t.momenta.angular[c] = sum(angular[c]);
  t.momenta.linear_scale = sum(scale);
  t.kinetic = 0.5 * sum(twice);
  t.gravity_work = gravity_work(gravity, particles);
  return t;
}

}  // namespace sinew
