#pragma once
/// The materials, one line each.

#include <sinew/core/registry.hpp>
#include <sinew/materials/linear_elastic.hpp>
#include <sinew/materials/neo_hookean.hpp>
#include <sinew/materials/neo_hookean_isochoric.hpp>
#include <sinew/materials/st_venant_kirchhoff.hpp>

namespace sinew {

using Materials = TypeList<LinearElastic, StVenantKirchhoff, NeoHookean, NeoHookeanIsochoric>;
using AnyMaterial = Materials::Variant;

}  // namespace sinew
