#pragma once
/// A model of damage after the material has answered, for eight particles at once.

#include <sinew/damage/registry.hpp>
#include <sinew/formulations/material_point.hpp>

namespace sinew {

/// Numbers that damage keeps of a particle: the cube root of D, the energy that it has dissipated and the plastic work that was not done since D had taken the
/// stress [pressure], then those of the model.
inline constexpr int damage_numbers = 3;
int numbers_of(const AnyDamage& damage);

/// The function that does it.
template <int D>
typename MaterialPoint<D>::DamageFunction damage_function(const AnyDamage& damage);

}  // namespace sinew
