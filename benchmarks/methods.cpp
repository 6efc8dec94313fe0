/// Whole steps with the extended methods against steps with the direct deformation gradient, on the same disturbed particles, in turns.

#include <fmt/format.h>

#include <omp.h>

#include <algorithm>
#include <cstdlib>
#include <memory>

#include "block_setup.hpp"
#include <sinew/core/timer.hpp>
#include <sinew/time/velocity_verlet.hpp>

namespace sinew::benchmark {

struct Method {
  const char* name;
  AnyCorrection correction;
  DeformationGradient gradient = DeformationGradient::direct;
  MomentumForm momentum = MomentumForm::adjoint;
  std::optional<JstDissipation> jst{};
  bool hourglass = false;
};

template <int D>
class Solid {
 public:
  Solid(const PointSet& points, const Method& method)
      : particles_(make_particles<D>({{"block", &points, 1.0, 1.0}}, 1.0)),
        solid_(particles_, std::vector<double>(particles_.slots, support), options(method)),
        forces_(particles_.slots) {
    set_motion(particles_);
    solid_.begin(particles_);
    step(0.0);
  }

  double seconds_of_a_step() {
    constexpr int steps = 3;
    const Stopwatch watch;
    for (int k = 0; k < steps; ++k) step(0.01);
    return watch.seconds() / steps;
  }
  long count() const { return particles_.count; }
  double neighbors() const { return double(solid_.pairs().pairs) / particles_.count; }
  double bytes() const { return double(solid_.bytes()) / particles_.count; }

 private:
  static TotalLagrangianOptions options(const Method& method) {
    TotalLagrangianOptions o{CubicSpline{}, method.correction, std::nullopt, {material()}, false, 1.0};
    if (method.hourglass) o.hourglass = HourglassStiffness{};
    o.deformation_gradient = method.gradient;
    o.momentum = method.momentum;
    o.jst = method.jst;
    return o;
  }
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

/// The first method is what the others are compared with.
template <int D>
void compare(int n, const std::vector<Method>& methods, int repeats) {
  const PointSet points = block<D>(n, 0.2);
  std::vector<std::unique_ptr<Solid<D>>> solids;
  for (const Method& method : methods) solids.push_back(std::make_unique<Solid<D>>(points, method));
  std::vector<std::vector<double>> seconds(methods.size()), ratios(methods.size());
  for (int r = 0; r < repeats; ++r)
    for (std::size_t m = 0; m < methods.size(); ++m) {
      seconds[m].push_back(solids[m]->seconds_of_a_step());
      ratios[m].push_back(seconds[m].back() / seconds[0].back());
    }
  fmt::print("\n{}^{}, {:.1f} neighbors, one thread, cubic spline, jittered\n\n", n, D, solids[0]->neighbors());
  fmt::print("| method | million particle-steps/s | time of a step over the first | bytes a particle |\n|---|---|---|---|\n");
  for (std::size_t m = 0; m < methods.size(); ++m)
    fmt::print("| {} | {:.2f} | {:.2f} | {:.0f} |\n", methods[m].name, 1e-6 * double(solids[m]->count()) / median(seconds[m]),
               median(ratios[m]), solids[m]->bytes());
}

}  // namespace sinew::benchmark

int main(int argc, char** argv) {
  using namespace sinew;
  using enum DeformationGradient;
  using enum MomentumForm;
  const int repeats = argc > 1 ? std::atoi(argv[1]) : 7, n3 = argc > 2 ? std::atoi(argv[2]) : 40,
            n2 = argc > 3 ? std::atoi(argv[3]) : 256;
  omp_set_num_threads(1);
  const LinearCorrection linear;
  const GradientCorrection gradient;
  const JstDissipation biharmonic, harmonic{0.01, 0.0};
  std::vector<benchmark::Method> methods{{"direct, linear", linear},
                                         {"direct, gradient", gradient},
                                         {"direct, gradient, hourglass stiffness", gradient, direct, adjoint, std::nullopt, true},
                                         {"direct, linear, symmetric", linear, direct, symmetric},
                                         {"rate, linear, symmetric", linear, rate, symmetric},
                                         {"bond, linear, adjoint", linear, bond, adjoint},
                                         {"bond, linear, symmetric", linear, bond, symmetric},
                                         {"bond_variational, linear", linear, bond_variational},
                                         {"direct, linear, jst eta4", linear, direct, adjoint, biharmonic},
                                         {"direct, linear, jst eta2", linear, direct, adjoint, harmonic},
                                         {"bond, linear, symmetric, jst eta4", linear, bond, symmetric, biharmonic},
                                         {"bond, linear, symmetric, jst eta2", linear, bond, symmetric, harmonic}};
  if (argc > 4) methods = {methods[std::atoi(argv[4])]};  // one alone, for a profiler
  benchmark::compare<3>(n3, methods, repeats);
  benchmark::compare<2>(n2, methods, repeats);
}
