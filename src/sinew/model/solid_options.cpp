#include <sinew/model/solid_options.hpp>
#include <sinew/time/runge_kutta.hpp>

#include <string>

namespace sinew {

namespace {

WeightStorage weight_storage(const std::string& name) {
  for (WeightStorage storage : {WeightStorage::stored, WeightStorage::single, WeightStorage::computed})
    if (name == name_of(storage)) return storage;
  return WeightStorage::automatic;
}

/// `alpha_of(E, G)`: of the hourglass stiffness that a treatment is, for a material with these constants.
template <class Alpha>
void use_as_hourglass(const Case& c, const HourglassStiffness& form, TotalLagrangianOptions& options, const Alpha& alpha_of) {
  options.hourglass = form;
  for (const BodyCase& body : c.bodies) {
    const double alpha = std::visit(
        [&](const auto& m) { return m.elastic.youngs_modulus > 0.0 ? alpha_of(m.elastic.youngs_modulus, m.elastic.mu()) : 0.0; },
        body.material);
    options.hourglass_factors.push_back(alpha / form.alpha);
  }
}

}  // namespace

TotalLagrangianOptions total_lagrangian_options(const Case& c) {
  TotalLagrangianOptions options{
      .kernel = c.formulation.kernel, .correction = c.formulation.correction, .hourglass = {}, .materials = {}};
  options.plane_stress = c.general.plane == PlaneState::stress;
  options.thickness = c.general.thickness;
  for (const AnyStabilization& s : c.formulation.stabilizations)
    if (const auto* hourglass = std::get_if<HourglassStiffness>(&s)) {
      if (hourglass->alpha > 0.0) options.hourglass = *hourglass;
    } else if (const auto* jst = std::get_if<JstDissipation>(&s)) {
      if (jst->eta2 > 0.0 || jst->eta4 > 0.0) options.jst = *jst;
    } else if (const auto* viscosity = std::get_if<ArtificialViscosity>(&s)) {
      options.viscosity = *viscosity;
    } else if (const auto* shear = std::get_if<NonNestedShear>(&s)) {
      use_as_hourglass(c, {}, options, [&](double E, double G) { return shear->alpha(c.general.dimension, G / E); });
    } else if (const auto* energy = std::get_if<HourglassEnergy>(&s)) {
      HourglassStiffness stiff;
      stiff.plastic_switch = false;
      use_as_hourglass(c, stiff, options, [&](double E, double G) { return energy->alpha(E, G); });
    }
  for (const BodyCase& body : c.bodies) {
    options.materials.push_back(body.material);
    options.damages.push_back(body.damage);
  }
  options.weights = weight_storage(c.solver.pair_weights);
  options.lattice = c.solver.lattice == "auto";
  for (WaveSpeed speed : {WaveSpeed::stretch, WaveSpeed::reference})
    if (c.solver.wave_speed == name_of(speed)) options.wave_speed = speed;
  for (DeformationGradient form : {DeformationGradient::rate, DeformationGradient::bond, DeformationGradient::bond_variational})
    if (c.formulation.deformation_gradient == name_of(form)) options.deformation_gradient = form;
  if (c.formulation.momentum == name_of(MomentumForm::symmetric)) options.momentum = MomentumForm::symmetric;
  options.stages = c.solver.integrator == RungeKutta3::name;
  if (c.general.dimension == 3) options.plane_stress = false, options.thickness = 1.0;
  return options;
}

UpdatedLagrangianOptions updated_lagrangian_options(const Case& c, double spacing) {
  UpdatedLagrangianOptions options{.kernel = c.formulation.kernel, .materials = {}};
  options.spacing = spacing;
  options.radius = *c.formulation.support * spacing;
  options.corrected = std::holds_alternative<GradientCorrection>(c.formulation.correction);
  options.thickness = c.general.dimension == 3 ? 1.0 : c.general.thickness;
  for (const AnyStabilization& s : c.formulation.stabilizations) {
    if (const auto* viscosity = std::get_if<ArtificialViscosity>(&s)) options.viscosity = *viscosity;
    if (const auto* pressure = std::get_if<ArtificialPressure>(&s); pressure && pressure->gamma > 0.0)
      options.pressure = *pressure;
    if (const auto* stress = std::get_if<ArtificialStress>(&s); stress && stress->epsilon > 0.0) options.stress = *stress;
    if (const auto* shear = std::get_if<NonNestedShear>(&s)) options.shear = *shear;
  }
  for (const BodyCase& body : c.bodies) {
    options.materials.push_back(body.material);
    options.damages.push_back(body.damage);
  }
  return options;
}

}  // namespace sinew
