#pragma once
/// Three-stage Runge-Kutta method, strong-stability preserving, with mass-proportional damping. With U = (u, v) and R = (v, a - c v)
///
///     U1 = U + dt R(U);   U2 = 3/4 U + 1/4 (U1 + dt R(U1));   U_n+1 = 1/3 U + 2/3 (U2 + dt R(U2))
///
/// a: acceleration without damping, c: damping rate [1/time]. Third order; stable up to omega dt = 1.73, and up to a damping rate of 2.5 / dt. The states after the
/// stages belong to the times t + dt, t + dt/2, t + dt.

#include <algorithm>
#include <sinew/neighbors/threads.hpp>
#include <sinew/particles/particles.hpp>
#include <string_view>

namespace sinew {

struct RungeKutta3 {
  static constexpr std::string_view name = "rk3";
  static constexpr std::string_view summary = "Three-stage Runge-Kutta, third order, damps what it cannot resolve";
  static constexpr std::string_view source = "Shu & Osher (1988); Wiragunarsa et al. (2024), eq. 30";

  static void describe(auto&&, auto&) {}

  static constexpr int stages = 3;
  /// What a stage makes: begin U + rest (U' + dt R(U')), U' the state before it; and to which part of the step the result belongs.
  struct Stage {
    double begin, rest, when;
  };
  static constexpr Stage stage[stages] = {{0.0, 1.0, 1.0}, {0.75, 0.25, 0.5}, {1.0 / 3.0, 2.0 / 3.0, 1.0}};
};

/// The state at the beginning of a step, and what it becomes.
template <int D>
class RungeKuttaStep {
 public:
  explicit RungeKuttaStep(int slots) : displacement_(slots), velocity_(slots) {}

  void begin(const Particles<D>& particles) {
    for_each_piece(particles.slots, [&](int first, int end) {
      for (int c = 0; c < D; ++c) {
        std::copy(particles.displacement.component(c) + first, particles.displacement.component(c) + end,
                  displacement_.component(c) + first);
        std::copy(particles.velocity.component(c) + first, particles.velocity.component(c) + end, velocity_.component(c) + first);
      }
    });
  }
  /// From the accelerations of the current state.
  void advance(Particles<D>& particles, const RungeKutta3::Stage& stage, double dt, double damping) const {
    for_each_piece(particles.slots, [&](int first, int end) {
      for (int c = 0; c < D; ++c) {
        const double* __restrict u0 = displacement_.component(c);
        const double* __restrict v0 = velocity_.component(c);
        const double* __restrict a = particles.acceleration.component(c);
        double* __restrict u = particles.displacement.component(c);
        double* __restrict v = particles.velocity.component(c);
        for (int slot = first; slot < end; ++slot) {
          const double v_now = v[slot];
          u[slot] = stage.begin * u0[slot] + stage.rest * (u[slot] + dt * v_now);
          v[slot] = stage.begin * v0[slot] + stage.rest * (v_now + dt * (a[slot] - damping * v_now));
        }
      }
    });
  }
  std::size_t bytes() const { return displacement_.bytes() + velocity_.bytes(); }

 private:
  VectorField<D> displacement_, velocity_;
};

}  // namespace sinew
