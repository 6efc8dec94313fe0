#pragma once
/// The materials, one line each.

#include <sinew/core/registry.hpp>
#include <sinew/materials/hardening/johnson_cook.hpp>
#include <sinew/materials/hardening/linear.hpp>
#include <sinew/materials/hardening/voce.hpp>
#include <sinew/materials/j2.hpp>
#include <sinew/materials/linear_elastic.hpp>
#include <sinew/materials/neo_hookean.hpp>
#include <sinew/materials/neo_hookean_isochoric.hpp>
#include <sinew/materials/rate_form.hpp>
#include <sinew/materials/rates/drucker_prager.hpp>
#include <sinew/materials/rates/elastic_rate.hpp>
#include <sinew/materials/rates/mu_i_rheology.hpp>
#include <sinew/materials/rigid.hpp>
#include <sinew/materials/st_venant_kirchhoff.hpp>

namespace sinew {

using ElasticMaterials = TypeList<LinearElastic, StVenantKirchhoff, NeoHookean, NeoHookeanIsochoric>;
using PlasticMaterials = TypeList<J2<LinearHardening>, J2<VoceHardening>, J2<JohnsonCookHardening>>;
using RateMaterials = TypeList<RateForm<ElasticRate>, RateForm<DruckerPrager>, RateForm<MuIRheology>>;
using DeformableMaterials = Joined<Joined<ElasticMaterials, PlasticMaterials>, RateMaterials>;
using Materials = Joined<DeformableMaterials, TypeList<Rigid>>;
using AnyMaterial = Materials::Variant;

inline double density_of(const AnyMaterial& material) {
  return std::visit([](const auto& m) { return m.density; }, material);
}
inline double youngs_modulus_of(const AnyMaterial& material) {
  return std::visit([](const auto& m) { return m.elastic.youngs_modulus; }, material);
}
/// lambda + 2 mu: density times the square of the speed of longitudinal waves at rest [pressure].
inline double longitudinal_modulus_of(const AnyMaterial& material) {
  return std::visit([](const auto& m) { return m.elastic.lambda() + 2.0 * m.elastic.mu(); }, material);
}

}  // namespace sinew
