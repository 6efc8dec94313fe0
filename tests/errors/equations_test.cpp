/// [solver] mode = "static" and "implicit" with what they do not know, and pressures that follow.

#include "errors/wrong_case.hpp"

namespace sinew {

static const std::string solver = "cfl = 0.3\nend_time = 0.5\n";
static const std::string is_static = "mode = \"static\"\n", is_implicit = "mode = \"implicit\"\ntime_step = 0.01\nend_time = 1\n";

static const std::vector<WrongCase> wrong_equations{
    {"CflInStatics", solver, is_static + "cfl = 0.3\n",
     "case.toml:30:7: [solver]: mode = \"static\" does not know cfl, which belongs to mode = \"explicit\""},
    {"DampingInStatics", solver, is_static + "damping = 0.3\n",
     "case.toml:30:11: [solver]: mode = \"static\" does not know damping, which belongs to motion in time"},
    {"NewmarkInExplicit", solver, "end_time = 1\nintegrator = \"newmark\"\n",
     "case.toml:30:14: [solver]: integrator \"newmark\" belongs to mode = \"implicit\""},
    {"VerletInImplicit", solver, is_implicit + "integrator = \"velocity_verlet\"\n",
     "case.toml:32:14: [solver]: integrator \"velocity_verlet\" belongs to mode = \"explicit\""},
    {"ImplicitWithoutStep", solver, "mode = \"implicit\"\nend_time = 1\n",
     "case.toml:28:1: [solver]: mode = \"implicit\" needs time_step, the length of the first step"},
    {"UnknownLinearSolver", solver, is_static + "linear_solver = \"multigrid\"\n",
     "case.toml:30:17: [solver]: linear_solver: unknown name \"multigrid\". Known names: auto, direct, assembled, matrix_free."},
    {"ToleranceTooLarge", solver, is_static + "tolerance = 2\n",
     "case.toml:30:13: [solver]: tolerance must be between 0 and 1, found 2"},
    {"TooMuchNumericalDamping", solver, is_implicit + "integrator = \"hht_alpha\"\nnumerical_damping = 0.5\n",
     "case.toml:33:21: [solver]: numerical_damping must be from 0 to 1/3, found 0.5"},
    {"FollowingTraction", "velocity = [0, 0, 0]", "traction = [0, 0, 1]\nfollower = true",
     "case.toml:28:12: boundary 1: \"follower\" belongs to pressure only"},
    {"FollowerOnRenewedReference", "stabilization = [ { model = \"hourglass_stiffness\", alpha = 50.0 } ]",
     "reference_update = {}\n[[boundary]]\nregion = \"foot\"\npressure = 1\nfollower = true",
     "case.toml:23:12: boundary 1: follower does not go with reference_update"},
};

SINEW_WRONG_CASES(WrongEquations, wrong_equations);

}  // namespace sinew
