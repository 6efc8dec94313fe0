#include <sinew/implicit/newton.hpp>
#include <sinew/implicit/petsc_session.hpp>
#include <sinew/implicit/sparsity.hpp>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>

namespace sinew {

namespace {

using petsc::check;

std::span<const double> values_of(Vec v, const PetscScalar*& first, int count) {
  check(VecGetArrayRead(v, &first));
  return {first, static_cast<std::size_t>(count)};
}
std::span<double> values_of(Vec v, PetscScalar*& first, int count) {
  check(VecGetArrayWrite(v, &first));
  return {first, static_cast<std::size_t>(count)};
}

/// In words.
std::string text_of(SNESConvergedReason reason) {
  switch (reason) {
    case SNES_DIVERGED_MAX_IT: return "too many iterations";
    case SNES_DIVERGED_LINE_SEARCH: return "no shorter step makes the residual smaller";
    case SNES_DIVERGED_FNORM_NAN:
    case SNES_DIVERGED_FUNCTION_DOMAIN: return "material turned inside out";
    case SNES_DIVERGED_LINEAR_SOLVE: return "the linear solver did not converge";
    default: return SNESConvergedReasons[reason];
  }
}

}  // namespace

/// Between the system and PETSc's objects.
struct Newton::Petsc {
  Comm comm;
  NonlinearSystem& system;
  NewtonOptions options;
  int unknowns;
  petsc::OwnedVec u, r;
  petsc::OwnedMat matrix, shell;
  petsc::OwnedSnes snes;
  petsc::OwnedNullSpace rigid;
  Sparsity sparsity;
  std::exception_ptr error;  ///< thrown in a call from PETSc, which is C
  std::vector<double> residuals;
  bool stopped = false;
  double entries = 0.0;

  Petsc(const Comm& c, NonlinearSystem& s, const NewtonOptions& o)
      : comm(c),
        system(s),
        options(o),
        unknowns(s.nodes() * s.dimension()) {
    petsc::start();
    const MPI_Comm mpi = comm.alone() ? PETSC_COMM_SELF : PETSC_COMM_WORLD;
    check(VecCreateMPI(mpi, unknowns, PETSC_DETERMINE, u.address()));
    check(VecSetBlockSize(u, system.dimension()));
    check(VecDuplicate(u, r.address()));
    make_matrices(mpi);
    make_solver(mpi);
  }

  Mat jacobian() const { return options.matrix_free ? static_cast<Mat>(shell) : static_cast<Mat>(matrix); }

  void make_matrices(MPI_Comm mpi) {
    sparsity = find_sparsity(comm, system, !options.matrix_free);
    const int D = system.dimension();
    std::vector<PetscInt> here(unknowns), elsewhere(unknowns);
    for (int node = 0; node < system.nodes(); ++node) {
      int inside = 0;
      const std::vector<int>& columns = sparsity.columns[node];
      for (const int column : columns) inside += column >= sparsity.first && column < sparsity.first + system.nodes();
      for (int c = 0; c < D; ++c) {
        here[D * node + c] = D * inside;
        elsewhere[D * node + c] = D * (static_cast<int>(columns.size()) - inside);
      }
      entries += static_cast<double>(columns.size()) * D * D;
    }
    std::vector<std::vector<int>>().swap(sparsity.columns);
    check(MatCreate(mpi, matrix.address()));
    check(MatSetSizes(matrix, unknowns, unknowns, PETSC_DETERMINE, PETSC_DETERMINE));
    check(MatSetType(matrix, MATAIJ));
    check(MatSetBlockSize(matrix, D));
    check(MatSeqAIJSetPreallocation(matrix, 0, here.data()));
    check(MatMPIAIJSetPreallocation(matrix, 0, here.data(), 0, elsewhere.data()));
    check(MatSetOption(matrix, MAT_NEW_NONZERO_ALLOCATION_ERR, PETSC_TRUE));
    if (options.symmetric) check(MatSetOption(matrix, MAT_SYMMETRIC, PETSC_TRUE));
    if (!options.matrix_free) return;
    check(MatCreateShell(mpi, unknowns, unknowns, PETSC_DETERMINE, PETSC_DETERMINE, this, shell.address()));
    check(MatShellSetOperation(shell, MATOP_MULT, reinterpret_cast<void (*)()>(multiply)));
  }

