#pragma once
/// Newton's method with line search for a NonlinearSystem, by PETSc's SNES and KSP. Its options may be changed from outside by PETSc's own names.

#include <functional>
#include <memory>
#include <sinew/implicit/nonlinear_system.hpp>
#include <string>
#include <vector>

namespace sinew {

enum class LinearSolver { direct, iterative };  ///< MUMPS; or conjugate gradients (GMRES if not symmetric) with multigrid

struct NewtonOptions {
  double tolerance = 1e-8;  ///< |R| over NonlinearSystem::scale()
  int most_iterations = 25;
  LinearSolver linear = LinearSolver::direct;
  bool matrix_free = false;  ///< iterative: products by the system, and a matrix with few entries a row for the preconditioner
  bool symmetric = true;
  std::string petsc;             ///< more options, "-ksp_monitor -ksp_rtol 1e-8"
  std::function<bool()> stop{};  ///< asked after each iteration, by all ranks: whether to give up
};

struct NewtonResult {
  bool converged = false, stopped = false;
  std::vector<double> residuals;  ///< |R| over its scale, of the start and after each iteration
  long linear_iterations = 0;
  std::string reason;  ///< why not
};

class Newton {
 public:
  Newton(const Comm& comm, NonlinearSystem& system, const NewtonOptions& options);
  ~Newton();

  /// From u to R(u) = 0. The last residual that the system has seen is the one of u.
  NewtonResult solve(std::span<double> u);
  /// K x = b at the u of the last residual. Returns an error, or nothing.
  std::string solve_linear(std::span<const double> b, std::span<double> x);

  void stop_when(std::function<bool()> stop);
  /// Entries of the matrix, of all ranks.
  double matrix_entries() const;
  /// Version of PETSc.
  static std::string version();
  /// To be called at the end of the program, before MPI ends.
  static void finalize();

 private:
  struct Petsc;
  std::unique_ptr<Petsc> petsc_;
};

}  // namespace sinew
