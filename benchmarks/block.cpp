/// Particle-steps per second of whole steps of a block, the ratio to the plain solver measured in turns in the same run, and how near the
/// machine's roofline, measured in the same run too.

#include <fmt/format.h>

#include <cstdlib>
#include <string_view>

#include "block_setup.hpp"
#include "roofline.hpp"
#include <sinew/time/velocity_verlet.hpp>

namespace sinew::benchmark {

struct Options {
  std::vector<int> sizes3{64}, sizes2{512}, threads{1};
  int repeats = 5;
  bool conservative = true, lattice = true;
  WeightStorage weights = WeightStorage::stored;
};

template <int D>
double largest_difference(const Particles<D>& particles, const plain::Solver<D>& solver) {
  double worst = 0.0, largest = 0.0;
  std::size_t next = 0;
  for (int slot = 0; slot < particles.slots; ++slot) {
    if (particles.user_index[slot] < 0) continue;
    const plain::Particle<D>& p = solver.particles[next++];
    worst = std::max(worst, norm(particles.acceleration[slot] - p.f));
    largest = std::max(largest, norm(p.f));
  }
  return worst / largest;
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

/// Seconds of one step, ours and the plain one.
struct Timings {
  std::vector<double> ours, plain;
};

template <int D>
class Block {
 public:
  Block(int n, double jitter, const Options& options)
      : options_(options),
        n_(n),
        jitter_(jitter),
        points_(block<D>(n, jitter)),
        particles_(make_particles<D>({{"block", &points_, 1.0, 1.0}}, 1.0)),
        radius_(particles_.slots, support),
        solid_(particles_, radius_, solver_options()),
        setup_seconds_(watch_.seconds()),
        forces_(particles_.slots) {
    set_motion(particles_);
  }

  void report(int threads, const Machine& machine) {
    omp_set_num_threads(threads);
    plain::Solver<D> solver = plain_solver(particles_, build_pair_list(particles_, radius_), options_.conservative);
    accelerate(0.0);
    solver.compute_forces();
    const double difference = largest_difference(particles_, solver);
    Timings t;
    for (int r = 0; r < options_.repeats; ++r) time_once(solver, t);
    print(threads, machine, t, difference);
  }

 private:
  TotalLagrangianOptions solver_options() const {
    TotalLagrangianOptions o{Spiky{}, GradientCorrection{}, hourglass(options_.conservative), {material()}, false, 1.0};
    o.weights = options_.weights;
    o.lattice = options_.lattice;
    return o;
  }
  void accelerate(double dt) {
    solid_.internal_forces(particles_, forces_, {dt, HistoryUse::advance},
                           AccelerateAndKick<D>{particles_, forces_, {}, dt, 0.0});
  }

  void time_once(plain::Solver<D>& solver, Timings& t) {
    constexpr int steps = 4;
    constexpr double dt = 0.05;
    const Stopwatch fast;
    for (int k = 0; k < steps; ++k) {
      kick_and_drift(particles_, dt, 0.0);
      accelerate(dt);
    }
    t.ours.push_back(fast.seconds() / steps);
    const Stopwatch slow;
    solver.step(dt);
    t.plain.push_back(slow.seconds());
  }

  void print(int threads, const Machine& machine, const Timings& t, double difference) const {
    const double count = particles_.count, neighbors = static_cast<double>(solid_.pairs().pairs) / count;
    const Method method{solid_.lattice().slices() > 0, options_.conservative,
                        options_.weights == WeightStorage::stored   ? 8
                        : options_.weights == WeightStorage::single ? 4
                                                                    : 0};
    const double flops = flops_of_pair<D>(method), bytes = bytes_of_particle<D>(method, neighbors);
    const double ours = median(t.ours) / count, plain = median(t.plain) / count;
    const double bound = std::max(flops * neighbors / machine.flops_per_second, bytes / machine.bytes_per_second);
    const double memory = static_cast<double>(particles_.bytes() + solid_.bytes() + forces_.bytes()) / count;
    fmt::print(
        "| {}D {}^{} {} | {} | {:.1f} | {:.2f} | {:.2f} | {:.0f} | {:.1f} | {:.3f} | {:.2f} | {:.0f} % | {:.0f} | {:.1f} | "
        "{:.0e} |\n",
        D, n_, D, jitter_ > 0.0 ? "jittered" : "lattice", threads, neighbors, 1e-6 / ours, 1e9 * ours / neighbors, flops,
        bytes / neighbors, 1e-6 / plain, plain / ours, 100.0 * bound / ours, memory, setup_seconds_ / median(t.ours), difference);
    std::fflush(stdout);
  }

  const Options& options_;
  int n_;
  double jitter_;
  PointSet points_;
  Stopwatch watch_;
  Particles<D> particles_;
  std::vector<double> radius_;
  TotalLagrangian<D> solid_;
  double setup_seconds_;
  VectorField<D> forces_;
};

template <int D>
void run(const std::vector<int>& sizes, const Options& o, const std::vector<Machine>& machines) {
  for (int n : sizes)
    for (double jitter : {0.2, 0.0})
      for (std::size_t k = 0; k < o.threads.size(); ++k) {
        omp_set_num_threads(o.threads[k]);
        Block<D>(n, jitter, o).report(o.threads[k], machines[k]);
      }
}

std::vector<int> numbers(std::string_view text) {
  std::vector<int> all;
  for (std::size_t at = 0; at < text.size(); at = text.find(',', at) == text.npos ? text.size() : text.find(',', at) + 1)
    all.push_back(std::atoi(text.data() + at));
  return all;
}

constexpr std::string_view usage =
    "benchmark_block [--size N,...] [--size2 N,...] [--threads N,...] [--repeats N] [--form conservative|half]\n"
    "                [--weights stored|single|computed] [--lattice auto|off] [--block N]\n"
    "--size: edge of the 3D block in particles, --size2: of the 2D one; 0: none. A comma separates several.\n";

bool read(std::string_view option, std::string_view value, Options& o) {
  if (option == "--size") return o.sizes3 = numbers(value), true;
  if (option == "--size2") return o.sizes2 = numbers(value), true;
  if (option == "--threads") return o.threads = numbers(value), true;
  if (option == "--repeats") return o.repeats = std::max(1, numbers(value)[0]), true;
  if (option == "--form") return o.conservative = value == "conservative", value == "conservative" || value == "half";
  if (option == "--block") return largest_block = std::max(1, numbers(value)[0]), true;
  if (option == "--lattice") return o.lattice = value == "auto", value == "auto" || value == "off";
  for (WeightStorage storage : {WeightStorage::stored, WeightStorage::single, WeightStorage::computed})
    if (option == "--weights" && value == name_of(storage)) return o.weights = storage, true;
  return false;
}

void run_all(const Options& o) {
  fmt::print("St. Venant-Kirchhoff with hourglass control ({}), weights {}, medians of {}\n",
             o.conservative ? "conservative" : "half", name_of(o.weights), o.repeats);
  std::vector<Machine> machines;
  for (int threads : o.threads) {
    machines.push_back(measure_machine(threads));
    fmt::print("machine, {} thread(s): {:.0f} GFLOP/s of multiply-adds, {:.1f} GB/s from memory\n", threads,
               1e-9 * machines.back().flops_per_second, 1e-9 * machines.back().bytes_per_second);
  }
  fmt::print(
      "| block | threads | neighbors | million particle-steps/s | ns a pair | flops a pair | bytes a pair | plain | ratio | of "
      "the roofline | "
      "bytes a particle | set-up in steps | difference |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  if (o.sizes3[0] > 0) run<3>(o.sizes3, o, machines);
  if (o.sizes2[0] > 0) run<2>(o.sizes2, o, machines);
}

}  // namespace sinew::benchmark

int main(int count, char** words) {
  sinew::benchmark::Options options;
  for (int k = 1; k < count; k += 2)
    if (k + 1 == count || !sinew::benchmark::read(words[k], words[k + 1], options))
      return fmt::print(stderr, "unknown option or value \"{}\"\n{}", words[k], sinew::benchmark::usage), 2;
  sinew::benchmark::run_all(options);
}
