#pragma once
/// Velocity Verlet (leapfrog) with mass-proportional damping: a half kick, a drift, new forces, a half kick.
///
///     v' = (1 - c dt/2) v_n + dt/2 a_n;   u_n+1 = u_n + dt v';   v_n+1 = (v' + dt/2 a_n+1) / (1 + c dt/2)
///
/// a: acceleration without damping, c: damping rate [1/time]. Second order; without damping symplectic and reversible.

#include <sinew/neighbors/chunks.hpp>
#include <string_view>

namespace sinew {

struct VelocityVerlet {
  static constexpr std::string_view name = "velocity_verlet";
  static constexpr std::string_view summary = "Leapfrog in kick-drift-kick form, second order, conserves energy";
  static constexpr std::string_view source = "Ganzenmueller (2015), sec. 4; Verlet (1967)";
};

template <int D>
void kick_and_drift(Particles<D>& particles, double dt, double damping) {
  constexpr int n = vector_width<D>;
  const double keep = 1.0 - 0.5 * dt * damping;
  for_each_piece(particles.slots, [&](int begin, int end) {
    for (int slot = begin; slot < end; ++slot) {
      double* v = particles.velocity_row(slot);
      double* u = particles.place_row(slot);
      const double* a = particles.acceleration_row(slot);
      for (int c = 0; c < n; ++c) {
        v[c] = keep * v[c] + 0.5 * dt * a[c];
        u[c] += dt * v[c];
      }
    }
  });
}

/// Turns the force streams into accelerations (plus `gravity`), clears the streams and completes the velocities. dt = 0 at the start of a run.
template <int D>
void accelerate_and_kick(Particles<D>& particles, ForceStreams<D>& forces, const Vec<double, D>& gravity, double dt,
                         double damping) {
  constexpr int n = vector_width<D>;
  const double share = 1.0 / (1.0 + 0.5 * dt * damping);
  double g[n] = {};
  for (int c = 0; c < D; ++c) g[c] = gravity[c];
  for_each_piece(particles.slots, [&](int begin, int end) {
    for (int slot = begin; slot < end; ++slot) {
      const double mass = particles.mass[slot];
      const double inverse_mass = mass > 0.0 ? 1.0 / mass : 0.0;  // padding stays where it is
      const double falls = mass > 0.0 ? 1.0 : 0.0;
      double* v = particles.velocity.data() + std::size_t(n) * slot;
      double* a = particles.acceleration.data() + std::size_t(n) * slot;
      double* even = forces.stream[0].data() + std::size_t(n) * slot;
      double* odd = forces.stream[1].data() + std::size_t(n) * slot;
      for (int c = 0; c < n; ++c) {
        a[c] = (even[c] + odd[c]) * inverse_mass + falls * g[c];
        even[c] = odd[c] = 0.0;
        v[c] = share * (v[c] + 0.5 * dt * a[c]);
      }
    }
  });
}

}  // namespace sinew