  void make_solver(MPI_Comm mpi) {
    check(SNESCreate(mpi, snes.address()));
    check(SNESSetType(snes, SNESNEWTONLS));
    check(SNESSetFunction(snes, r, evaluate, this));
    check(SNESSetJacobian(snes, jacobian(), matrix, differentiate, this));
    const auto test = [](SNES, PetscInt, PetscReal, PetscReal, PetscReal norm, SNESConvergedReason* reason,
                         void* self) -> PetscErrorCode {
      *reason = static_cast<Petsc*>(self)->judge(norm);
      return 0;
    };
    check(SNESSetConvergenceTest(snes, test, this, nullptr));
    check(SNESSetTolerances(snes, PETSC_DEFAULT, PETSC_DEFAULT, PETSC_DEFAULT, options.most_iterations, 100000));
    KSP ksp = nullptr;
    PC pc = nullptr;
    check(SNESGetKSP(snes, &ksp));
    check(KSPGetPC(ksp, &pc));
    if (options.linear == LinearSolver::direct)
      set_direct(ksp, pc);
    else
      set_iterative(mpi, ksp, pc);
    check(PetscOptionsInsertString(nullptr, options.petsc.c_str()));
    check(SNESSetFromOptions(snes));
  }

  void set_direct(KSP ksp, PC pc) const {
    check(KSPSetType(ksp, KSPPREONLY));
    check(PCSetType(pc, options.symmetric ? PCCHOLESKY : PCLU));
    check(PCFactorSetMatSolverType(pc, MATSOLVERMUMPS));
  }

  void set_iterative(MPI_Comm mpi, KSP ksp, PC pc) {
    check(KSPSetType(ksp, options.symmetric ? KSPCG : KSPGMRES));
    check(KSPSetNormType(ksp, KSP_NORM_UNPRECONDITIONED));
    if (!options.symmetric) check(KSPSetPCSide(ksp, PC_RIGHT));
    check(KSPSetTolerances(ksp, 1e-6, PETSC_DEFAULT, PETSC_DEFAULT, 5000));
    check(PCSetType(pc, PCGAMG));
    petsc::OwnedVec places;
    check(VecCreateMPI(mpi, unknowns, PETSC_DETERMINE, places.address()));
    check(VecSetBlockSize(places, system.dimension()));
    PetscScalar* first = nullptr;
    const std::vector<double> coordinates = system.coordinates();
    std::copy(coordinates.begin(), coordinates.end(), values_of(places, first, unknowns).begin());
    check(VecRestoreArrayWrite(places, &first));
    check(MatNullSpaceCreateRigidBody(places, rigid.address()));
    check(MatSetNearNullSpace(matrix, rigid));
  }

  /// What is thrown goes on when PETSc has come back.
  template <class Action>
  PetscErrorCode guard(Action&& action) {
    try {
      action();
      return 0;
    } catch (...) {
      error = std::current_exception();
      return PETSC_ERR_USER;
    }
  }
  void rethrow(PetscErrorCode code) {
    if (error) std::rethrow_exception(std::exchange(error, nullptr));
    check(code);
  }

  bool find_residual(Vec at, Vec to) {
    const PetscScalar* from = nullptr;
    PetscScalar* out = nullptr;
    const std::span<double> values = values_of(to, out, unknowns);
    const bool state = system.residual(values_of(at, from, unknowns), values);
    if (!state) std::fill(values.begin(), values.end(), std::numeric_limits<double>::infinity());
    check(VecRestoreArrayRead(at, &from));
    check(VecRestoreArrayWrite(to, &out));
    return state;
  }

  static PetscErrorCode evaluate(SNES, Vec at, Vec to, void* self) {
    auto& p = *static_cast<Petsc*>(self);
    return p.guard([&] { p.find_residual(at, to); });
  }

  static PetscErrorCode multiply(Mat shell, Vec v, Vec to) {
    Petsc* p = nullptr;
    if (const PetscErrorCode code = MatShellGetContext(shell, &p); code != 0) return code;
    return p->guard([&] {
      const PetscScalar* from = nullptr;
      PetscScalar* out = nullptr;
      p->system.product(values_of(v, from, p->unknowns), values_of(to, out, p->unknowns));
      check(VecRestoreArrayRead(v, &from));
      check(VecRestoreArrayWrite(to, &out));
    });
  }

  static PetscErrorCode differentiate(SNES, Vec at, Mat, Mat, void* self) {
    auto& p = *static_cast<Petsc*>(self);
    return p.guard([&] {
      petsc::OwnedVec scratch;
      check(VecDuplicate(at, scratch.address()));
      p.find_residual(at, scratch);
      p.assemble();
    });
  }

