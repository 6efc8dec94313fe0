#pragma once
/// The explicit integrators, one line each.

#include <sinew/core/registry.hpp>
#include <sinew/time/runge_kutta.hpp>
#include <sinew/time/velocity_verlet.hpp>

namespace sinew {

using Integrators = TypeList<VelocityVerlet, RungeKutta3>;

}  // namespace sinew
