#pragma once
/// Sums over all particles of all ranks. Each block adds up on its own, eight particles at a time; blocks are added in their order: the same bits for any
/// number of threads and ranks.

#include <sinew/model/simulation.hpp>
#include <sinew/neighbors/eight_of_block.hpp>
#include <sinew/parallel/comm.hpp>

namespace sinew {

/// Sum of m v^2 / 2 over each block [energy].
template <int D>
void kinetic_energies(const Particles<D>& particles, std::vector<double>& energies) {
  const auto sums = [&](const BlockRange& block) -> std::array<double, 1> {
    Pack twice;
    for_each_eight(block, [&](const EightOfBlock& load) {
      Pack square;
      for (int c = 0; c < D; ++c) {
        const Pack v = load(particles.velocity.component(c));
        square += v * v;
      }
      twice += load(particles.mass.data()) * square;
    });
    return {0.5 * sum(twice)};
  };
  of_each_block<1>(particles, sums, energies);
}

/// What follows from the places and velocities of the particles alone.
struct Totals {
  double kinetic = 0.0;  ///< sum m v^2 / 2 [energy]
  Momenta momenta;
  double gravity_work = 0.0;  ///< of a constant body force since the reference configuration: sum of m g.u [energy]
};

/// Sums over one block of m v, x cross m v (about the origin), |m v|, m v^2, m g.u. All in one pass, since it is limited by memory.
template <int D>
std::array<double, 9> block_totals(const Particles<D>& particles, const BlockRange& block, const Vec<double, D>& gravity) {
  Vec<Pack, 3> linear, angular;
  Pack scale, twice, work;
  for_each_eight(block, [&](const EightOfBlock& load) {
    const Pack mass = load(particles.mass.data());
    Vec<Pack, 3> x, v;
    Pack along;
    for (int c = 0; c < D; ++c) {
      const Pack u = load(particles.displacement.component(c));
      x[c] = load(particles.position.component(c)) + u;
      v[c] = load(particles.velocity.component(c));
      along += gravity[c] * u;
    }
    const Vec<Pack, 3> p = mass * v;
    const Pack square = dot(v, v);
    linear += p;
    angular += cross(x, p);
    scale += mass * sqrt(square);
    twice += mass * square;
    work += mass * along;
  });
  return {sum(linear[0]),  sum(linear[1]), sum(linear[2]), sum(angular[0]), sum(angular[1]),
          sum(angular[2]), sum(scale),     sum(twice),     sum(work)};
}

/// Collective.
template <int D>
Totals totals_of(const Comm& comm, const Particles<D>& particles, const Vec<double, D>& gravity) {
  const auto sums = [&](const BlockRange& block) { return block_totals(particles, block, gravity); };
  std::vector<double> all;
  of_each_block<9>(particles, sums, all);
  all = sum_over_blocks(comm, particles.block_numbers(), all, 9);
  Totals t;
  for (int c = 0; c < 3; ++c) t.momenta.linear[c] = all[c], t.momenta.angular[c] = all[3 + c];
  t.momenta.linear_scale = all[6];
  t.kinetic = 0.5 * all[7];
  t.gravity_work = all[8];
  return t;
}

}  // namespace sinew
