#pragma once
/// The corrections of the kernel gradient, one line each.

#include <sinew/core/registry.hpp>
#include <sinew/corrections/gradient.hpp>
#include <sinew/corrections/linear.hpp>
#include <sinew/corrections/mixed.hpp>
#include <sinew/corrections/none.hpp>
#include <sinew/corrections/shepard.hpp>

namespace sinew {

using Corrections = TypeList<NoCorrection, ShepardCorrection, GradientCorrection, MixedCorrection, LinearCorrection>;
using AnyCorrection = Corrections::Variant;

}  // namespace sinew
