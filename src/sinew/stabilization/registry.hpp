#pragma once
/// The treatments of zero-energy modes, one line each.

#include <sinew/core/registry.hpp>
#include <sinew/stabilization/hourglass_stiffness.hpp>

namespace sinew {

using Stabilizations = TypeList<HourglassStiffness>;
using AnyStabilization = Stabilizations::Variant;

}  // namespace sinew
