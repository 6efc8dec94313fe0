#include <sinew/implicit/implicit_solver.hpp>

#include <algorithm>
#include <cmath>

namespace sinew {

template <int D>
ImplicitSolver<D>::ImplicitSolver(const Comm& comm, Particles<D>& particles, Formulation<D>& solid, Loads<D>& loads,
                                  PrescribedMotion<D>& motion, const ImplicitOptions& options)
    : comm_(comm),
      particles_(particles),
      motion_(motion),
      system_(comm, particles, solid, loads, motion, options.stiffness),
      options_(options) {}

/// Made when it is first needed, since it takes time and memory that a mere check need not spend.
template <int D>
Newton& ImplicitSolver<D>::newton() {
  if (!newton_) newton_.emplace(comm_, system_, options_.newton);
  return *newton_;
}

template <int D>
void ImplicitSolver<D>::stop_when(std::function<bool()> stop) {
  options_.newton.stop = std::move(stop);
  if (newton_) newton_->stop_when(options_.newton.stop);
}

template <int D>
NewtonResult ImplicitSolver<D>::solve(double time, double dt) {
  const std::vector<double> before = system_.displacements(), velocities = system_.values_of(particles_.velocity);
  if (!is_static()) prepare_inertia(time, dt, before);
  comm_.together([&] { motion_.move(particles_, time, dt); });
  const std::vector<double> moved = system_.displacements();
  system_.set_step(time + dt, dt, is_static() ? nullptr : &inertia_);
  std::vector<double> u = before;
  NewtonResult result;
  result.reason = predict(moved, u);
  if (result.reason.empty()) result = newton().solve(u);
  system_.put(result.converged ? u : before);
  if (is_static())
    particles_.velocity.clear();
  else if (result.converged)
    finish_motion(dt, u);
  else
    system_.put(velocities, particles_.velocity);
  return result;
}

/// The first iteration, from the state before the step: everything moves in proportion to what is given, so that no row of particles is torn off from its neighbors. With the derivative K at `u`,
///
///     K du = -R(u) at free components,   du = given - u at the others
template <int D>
std::string ImplicitSolver<D>::predict(std::span<const double> given, std::vector<double>& u) {
  std::vector<double> r(u.size()), coupled(u.size()), jump(u.size(), 0.0), du(u.size());
  if (!system_.residual(u, r)) return "the state before the step has lost its meaning";
  for (const int unknown : system_.given()) jump[unknown] = given[unknown] - u[unknown];
  system_.product_of_given(jump, coupled);
  for (std::size_t k = 0; k < r.size(); ++k) r[k] = -r[k] - coupled[k];
  for (const int unknown : system_.given()) r[unknown] = system_.given_diagonal() * jump[unknown];
  std::string error = newton().solve_linear(r, du);
  for (std::size_t k = 0; k < u.size(); ++k) u[k] += du[k];
  for (const int unknown : system_.given()) u[unknown] = given[unknown];
  return error;
}

/// What the step takes over from its beginning.
template <int D>
void ImplicitSolver<D>::prepare_inertia(double time, double dt, std::span<const double> u) {
  const Newmark& method = *options_.motion;
  const double beta = method.beta(), gamma = method.gamma();
  const std::vector<double> v = system_.values_of(particles_.velocity), a = system_.values_of(particles_.acceleration);
  inertia_ = {1.0 / (beta * dt * dt), gamma / (beta * dt), 1.0 - method.damping, options_.damping, {}, {}, {}};
  inertia_.force.assign(u.size(), 0.0);
  if (method.damping > 0.0) {
    system_.set_step(time, 0.0, nullptr);
    system_.residual(u, inertia_.force);
    for (std::size_t k = 0; k < u.size(); ++k)
      inertia_.force[k] = -method.damping * (inertia_.force[k] + options_.damping * system_.mass_of(static_cast<int>(k)) * v[k]);
  }
  for (std::size_t k = 0; k < u.size(); ++k) {
    inertia_.displacement.push_back(u[k] + dt * v[k] + dt * dt * (0.5 - beta) * a[k]);
    inertia_.velocity.push_back(v[k] + dt * (1.0 - gamma) * a[k]);
  }
}

template <int D>
void ImplicitSolver<D>::finish_motion(double dt, std::span<const double> u) {
  const std::vector<double> old = system_.values_of(particles_.acceleration);
  std::vector<double> v = system_.values_of(particles_.velocity);
  acceleration_ = old;
  double change = 0.0;
  for (std::size_t k = 0; k < u.size(); ++k) {
    if (system_.is_given(static_cast<int>(k))) continue;
    const double moved = u[k] - inertia_.displacement[k];
    acceleration_[k] = inertia_.mass * moved;
    v[k] = inertia_.velocity[k] + inertia_.rate * moved;
    change = std::max(change, std::abs(acceleration_[k] - old[k]));
  }
  system_.put(v, particles_.velocity);
  step_error_ = dt * dt * options_.motion->error_factor() * comm_.maximum(change);
}

template <int D>
void ImplicitSolver<D>::put_accelerations() {
  std::vector<double> a = system_.values_of(particles_.acceleration);
  for (std::size_t k = 0; k < acceleration_.size(); ++k)
    if (!system_.is_given(static_cast<int>(k))) a[k] = acceleration_[k];
  system_.put(a, particles_.acceleration);
}

template class ImplicitSolver<2>;
template class ImplicitSolver<3>;

}  // namespace sinew
