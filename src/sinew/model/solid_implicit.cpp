/// Of SolidSimulation: steps that solve equations.

#include <sinew/model/solid_simulation.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sinew {

namespace {

/// How steps follow the number of iterations: at most so many are few, at least so many are many; a step becomes shorter by half at most.
constexpr std::size_t few_iterations = 5, many_iterations = 12;
constexpr double growth = 1.5;
/// Shorter steps than this part of the first one are not tried.
constexpr double shortest = 1e-4;
/// A step that leaves no more than this part of itself takes the rest as well.
constexpr double sliver = 1e-6;

/// Particles up to which a matrix is factored: its factors then fit in a few GB.
constexpr long most_direct(int dimension) { return dimension == 2 ? 60000 : 1000; }

/// The derivative of the forces is, where they have a potential or flow is associated, no pressure follows the surface, and the hourglass stiffness is of gradients that minimize its energy.
bool is_symmetric(const Case& c) {
  const auto in_rates = [](const BodyCase& body) {
    return std::visit(
        []<class M>(const M&) {
          return requires { M::in_rates; };
        },
        body.material);
  };
  const auto follows = [](const BoundaryCase& b) { return b.follower; };
  if (std::any_of(c.bodies.begin(), c.bodies.end(), in_rates)) return false;
  if (std::any_of(c.boundary.begin(), c.boundary.end(), follows)) return false;
  return std::holds_alternative<GradientCorrection>(c.formulation.correction) || c.formulation.stabilizations.empty();
}

NewtonOptions newton_options(const Case& c, long particles) {
  const std::string& name = c.solver.linear_solver;
  const bool direct = name == "direct" || (name == "auto" && particles <= most_direct(c.general.dimension));
  NewtonOptions options;
  options.tolerance = c.solver.tolerance;
  options.most_iterations = static_cast<int>(c.solver.most_iterations);
  options.linear = direct ? LinearSolver::direct : LinearSolver::iterative;
  options.matrix_free = !direct && name != "assembled";
  options.petsc = c.solver.petsc;
  options.symmetric = is_symmetric(c);
  return options;
}

/// A body that can move as a whole has no one balance.
template <int D>
void check_that_bodies_are_held(const Particles<D>& particles, const PrescribedMotion<D>& motion, const Comm& comm) {
  constexpr long rigid_modes = D * (D + 1) / 2;
  std::vector<long> given(particles.bodies.size(), 0);
  motion.for_each([&](int slot, int) { ++given[particles.body_of(slot)]; });
  comm.sum(given);
  for (std::size_t b = 0; b < given.size(); ++b)
    if (given[b] < rigid_modes)
      throw CaseError(
          fmt::format("body \"{}\" is not held: {} of the components of its displacements are given, and it takes at least {} to "
                      "keep it from "
                      "moving and turning. Give a [[boundary]] with displacement.",
                      particles.bodies[b].name, given[b], rigid_modes));
}

}  // namespace

template <int D>
void SolidSimulation<D>::make_implicit_solver() {
  const SolverCase& solver = case_.solver;
  if (solver.is_static()) check_that_bodies_are_held(particles_, motion_, comm_);
  double modulus = 0.0;
  for (const BodyCase& body : case_.bodies) modulus = std::max(modulus, youngs_modulus_of(body.material));
  ImplicitOptions options{newton_options(case_, comm_.sum(long{particles_.count})), {}, solver.damping, 1.0};
  options.stiffness = modulus * solid_->thickness() * std::pow(particles_.bodies.front().spacing, D - 2);
  if (!solver.is_static())
    options.motion = Newmark{solver.integrator == HilberHughesTaylor::name ? solver.numerical_damping : 0.0};
  implicit_.emplace(comm_, particles_, *solid_, loads_, motion_, options);
  next_step_ = *solver.time_step;
}

/// Returns the length of the step that was taken; the first try is the one that is due.
template <int D>
double SolidSimulation<D>::solve_step(double most) {
  for (double dt = most <= (1.0 + sliver) * next_step_ ? most : next_step_;; dt *= 0.5) {
    const NewtonResult result = implicit_->solve(time_, dt);
    counts_.newton_iterations += static_cast<long>(result.residuals.size());
    counts_.linear_iterations += result.linear_iterations;
    if (result.converged) {
      adapt_step(dt, result);
      return dt;
    }
    if (result.stopped) throw StepStopped();
    ++counts_.cut_backs;
    next_step_ = 0.5 * dt;
    if (next_step_ < shortest * *case_.solver.time_step) fail_to_solve(dt, result);
  }
}

