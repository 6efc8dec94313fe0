/// Particle-steps per second of a whole step, and the ratio to the plain solver, measured in turns in one run.

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <cstdlib>
#include <random>
#include <string_view>

#include "plain_tlsph.hpp"
#include <sinew/core/timer.hpp>
#include <sinew/formulations/total_lagrangian.hpp>
#include <sinew/time/velocity_verlet.hpp>

namespace {

using namespace sinew;

constexpr double support = 2.41;

StVenantKirchhoff material() {
  StVenantKirchhoff m;
  m.density = 1.0;
  m.elastic.youngs_modulus = 1.0;
  m.elastic.poissons_ratio = 0.3;
  m.elastic.complete();
  return m;
}

/// The form of the hourglass force; the plain solver has both.
HourglassStiffness hourglass(bool conservative) {
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

template <int D>
double largest_difference(const Particles<D>& particles, const plain::Solver<D>& solver) {
  double worst = 0.0, largest = 0.0;
  std::size_t next = 0;
  for (int slot = 0; slot < particles.slots; ++slot) {
    if (particles.user_index[slot] < 0) continue;
    const plain::Particle<D>& p = solver.particles[next++];
    for (int c = 0; c < D; ++c) {
      worst = std::max(worst, std::abs(particles.acceleration.at(c, slot) - p.f[c]));
      largest = std::max(largest, std::abs(p.f[c]));
    }
  }
  return worst / largest;
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

struct Options {
  int size3 = 64, size2 = 512, repeats = 5, threads = 1;
  bool conservative = true;
  WeightStorage weights = WeightStorage::stored;
};

template <int D>
void run(int n, double jitter, const Options& o) {
  const PointSet points = block<D>(n, jitter);
  Particles<D> particles = make_particles<D>({{"block", &points, 1.0, 1.0}}, 1.0);
  const Stopwatch setup;
  const TotalLagrangian<D> solid(particles, std::vector<double>(particles.slots, support),
                                 {Spiky{}, GradientCorrection{}, hourglass(o.conservative), {material()}, false, 1.0, o.weights});
  const double setup_seconds = setup.seconds();
  set_motion(particles);
  ForceStreams<D> forces = solid.make_streams();
  plain::Solver<D> solver =
      plain_solver(particles, build_pair_list(particles, std::vector<double>(particles.slots, support)), o.conservative);
  const double dt = 0.05;
  auto accelerate = [&](double step) {
    solid.internal_forces(particles, forces, AccelerateAndKick<D>{particles, forces, {}, step, 0.0});
  };
  accelerate(0.0);
  solver.compute_forces();
  const double difference = largest_difference(particles, solver);

  constexpr int steps = 3;
  std::vector<double> ours, sweep, theirs;
  for (int r = 0; r < o.repeats; ++r) {
    const Stopwatch fast;
    for (int k = 0; k < steps; ++k) {
      kick_and_drift(particles, dt, 0.0);
      accelerate(dt);
    }
    ours.push_back(fast.seconds() / steps);
    const Stopwatch pairs_only;
    solid.internal_forces(particles, forces);
    sweep.push_back(pairs_only.seconds());
    for (int s = 0; s < 2; ++s) {
      std::fill(forces.rows[s].begin(), forces.rows[s].end(), 0.0);
      forces.fields[s].clear();
    }
    const Stopwatch slow;
    solver.step(dt);
    theirs.push_back(slow.seconds());
  }
  const double pairs = static_cast<double>(solid.pairs().pairs);
  const double bytes = static_cast<double>(particles.bytes() + solid.bytes() + forces.bytes()) / particles.count;
  const double counted = 60.0 * 8.0 + pairs / particles.count * 20.0;
  fmt::print(
      "{}D {:>4}^{} {:<9} {:5.1f} neighbors | step {:7.3f} million particle-steps/s | {:5.2f} ns a pair in the sweep | plain "
      "{:6.3f} | ratio {:5.2f} | "
      "{:5.0f} bytes a particle ({:4.2f} of the count) | set-up {:4.0f} steps | forces differ by {:.0e}\n",
      D, n, D, jitter > 0.0 ? "jittered" : "lattice", pairs / particles.count, 1e-6 * particles.count / median(ours),
      1e9 * median(sweep) / pairs, 1e-6 * particles.count / median(theirs), median(theirs) / median(ours), bytes, bytes / counted,
      setup_seconds / median(ours), difference);
}

}  // namespace

int main(int count, char** words) {
  Options o;
  for (int k = 1; k + 1 < count; k += 2) {
    const std::string_view word = words[k];
    const int value = std::atoi(words[k + 1]);
    if (word == "--size")
      o.size3 = value;
    else if (word == "--size2")
      o.size2 = value;
    else if (word == "--repeats")
      o.repeats = value;
    else if (word == "--threads")
      o.threads = value;
    else if (word == "--weights")
      o.weights = words[k + 1][1] == 't'   ? WeightStorage::stored
                  : words[k + 1][1] == 'i' ? WeightStorage::single
                                           : WeightStorage::computed;
    else if (word == "--conservative")
      o.conservative = value != 0;
    else
      return fmt::print("unknown option {}; known: --size --size2 --repeats --threads --conservative\n", word), 2;
  }
  omp_set_num_threads(o.threads);
  fmt::print("one step of St. Venant-Kirchhoff with hourglass control, {} thread(s), median of {}\n", o.threads, o.repeats);
  run<3>(o.size3, 0.2, o);
  run<3>(o.size3, 0.0, o);
  run<2>(o.size2, 0.2, o);
  run<2>(o.size2, 0.0, o);
}
