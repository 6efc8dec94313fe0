#pragma once
/// The treatments of zero-energy modes and of shocks, one line each.

#include <sinew/core/registry.hpp>
#include <sinew/stabilization/artificial_viscosity.hpp>
#include <sinew/stabilization/hourglass_stiffness.hpp>
#include <sinew/stabilization/jst.hpp>

namespace sinew {

using Stabilizations = TypeList<HourglassStiffness, ArtificialViscosity, JstDissipation>;
using AnyStabilization = Stabilizations::Variant;

}  // namespace sinew
