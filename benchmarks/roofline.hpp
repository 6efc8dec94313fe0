#pragma once
/// What the machine can do at this moment, and what a step needs at least: the roofline of the benchmarks.

#include <omp.h>

#include <algorithm>
#include <sinew/core/pack.hpp>
#include <sinew/core/timer.hpp>
#include <sinew/particles/aligned_array.hpp>

namespace sinew::benchmark {

struct Machine {
  double flops_per_second;  ///< fused multiply-adds of doubles, two each
  double bytes_per_second;  ///< read from main memory
};

/// Chains of multiply-adds in registers, enough of them to fill the pipelines.
inline double multiply_adds_per_second(int threads) {
  constexpr int chains = 16, rounds = 2'000'000;
  double best = 0.0;
  for (int trial = 0; trial < 3; ++trial) {
    const Stopwatch watch;
    double unused = 0.0;
#pragma omp parallel num_threads(threads) reduction(+ : unused)
    {
      Pack a[chains];
      for (int k = 0; k < chains; ++k) a[k] = Pack(1e-3 * k);
      const Pack factor(0.999999), addend(1e-9);
      for (int r = 0; r < rounds; ++r)
        for (int k = 0; k < chains; ++k) a[k] = a[k] * factor + addend;
      for (int k = 0; k < chains; ++k) unused += sum(a[k]);
    }
    const double flops = 2.0 * lanes * chains * static_cast<double>(rounds) * threads;
    if (unused > 0.0) best = std::max(best, flops / watch.seconds());
  }
  return best;
}

/// Sums of an array that is larger than the caches.
inline double bytes_read_per_second(int threads) {
  AlignedArray<double> data(std::size_t{1} << 25);
  std::fill(data.begin(), data.end(), 1.0);
  double best = 0.0;
  for (int trial = 0; trial < 4; ++trial) {
    const Stopwatch watch;
    double total = 0.0;
#pragma omp parallel for num_threads(threads) schedule(static) reduction(+ : total)
    for (std::size_t block = 0; block < data.size() / 1024; ++block) {
      Pack part[4] = {Pack(0.0), Pack(0.0), Pack(0.0), Pack(0.0)};
      for (std::size_t i = 0; i < 1024; i += 4 * lanes)
        for (int k = 0; k < 4; ++k) part[k] += Pack::load(data.data() + 1024 * block + i + lanes * k);
      total += sum(part[0] + part[1] + part[2] + part[3]);
    }
    if (total > 0.0) best = std::max(best, static_cast<double>(data.bytes()) / watch.seconds());
  }
  return best;
}

inline Machine measure_machine(int threads) { return {multiply_adds_per_second(threads), bytes_read_per_second(threads)}; }

/// How the pairs of a block are kept, as far as it matters to what a step needs.
struct Method {
  bool lattice, conservative;
  int weight_bytes;  ///< of one weight of a listed pair; 0: computed
};

/// Floating-point operations of one directed pair, counted from the formulas (a multiply-add is two, a division one; computing weights is not
/// counted).
template <int D>
double flops_of_pair(const Method& m) {
  constexpr double matrix_vector = D * (2 * D - 1), dot_product = 2 * D - 1;
  const double first = m.lattice ? (D + 2 * D * D) / 2.0 : 2 * D + D + 2 * D * D;  // differences, weight, sum of u (x) X
  const double differences = m.lattice ? D : 0;                                    // kept from the first visit in a list
  const double exchange = D + D;                                                   // added to i, subtracted from j
  const double stress = (m.lattice ? matrix_vector / 2 : D + matrix_vector) + D;   // Q w X, added to the hourglass force
  const double conservative = (m.lattice ? 0.5 : 1) + D + 2 * D;                   // force along u, its energy
  const double central = D + matrix_vector + 3 * dot_product + 3 + 2 + 3 + D;  // x, F X, three products, quotient, energy, force
  return first + differences + exchange + stress + (m.conservative ? conservative : central);
}

/// Bytes that one particle moves between main memory and the caches in a step, if each array passes once for each pass that needs it.
template <int D>
double bytes_of_particle(const Method& m, double neighbors) {
  constexpr double vector = 8 * D, symmetric = 8 * D * (D + 1) / 2;
  const double integration = 2 * vector + 2 * vector + vector + 2 * vector + 2 * vector + 8;  // u, v, a; v, a, mass
  const double forces = 4 * vector;                           // read and written by block and kick
  if (m.lattice) return integration + vector + forces + 0.5;  // u; pattern
  const double pairs = neighbors * (2.0 + m.weight_bytes * (m.conservative ? 1 : 2));
  return integration + pairs + symmetric + 24 + 2 * vector + forces;  // constants; u, X
}

}  // namespace sinew::benchmark