  void assemble() {
    check(MatZeroEntries(matrix));
    const int D = system.dimension();
    system.for_each_matrix(!options.matrix_free, [&](std::span<const int> nodes, std::span<const double> values) {
      const auto count = static_cast<PetscInt>(nodes.size());
      check(MatSetValuesBlocked(matrix, count, nodes.data(), count, nodes.data(), values.data(), ADD_VALUES));
    });
    for (const int unknown : system.given()) {
      const PetscInt row = D * sparsity.first + unknown;
      check(MatSetValue(matrix, row, row, system.given_diagonal(), ADD_VALUES));
    }
    check(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY));
    check(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY));
    if (!options.matrix_free) return;
    check(MatAssemblyBegin(shell, MAT_FINAL_ASSEMBLY));
    check(MatAssemblyEnd(shell, MAT_FINAL_ASSEMBLY));
  }

  /// Converged once |R| is small enough, or as small as rounding lets it become: where strains are small, F = I + gradient leaves few digits of them, and then an iteration that should
  /// gain digits gains none.
  SNESConvergedReason judge(double norm) {
    const double scale = system.scale(), now = scale > 0.0 ? norm / scale : norm;
    const bool still = !residuals.empty() && now > 0.5 * residuals.back();
    residuals.push_back(now);
    if (!std::isfinite(norm)) return SNES_DIVERGED_FNORM_NAN;
    if (norm <= options.tolerance * scale || norm == 0.0) return SNES_CONVERGED_FNORM_ABS;
    stopped = options.stop && options.stop();
    if (stopped) return SNES_DIVERGED_FUNCTION_COUNT;
    return still && norm <= 1e3 * options.tolerance * scale ? SNES_CONVERGED_SNORM_RELATIVE : SNES_CONVERGED_ITERATING;
  }

  void take(std::span<const double> from, Vec to) const {
    PetscScalar* first = nullptr;
    std::copy(from.begin(), from.end(), values_of(to, first, unknowns).begin());
    check(VecRestoreArrayWrite(to, &first));
  }
  void give(Vec from, std::span<double> to) const {
    const PetscScalar* first = nullptr;
    const std::span<const double> values = values_of(from, first, unknowns);
    std::copy(values.begin(), values.end(), to.begin());
    check(VecRestoreArrayRead(from, &first));
  }
};

Newton::Newton(const Comm& comm, NonlinearSystem& system, const NewtonOptions& options)
    : petsc_(std::make_unique<Petsc>(comm, system, options)) {}
Newton::~Newton() = default;

NewtonResult Newton::solve(std::span<double> u) {
  Petsc& p = *petsc_;
  p.residuals.clear();
  p.stopped = false;
  p.take(u, p.u);
  p.rethrow(SNESSolve(p.snes, nullptr, p.u));
  NewtonResult result;
  SNESConvergedReason reason = SNES_CONVERGED_ITERATING;
  check(SNESGetConvergedReason(p.snes, &reason));
  PetscInt linear = 0;
  check(SNESGetLinearSolveIterations(p.snes, &linear));
  p.give(p.u, u);
  if (reason > 0) p.find_residual(p.u, p.r);
  return {reason > 0, p.stopped, p.residuals, linear, reason > 0 ? "" : text_of(reason)};
}

std::string Newton::solve_linear(std::span<const double> b, std::span<double> x) {
  Petsc& p = *petsc_;
  p.assemble();
  KSP ksp = nullptr;
  check(SNESGetKSP(p.snes, &ksp));
  check(KSPSetOperators(ksp, p.jacobian(), p.matrix));
  p.take(b, p.r);
  p.rethrow(KSPSolve(ksp, p.r, p.u));
  KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
  check(KSPGetConvergedReason(ksp, &reason));
  p.give(p.u, x);
  return reason > 0 ? "" : KSPConvergedReasons[reason];
}

void Newton::stop_when(std::function<bool()> stop) { petsc_->options.stop = std::move(stop); }

double Newton::matrix_entries() const { return static_cast<double>(petsc_->comm.sum(static_cast<long>(petsc_->entries))); }

std::string Newton::version() {
  char text[256];
  PetscGetVersion(text, sizeof(text));
  return text;
}

void Newton::finalize() { petsc::end(); }

}  // namespace sinew
