#include <sinew/model/field_names.hpp>

namespace sinew {

using enum QuantityKind;

const std::vector<QuantityInfo>& particle_quantities() {
  static const std::vector<QuantityInfo> list{
      {"displacement", vector, "m", "Current minus reference position."},
      {"velocity", vector, "m/s", "Velocity."},
      {"acceleration", vector, "m/s^2", "Acceleration, of the internal forces and the loads."},
      {"position", vector, "m", "Current position."},
      {"deformation_gradient", tensor, "1", "Deformation gradient F."},
      {"green_lagrange_strain", tensor, "1", "Green-Lagrange strain (F^T F - I)/2."},
      {"cauchy_stress", tensor, "Pa", "Cauchy stress; tension is positive."},
      {"first_piola_kirchhoff_stress", tensor, "Pa", "First Piola-Kirchhoff stress P."},
      {"von_mises_stress", scalar, "Pa", "Von Mises stress of the Cauchy stress."},
      {"pressure", scalar, "Pa", "Minus a third of the trace of the Cauchy stress."},
      {"jacobian", scalar, "1", "J = det F, current over reference volume."},
      {"strain_energy_density", scalar, "J/m^3", "Strain energy per reference volume."},
      {"density", scalar, "kg/m^3", "Current mass density."},
      {"volume", scalar, "m^3", "Reference volume of the particle."},
      {"neighbors", scalar, "1", "Number of neighbors inside the kernel."},
      {"force", vector, "N", "Total force on the particle."},
      {"contact_force", vector, "N", "Force of walls and of other particles in contact on the particle."},
      {"hourglass_error", scalar, "1", "Largest departure of a pair from the deformation gradient, over its reference distance."},
      {"thickness_stretch", scalar, "1", "Stretch F33 across the plane; two dimensions only."},
      {"plastic_strain", scalar, "1", "Equivalent plastic strain; 0 in elastic materials."},
      {"plastic_work", scalar, "J/m^3", "Plastic work per reference volume; 0 in elastic materials."},
      {"damage", scalar, "1", "Damage, from 0 (intact) to 1 (failed: carries no tension)."},
      {"temperature", scalar, "K", "Temperature; 0 in materials that know none."},
  };
  return list;
}

const std::vector<QuantityInfo>& total_quantities() {
  static const std::vector<QuantityInfo> list{
      {"energy.kinetic", scalar, "J", "Kinetic energy.", true},
      {"energy.strain", scalar, "J", "Strain energy of the material.", true},
      {"energy.hourglass", scalar, "J", "Energy of the treatment of zero-energy modes.", true},
      {"energy.contact", scalar, "J", "Elastic energy of contact.", true},
      {"energy.external_work", scalar, "J", "Work done by loads, body forces, prescribed motions and moving walls.", true},
      {"energy.total", scalar, "J", "Kinetic, strain, hourglass and contact energy.", true},
      {"energy.dissipated", scalar, "J", "Energy taken out by damping, viscosity, contact, plastic flow and damage.", true},
      {"energy.plastic_work", scalar, "J", "Plastic work, part of the dissipated energy.", true},
      {"energy.damage_work", scalar, "J", "Energy dissipated by damage, part of the dissipated energy.", true},
      {"energy.balance_error", scalar, "J", "Total and dissipated energy minus external work and initial energy.", true},
      {"linear_momentum", vector, "kg m/s", "Sum of mass times velocity.", true},
      {"angular_momentum", vector, "kg m^2/s", "Sum of position cross mass times velocity, about the origin.", true},
      {"reaction_force", vector, "N", "Force with which the prescribed motions act on a region.", true},
      {"wall_force", vector, "N", "Force with which a wall pushes the particles.", true},
      {"contact_depth", scalar, "1", "Deepest overlap in contact, over the distance of centers at which particles touch.", true},
      {"fragments", scalar, "1",
       "Number of pieces: particles that have not failed, linked to their neighbors that have not failed either.", true},
      {"largest_fragment", scalar, "kg", "Mass of the heaviest of these pieces.", true},
      {"debris", scalar, "kg", "Mass of the failed particles, which belong to no piece.", true},
      {"reference_updates", scalar, "1", "How often the reference configuration has been renewed.", true},
      {"time_step", scalar, "s", "Time step.", true},
  };
  return list;
}

const QuantityInfo* find_quantity(std::string_view name) {
  for (const auto* list : {&particle_quantities(), &total_quantities()})
    for (const QuantityInfo& quantity : *list)
      if (quantity.name == name) return &quantity;
  return nullptr;
}

const std::vector<std::string>& field_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const QuantityInfo& quantity : particle_quantities()) list.push_back(quantity.name);
    return list;
  }();
  return names;
}

const std::vector<std::string>& probe_quantity_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list = field_names();
    for (const QuantityInfo& quantity : total_quantities()) list.push_back(quantity.name);
    return list;
  }();
  return names;
}

std::vector<std::string> component_names(const QuantityInfo& quantity, int dimension) {
  if (quantity.kind == scalar) return {};
  if (quantity.kind == tensor) {
    if (dimension == 2) return {"xx", "xy", "yx", "yy", "zz"};
    return {"xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"};
  }
  if (dimension == 3) return {"x", "y", "z", "magnitude"};
  if (quantity.name == "angular_momentum") return {"z"};
  return {"x", "y", "magnitude"};
}

}  // namespace sinew