/// By the number of iterations, and by the error of the step where that is to be bounded: it is of third order in its length.
template <int D>
void SolidSimulation<D>::adapt_step(double dt, const NewtonResult& result) {
  const double longest = case_.solver.longest_step.value_or(*case_.solver.time_step);
  if (result.residuals.size() <= few_iterations)
    next_step_ = std::min(std::max(next_step_, growth * dt), longest);
  else if (result.residuals.size() >= many_iterations)
    next_step_ = dt / growth;
  if (!case_.solver.step_error) return;
  for (const int slot : order_.slots())
    largest_displacement_ = std::max(largest_displacement_, norm(particles_.displacement[slot]));
  largest_displacement_ = comm_.maximum(largest_displacement_);
  const double allowed = *case_.solver.step_error * largest_displacement_, error = implicit_->step_error();
  if (error > 0.0) next_step_ = std::min(next_step_, dt * std::clamp(0.9 * std::cbrt(allowed / error), 0.5, growth));
}

template <int D>
void SolidSimulation<D>::fail_to_solve(double dt, const NewtonResult& result) {
  const std::string residual =
      result.residuals.empty() ? "" : fmt::format(", residual {:.2e} of the forces from outside", result.residuals.back());
  throw NoBalance(fmt::format(
      "no balance found between time {:.6g} and {:.6g} {}: {}{}. The state at {:.6g} is kept. Likely causes: the body has no "
      "more "
      "than this to bear (a limit load, buckling), or it is not held; steps that are too long (try a shorter [solver] "
      "time_step); or {}.",
      time_, time_ + dt, case_.general.units.name_of("s"), result.reason, residual, time_, solid_->advice()));
}

template <int D>
void SolidSimulation<D>::save_implicit(SavedState& state) const {
  state.numbers.insert({{"implicit.next_step", next_step_},
                        {"implicit.largest_displacement", largest_displacement_},
                        {"implicit.force_scale", implicit_->force_scale()},
                        {"implicit.newton_iterations", static_cast<double>(counts_.newton_iterations)},
                        {"implicit.linear_iterations", static_cast<double>(counts_.linear_iterations)},
                        {"implicit.cut_backs", static_cast<double>(counts_.cut_backs)}});
}

/// A stage that was explicit knows nothing of it.
template <int D>
void SolidSimulation<D>::restore_implicit(const SavedState& state) {
  if (!state.numbers.contains("implicit.next_step")) return;
  const auto number = [&](const char* name) { return state.numbers.at(std::string("implicit.") + name); };
  next_step_ = number("next_step");
  largest_displacement_ = number("largest_displacement");
  implicit_->restore_force_scale(number("force_scale"));
  counts_ = {std::lround(number("newton_iterations")), std::lround(number("linear_iterations")),
             std::lround(number("cut_backs"))};
}

template <int D>
std::map<std::string, double> SolidSimulation<D>::equation_counts() {
  if (!implicit_) return {};
  return {{"newton_iterations", static_cast<double>(counts_.newton_iterations)},
          {"linear_iterations", static_cast<double>(counts_.linear_iterations)},
          {"cut_backs", static_cast<double>(counts_.cut_backs)},
          {"matrix_entries", steps_ > 0 ? implicit_->matrix_entries() : 0.0}};
}

#define SINEW_INSTANTIATE(D)                                                    \
  template void SolidSimulation<D>::make_implicit_solver();                     \
  template double SolidSimulation<D>::solve_step(double);                       \
  template void SolidSimulation<D>::adapt_step(double, const NewtonResult&);    \
  template std::map<std::string, double> SolidSimulation<D>::equation_counts(); \
  template void SolidSimulation<D>::save_implicit(SavedState&) const;           \
  template void SolidSimulation<D>::restore_implicit(const SavedState&);        \
  template void SolidSimulation<D>::fail_to_solve(double, const NewtonResult&);
SINEW_INSTANTIATE(2)
SINEW_INSTANTIATE(3)

}  // namespace sinew
