#pragma once
/// The treatments of zero-energy modes and of shocks, one line each.

#include <sinew/core/registry.hpp>
#include <sinew/stabilization/artificial_pressure.hpp>
#include <sinew/stabilization/artificial_stress.hpp>
#include <sinew/stabilization/artificial_viscosity.hpp>
#include <sinew/stabilization/hourglass_energy.hpp>
#include <sinew/stabilization/hourglass_stiffness.hpp>
#include <sinew/stabilization/jst.hpp>
#include <sinew/stabilization/non_nested_shear.hpp>

namespace sinew {

using Stabilizations = TypeList<HourglassStiffness, HourglassEnergy, ArtificialViscosity, JstDissipation, ArtificialPressure,
                                ArtificialStress, NonNestedShear>;
using AnyStabilization = Stabilizations::Variant;

}  // namespace sinew
