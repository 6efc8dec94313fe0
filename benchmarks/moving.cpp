/// Whole steps on the current configuration, search of neighbors included, against steps of the total-Lagrangian formulation on the same disturbed particles, in turns.

#include <fmt/format.h>

#include <omp.h>

#include <algorithm>
#include <cstdlib>
#include <memory>

#include "block_setup.hpp"
#include <sinew/core/timer.hpp>
#include <sinew/formulations/updated_lagrangian.hpp>
#include <sinew/time/velocity_verlet.hpp>

namespace sinew::benchmark {

using Treatments = std::vector<AnyStabilization>;

struct Method {
  const char* name;
  bool current = true;
  bool corrected = false;
  Treatments treatments{};
  bool soil = false;
  double steps_a_list = 0.0;  ///< 0: particles move as they do, otherwise a uniform motion makes a new list every so many steps
};

inline AnyMaterial soil() {
  RateForm<DruckerPrager> m;
  m.density = 1.0;
  m.elastic = material().elastic;
  m.law.friction_angle = 25.0;
  m.law.cohesion = 1e-3;
  return m;
}

template <int D>
class Body {
 public:
  Body(const PointSet& points, const Method& method)
      : particles_(make_particles<D>({{"block", &points, 1.0, 1.0}}, 1.0)),
        forces_(particles_.slots) {
    const std::vector<double> radius(particles_.slots, support);
    const AnyMaterial of_body = method.soil ? soil() : AnyMaterial(material());
    if (method.current) {
      UpdatedLagrangianOptions o{.kernel = CubicSpline{}, .materials = {of_body}};
      o.radius = support, o.spacing = 1.0, o.corrected = method.corrected;
      for (const AnyStabilization& s : method.treatments) {
        if (const auto* viscosity = std::get_if<ArtificialViscosity>(&s)) o.viscosity = *viscosity;
        if (const auto* stress = std::get_if<ArtificialStress>(&s)) o.stress = *stress;
        if (const auto* pressure = std::get_if<ArtificialPressure>(&s)) o.pressure = *pressure;
        if (const auto* shear = std::get_if<NonNestedShear>(&s)) o.shear = *shear;
      }
      BlockPairs<D> pairs = make_block_pairs(particles_, build_pair_list(particles_, radius), radius, false);
      auto moving = std::make_unique<UpdatedLagrangian<D>>(particles_, std::move(pairs), o, Comm(), Halo());
      moving_ = moving.get();
      solid_ = std::move(moving);
      if (method.steps_a_list > 0.0) drift_ = 0.5 * 0.04 * support / method.steps_a_list * 1.0001;
    } else {
      TotalLagrangianOptions o{CubicSpline{}, GradientCorrection{}, HourglassStiffness{}, {of_body}, false, 1.0};
      for (const AnyStabilization& s : method.treatments)
        if (const auto* viscosity = std::get_if<ArtificialViscosity>(&s)) o.viscosity = *viscosity;
      solid_ = std::make_unique<TotalLagrangian<D>>(particles_, radius, o);
    }
    set_motion(particles_);
    solid_->begin(particles_);
    step(0.0);
  }

  double seconds_of_a_step() {
    constexpr int steps = 10;
    const Stopwatch watch;
    for (int k = 0; k < steps; ++k) step(0.01);
    steps_ += steps;
    return watch.seconds() / steps;
  }
  long count() const { return particles_.count; }
  double neighbors() const { return double(solid_->pairs().pairs) / particles_.count; }
  double steps_a_list() const { return moving_ ? double(steps_) / std::max(1L, moving_->lists_made() - 1) : 0.0; }
  double bytes() const { return double(solid_->bytes()) / particles_.count; }

 private:
  void step(double dt) {
    if (dt > 0.0) kick_and_drift(particles_, dt, 0.0);
    for (int slot = 0; drift_ > 0.0 && dt > 0.0 && slot < particles_.slots; ++slot) particles_.displacement.at(0, slot) += drift_;
    solid_->internal_forces(particles_, forces_, {dt, HistoryUse::advance},
                            AccelerateAndKick<D>{particles_, forces_, {}, dt, 0.0});
  }

  Particles<D> particles_;
  std::unique_ptr<Formulation<D>> solid_;
  UpdatedLagrangian<D>* moving_ = nullptr;
  VectorField<D> forces_;
  double drift_ = 0.0;
  long steps_ = 0;
};

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

/// The first method is what the others are compared with.
template <int D>
void compare(int n, const std::vector<Method>& methods, int repeats) {
  const PointSet points = block<D>(n, 0.2);
  std::vector<std::unique_ptr<Body<D>>> bodies;
  for (const Method& method : methods) bodies.push_back(std::make_unique<Body<D>>(points, method));
  std::vector<std::vector<double>> seconds(methods.size()), ratios(methods.size());
  for (int r = 0; r < repeats; ++r)
    for (std::size_t m = 0; m < methods.size(); ++m) {
      seconds[m].push_back(bodies[m]->seconds_of_a_step());
      ratios[m].push_back(seconds[m].back() / seconds[0].back());
    }
  fmt::print("\n{}^{}, {:.1f} neighbors, one thread, cubic spline, jittered\n\n", n, D, bodies[0]->neighbors());
  fmt::print(
      "| method | million particle-steps/s | time of a step over the first | steps a list | bytes a particle |\n"
      "|---|---|---|---|---|\n");
  for (std::size_t m = 0; m < methods.size(); ++m)
    fmt::print("| {} | {:.2f} | {:.2f} | {:.0f} | {:.0f} |\n", methods[m].name,
               1e-6 * double(bodies[m]->count()) / median(seconds[m]), median(ratios[m]), bodies[m]->steps_a_list(),
               bodies[m]->bytes());
}

}  // namespace sinew::benchmark

int main(int argc, char** argv) {
  using namespace sinew;
  const int repeats = argc > 1 ? std::atoi(argv[1]) : 7, n3 = argc > 2 ? std::atoi(argv[2]) : 40,
            n2 = argc > 3 ? std::atoi(argv[3]) : 256;
  omp_set_num_threads(1);
  const ArtificialViscosity viscosity;
  const benchmark::Treatments none;
  std::vector<benchmark::Method> methods{
      {"total_lagrangian, gradient, hourglass stiffness", false},
      {"the same with viscosity", false, false, {viscosity}},
      {"updated_lagrangian, conventional", true},
      {"conventional, a list every 10 steps", true, false, none, false, 10.0},
      {"conventional, a list every step", true, false, none, false, 1.0},
      {"corrected", true, true},
      {"viscosity", true, false, {viscosity}},
      {"viscosity, artificial pressure", true, false, {viscosity, ArtificialPressure{}}},
      {"viscosity, artificial stress", true, false, {viscosity, ArtificialStress{}}},
      {"viscosity, non-nested shear (printed)",
       true,
       false,
       {viscosity, NonNestedShear{NAN, {"printed", {"objective", "printed"}}}}},
      {"viscosity, corrected, non-nested shear (objective)", true, true, {viscosity, NonNestedShear{}}},
      {"viscosity, soil", true, false, {viscosity}, true},
  };
  if (argc > 4) methods = {methods[std::atoi(argv[4])]};  // one alone, for a profiler
  benchmark::compare<3>(n3, methods, repeats);
  benchmark::compare<2>(n2, methods, repeats);
}
