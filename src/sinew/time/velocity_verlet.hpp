#pragma once
/// Velocity Verlet (leapfrog) with mass-proportional damping: a half kick, a drift, new forces, a half kick.
///
///     v' = (1 - c dt/2) v_n + dt/2 a_n;   u_n+1 = u_n + dt v';   v_n+1 = (v' + dt/2 a_n+1) / (1 + c dt/2)
///
/// a: acceleration without damping, c: damping rate [1/time]. Second order; without damping symplectic and reversible.

#include <sinew/neighbors/threads.hpp>
#include <sinew/particles/particles.hpp>
#include <string_view>

namespace sinew {

struct VelocityVerlet {
  static constexpr std::string_view name = "velocity_verlet";
  static constexpr std::string_view summary = "Leapfrog in kick-drift-kick form: second order, symplectic for a fixed step";
  static constexpr std::string_view source = "Swope et al. (1982); Ganzenmueller (2015), sec. 4";
  static void describe(auto&&, auto&) {}
};

template <int D>
void kick_and_drift(Particles<D>& particles, double dt, double damping) {
  const double keep = 1.0 - 0.5 * dt * damping;
  for_each_piece(particles.slots, [&](int begin, int end) {
    for (int c = 0; c < D; ++c) {
      double* __restrict v = particles.velocity.component(c);
      double* __restrict u = particles.displacement.component(c);
      const double* __restrict a = particles.acceleration.component(c);
      for (int slot = begin; slot < end; ++slot) {
        v[slot] = keep * v[slot] + 0.5 * dt * a[slot];
        u[slot] += dt * v[slot];
      }
    }
  });
}

/// Turns the forces on slots [begin, end) into accelerations (plus `gravity`), clears them and completes the velocities. dt = 0 at the
/// start of a run.
template <int D>
struct AccelerateAndKick {
  Particles<D>& particles;
  VectorField<D>& forces;
  Vec<double, D> gravity;
  double dt, damping;

  void operator()(int begin, int end) const {
    const double share = 1.0 / (1.0 + 0.5 * dt * damping);
    const double* __restrict mass = particles.mass.data();
    for (int c = 0; c < D; ++c) {
      double* __restrict v = particles.velocity.component(c);
      double* __restrict a = particles.acceleration.component(c);
      double* __restrict f = forces.component(c);
      for (int slot = begin; slot < end; ++slot) {
        const double inverse_mass = mass[slot] > 0.0 ? 1.0 / mass[slot] : 0.0;  // padding stays where it is
        a[slot] = mass[slot] > 0.0 ? f[slot] * inverse_mass + gravity[c] : 0.0;
        f[slot] = 0.0;
        v[slot] = share * (v[slot] + 0.5 * dt * a[slot]);
      }
    }
  }
};

}  // namespace sinew
