#pragma once
/// The block of the benchmarks: particles, options, motion, and the plain solver with the same particles and neighbors.

#include <random>

#include "plain_tlsph.hpp"
#include <sinew/formulations/total_lagrangian.hpp>

namespace sinew::benchmark {

inline constexpr double support = 2.41;

inline StVenantKirchhoff material() {
  StVenantKirchhoff m;
  m.density = 1.0;
  m.elastic.youngs_modulus = 1.0;
  m.elastic.poissons_ratio = 0.3;
  m.elastic.complete();
  return m;
}

/// The form of the hourglass force; the plain solver has both.
inline HourglassStiffness hourglass(bool conservative) {
  HourglassStiffness h;
  h.normalization.value = conservative ? "conservative" : "half";
  return h;
}

template <int D>
PointSet block(int n, double jitter) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> move(-jitter, jitter);
  PointSet points;
  points.spacing = 1.0;
  for (int k = 0; k < (D == 3 ? n : 1); ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        points.position.push_back({{i + move(random), j + move(random), D == 3 ? k + move(random) : 0.0}});
        points.volume.push_back(1.0);
      }
  return points;
}

/// The plain solver with the particles in the same order and with the same neighbors.
template <int D>
plain::Solver<D> plain_solver(const Particles<D>& particles, const PairList& list, bool conservative) {
  const StVenantKirchhoff m = material();
  plain::Solver<D> solver;
  solver.c = {m.elastic.lambda(), m.elastic.mu(), m.elastic.youngs_modulus, support, hourglass(conservative).coefficient(),
              conservative};
  std::vector<int> number(particles.slots, -1);
  for (int slot = 0, next = 0; slot < particles.slots; ++slot)
    if (particles.user_index[slot] >= 0) number[slot] = next++;
  solver.first.push_back(0);
  for (int slot = 0; slot < particles.slots; ++slot) {
    if (number[slot] < 0) continue;
    plain::Particle<D> p{};
    p.X = particles.position[slot];
    p.x = p.X + particles.displacement[slot];
    p.v = particles.velocity[slot];
    p.volume = p.mass = 1.0;
    solver.particles.push_back(p);
    for (int n = 0; n < list.neighbor_count[slot]; ++n)
      solver.neighbors.push_back(number[list.neighbor[lanes * (list.first_entry[slot / lanes] + n) + slot % lanes]]);
    solver.first.push_back(solver.neighbors.size());
  }
  solver.compute_corrections();
  return solver;
}

template <int D>
void set_motion(Particles<D>& particles) {
  for (int slot : particles.slot_of)
    for (int c = 0; c < D; ++c) {
      const double X = particles.position.at((c + 1) % D, slot);
      particles.displacement.at(c, slot) = 0.05 * std::sin(0.3 * X + c);
      particles.velocity.at(c, slot) = 0.01 * std::cos(0.2 * X - c);
    }
}

}  // namespace sinew::benchmark
