#pragma once
/// [solver] of a case.

#include <limits>
#include <optional>
#include <sinew/core/params.hpp>
#include <sinew/model/field_options.hpp>
#include <string>

namespace sinew {

/// [solver]
struct SolverCase {
  std::string mode = "explicit";
  std::string integrator = "velocity_verlet";
  double cfl = 0.3;
  std::string wave_speed = "bound";
  double end_time = std::numeric_limits<double>::infinity();  ///< infinity if only max_steps ends the run
  std::optional<long> max_steps;
  std::optional<double> time_step;  ///< fixed step instead of the adaptive one
  double damping = 0.0;             ///< a += -damping v  [1/time]
  std::string pair_weights = "auto";
  std::string lattice = "auto";
  std::optional<long> block_size;  ///< largest_block otherwise
  // modes that solve equations
  bool ramp = true;
  std::optional<double> longest_step;  ///< time_step otherwise
  double tolerance = 1e-8;
  int most_iterations = 25;
  std::string linear_solver = "auto";
  std::string petsc;
  double numerical_damping = 0.1;
  std::optional<double> step_error;

  bool is_static() const { return mode == "static"; }
  bool is_explicit() const { return mode == "explicit"; }

  static void describe(auto&& field, auto& m) {
    constexpr Range courant{0.0, 1.0, true, false, "greater than 0 and at most 1"};
    field("mode", m.mode, no_unit,
          "explicit: motion in time, step by step; implicit: the same in steps of any length, each of which solves equations; "
          "static: balance of forces, while time is nothing but a measure of the load.",
          optional, OneOf{{"explicit", "implicit", "static"}});
    field("integrator", m.integrator, no_unit,
          "Time integration: explicit has velocity_verlet and rk3, implicit newmark (if not given) and hht_alpha.", optional,
          OneOf{{"velocity_verlet", "rk3", "newmark", "hht_alpha"}});
    field("cfl", m.cfl, no_unit, "Time step over the time that a wave takes across a particle.", courant, optional);
    field("wave_speed", m.wave_speed, no_unit,
          "That wave: bound, of the current stiffness, across the reference distance of the nearest neighbor, never too slow; "
          "stretch, of the reference stiffness over the smallest principal stretch, across its current distance; "
          "reference, as at rest, whatever the volume.",
          optional, OneOf{{"bound", "stretch", "reference"}});
    field("end_time", m.end_time, "s", "Time at which the run ends; needed unless max_steps is given.", positive, optional);
    field("max_steps", m.max_steps, no_unit, "Number of steps after which the run ends.", at_least_one, optional);
    field("time_step", m.time_step, "s",
          "A fixed time step instead of the one from cfl; implicit: the first one, to be given; static: the first load step, a "
          "tenth of end_time if not given.",
          positive, optional);
    field("damping", m.damping, "1/s", "Damping rate: every particle gets the acceleration -damping times its velocity.",
          non_negative, optional);
    field("pair_weights", m.pair_weights, no_unit,
          "How the weights of pairs are kept, where no lattice makes them needless: stored; single, in half the memory and "
          "rounded to 7 "
          "digits; computed anew in each step, with no memory; auto: stored up to 8 GiB, computed beyond.",
          optional, OneOf{{"auto", "stored", "single", "computed"}});
    field("lattice", m.lattice, no_unit,
          "auto: regular arrangements of particles go without a pair list; off: never. Changes results by rounding only.",
          optional, OneOf{{"auto", "off"}});
    constexpr Range block{8.0, 16384.0, false, false, "from 8 to 16384"};
    field(
        "block_size", m.block_size, no_unit,
        "Particles at most in a block, the piece of a body that one thread computes at a time and one rank owns; 16384 if not "
        "given. Smaller blocks let more ranks share a small case, at the price of more copies. Changes results by rounding only.",
        block, optional);
    describe_equations(field, m);
  }
  static void describe_equations(auto&& field, auto& m) {
    constexpr Range part{0.0, 1.0, true, true, "between 0 and 1"};
    field("ramp", m.ramp, no_unit,
          "static: loads, body forces and given displacements whose formulas do not depend on t grow in proportion to it and "
          "have their values at end_time. With [[stage]] nothing does; there, formulas say how.",
          optional);
    field("longest_step", m.longest_step, "s",
          "implicit, static: steps that take few iterations become longer, up to this; time_step if not given.", positive,
          optional);
    field("tolerance", m.tolerance, no_unit,
          "implicit, static: balance is reached when the forces that are missing are this part of those from outside and of "
          "inertia, in the root of the sum of squares.",
          part, optional);
    field("most_iterations", m.most_iterations, no_unit,
          "implicit, static: Newton iterations after which a step is tried again with half its length.", at_least_one, optional);
    field("linear_solver", m.linear_solver, no_unit,
          "implicit, static: direct factors the matrix; assembled: conjugate gradients and multigrid with the matrix; "
          "matrix_free: with two "
          "sums over the "
          "particles in the place of its products, and a matrix of few entries for the multigrid; auto: direct up to 60 000 "
          "(2D) or 1 000 particles, matrix_free beyond.",
          optional, OneOf{{"auto", "direct", "assembled", "matrix_free"}});
    field("petsc", m.petsc, no_unit, "implicit, static: options for PETSc, such as \"-snes_monitor -ksp_rtol 1e-8\".", optional);
    constexpr Range third{0.0, 1.0 / 3.0, false, false, "from 0 to 1/3"};
    field("numerical_damping", m.numerical_damping, no_unit,
          "hht_alpha: how much of what is too fast for the step is damped, -alpha of the method; 0 is newmark.", third, optional);
    field("step_error", m.step_error, no_unit,
          "implicit: steps are as long as the error of the displacements in one allows, this part of the largest displacement so "
          "far; as given if this is not.",
          part, optional);
  }
};

}  // namespace sinew
