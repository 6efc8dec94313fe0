/// Whole steps of a block of metal that flows, against steps of the same block of St. Venant-Kirchhoff material, in turns.

#include <fmt/format.h>

#include <omp.h>

#include <algorithm>
#include <cstdlib>

#include "block_setup.hpp"
#include <sinew/core/timer.hpp>
#include <sinew/time/velocity_verlet.hpp>

namespace sinew::benchmark {

template <class Hardening>
J2<Hardening> metal() {
  J2<Hardening> m;
  m.density = material().density;
  m.elastic = material().elastic;
  m.hardening.yield_stress = 0.003;
  m.hardening.hardening_modulus = 0.01;
  if constexpr (requires { m.hardening.saturation_stress; })
    m.hardening.saturation_stress = 0.006, m.hardening.saturation_rate = 10.0;
  if constexpr (requires { m.hardening.rate_coefficient; }) {
    m.hardening.hardening_exponent = 0.4;
    m.hardening.rate_coefficient = 0.02, m.hardening.reference_rate = 1e-4;
    m.hardening.melting_temperature = 1300.0, m.hardening.specific_heat = 1e-3;
  }
  return m;
}

template <int D>
class Solid {
 public:
  Solid(const PointSet& points, const AnyMaterial& material)
      : particles_(make_particles<D>({{"block", &points, 1.0, 1.0}}, 1.0)),
        solid_(particles_, std::vector<double>(particles_.slots, support),
               {Spiky{}, GradientCorrection{}, HourglassStiffness{}, {material}, false, 1.0}),
        forces_(particles_.slots) {
    set_motion(particles_);
    step(0.0);
  }

  double seconds_of_a_step() {
    constexpr int steps = 4;
    const Stopwatch watch;
    for (int k = 0; k < steps; ++k) step(0.05);
    return watch.seconds() / steps;
  }
  long count() const { return particles_.count; }
  double plastic_work() const { return solid_.stored_energy().plastic_work; }

 private:
  void step(double dt) {
    if (dt > 0.0) kick_and_drift(particles_, dt, 0.0);
    solid_.internal_forces(particles_, forces_, {dt, HistoryUse::advance},
                           AccelerateAndKick<D>{particles_, forces_, {}, dt, 0.0});
  }

  Particles<D> particles_;
  TotalLagrangian<D> solid_;
  VectorField<D> forces_;
};

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

template <int D, class Hardening>
void compare(int n, double jitter, int repeats) {
  const PointSet points = block<D>(n, jitter);
  Solid<D> elastic(points, material()), plastic(points, metal<Hardening>());
  const double before = plastic.plastic_work();
  std::vector<double> elastic_seconds, plastic_seconds, ratio;
  for (int r = 0; r < repeats; ++r) {
    elastic_seconds.push_back(elastic.seconds_of_a_step());
    plastic_seconds.push_back(plastic.seconds_of_a_step());
    ratio.push_back(elastic_seconds.back() / plastic_seconds.back());
  }
  const auto count = static_cast<double>(elastic.count());
  fmt::print("| {} {}^{} {} | {:.2f} | {:.2f} | {:.0f} % | {:+.0f} % |\n", Hardening::name, n, D,
             jitter > 0.0 ? "jittered" : "lattice", 1e-6 * count / median(elastic_seconds),
             1e-6 * count / median(plastic_seconds), 100.0 * median(ratio), 100.0 * (plastic.plastic_work() / before - 1.0));
}

template <class Hardening>
void compare_all(int repeats) {
  compare<3, Hardening>(64, 0.2, repeats);
  compare<3, Hardening>(64, 0.0, repeats);
  compare<2, Hardening>(512, 0.2, repeats);
  compare<2, Hardening>(512, 0.0, repeats);
}

}  // namespace sinew::benchmark

int main(int argc, char** argv) {
  using namespace sinew;
  const int repeats = argc > 1 ? std::atoi(argv[1]) : 7;
  omp_set_num_threads(1);
  fmt::print(
      "| block | elastic, million particle-steps/s | plastic | plastic / elastic | growth of the plastic work meanwhile |\n");
  fmt::print("|---|---|---|---|---|\n");
  benchmark::compare_all<LinearHardening>(repeats);
  benchmark::compare_all<VoceHardening>(repeats);
  benchmark::compare_all<JohnsonCookHardening>(repeats);
}
