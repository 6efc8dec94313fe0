#pragma once
/// Newmark's method, and that of Hilber, Hughes & Taylor, which damps what is too fast for the step. With h >= 0 the numerical damping (-alpha of the paper), f all forces but inertia,
///
///     M a_1 = (1 - h) f(u_1, v_1) + h f_0
///     u_1 = u_0 + dt v_0 + dt^2 ((1/2 - beta) a_0 + beta a_1);   v_1 = v_0 + dt ((1 - gamma) a_0 + gamma a_1)
///
/// beta = (1 + h)^2 / 4, gamma = 1/2 + h. Second order; unconditionally stable for linear systems. h = 0 is Newmark's method with constant mean acceleration, which conserves their energy.

#include <sinew/core/registry.hpp>
#include <string_view>

namespace sinew {

struct Newmark {
  static constexpr std::string_view name = "newmark";
  static constexpr std::string_view summary = "Implicit: constant mean acceleration, steps of any length, no damping";
  static constexpr std::string_view source = "Newmark (1959); Ren et al. (2020), sec. 6";
  static void describe(auto&&, auto&) {}

  double damping = 0.0;  ///< h
  double beta() const { return 0.25 * (1.0 + damping) * (1.0 + damping); }
  double gamma() const { return 0.5 + damping; }
  /// Factor of dt^2 |a_1 - a_0| in the error of u_1: what the next term of its series is, less what the step has of it. Zienkiewicz & Xie (1991).
  double error_factor() const { return beta() - 1.0 / 6.0; }
};

struct HilberHughesTaylor {
  static constexpr std::string_view name = "hht_alpha";
  static constexpr std::string_view summary = "Implicit: Newmark's method with damping of what is too fast for the step";
  static constexpr std::string_view source = "Hilber, Hughes & Taylor (1977); Ren et al. (2020), sec. 6";
  static void describe(auto&&, auto&) {}
};

/// The integrators that solve equations, one line each.
using ImplicitIntegrators = TypeList<Newmark, HilberHughesTaylor>;

}  // namespace sinew
