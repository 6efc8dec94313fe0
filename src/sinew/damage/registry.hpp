#pragma once
/// The models of damage, one line each.

#include <sinew/core/registry.hpp>
#include <sinew/damage/johnson_cook_failure.hpp>
#include <sinew/damage/plastic_strain.hpp>
#include <sinew/damage/principal_strain.hpp>

namespace sinew {

using DamageModels = TypeList<PrincipalStrainDamage, PlasticStrainDamage, JohnsonCookFailure>;
using AnyDamage = DamageModels::Variant;

}  // namespace sinew
