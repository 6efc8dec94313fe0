#pragma once
/// From one state to the next by the solution of equations: balance of forces under the loads of a later time, or motion in a step of any length.

#include <optional>
#include <sinew/implicit/equilibrium.hpp>
#include <sinew/implicit/newmark.hpp>
#include <sinew/implicit/newton.hpp>

namespace sinew {

struct ImplicitOptions {
  NewtonOptions newton;
  std::optional<Newmark> motion;  ///< nothing: statics
  double damping = 0.0;           ///< every particle gets the force -damping m v [1/time]
  double stiffness = 1.0;         ///< of a typical particle [force/length]
};

/// What a run of steps has taken.
struct ImplicitCounts {
  long newton_iterations = 0, linear_iterations = 0, cut_backs = 0;
};

template <int D>
class ImplicitSolver {
 public:
  /// All of it stays with the caller; `motion` has to remember where the particles were before a step.
  ImplicitSolver(const Comm& comm, Particles<D>& particles, Formulation<D>& solid, Loads<D>& loads, PrescribedMotion<D>& motion,
                 const ImplicitOptions& options);

  /// From the state at `time` to that at time + dt: displacements, and in motion velocities. If there is none to be found, those of before. Collective.
  NewtonResult solve(double time, double dt);
  /// In motion: puts the accelerations of the last step where they are free, once others have overwritten them.
  void put_accelerations();
  /// In motion: error of the displacements in the last step [length].
  double step_error() const { return step_error_; }

  bool is_static() const { return !options_.motion; }
  /// See NewtonOptions::stop.
  void stop_when(std::function<bool()> stop);
  /// Largest forces so far, with which missing ones are compared in motion; for restarts.
  double force_scale() const { return system_.most_scale(); }
  void restore_force_scale(double value) { system_.restore_most_scale(value); }
  /// Entries of the matrix.
  double matrix_entries() { return newton().matrix_entries(); }

 private:
  Newton& newton();
  std::string predict(std::span<const double> given, std::vector<double>& u);
  void prepare_inertia(double time, double dt, std::span<const double> u);
  void finish_motion(double dt, std::span<const double> u);

  Comm comm_;
  Particles<D>& particles_;
  PrescribedMotion<D>& motion_;
  Equilibrium<D> system_;
  ImplicitOptions options_;
  std::optional<Newton> newton_;
  Inertia inertia_;
  std::vector<double> acceleration_;  ///< of the last step
  double step_error_ = 0.0;
};

extern template class ImplicitSolver<2>;
extern template class ImplicitSolver<3>;

}  // namespace sinew
