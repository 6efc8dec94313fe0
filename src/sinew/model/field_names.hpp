#pragma once
/// The quantities that files can hold and probes can follow.

#include <string>
#include <string_view>
#include <vector>

namespace sinew {

enum class QuantityKind { scalar, vector, tensor };

struct QuantityInfo {
  std::string name;
  QuantityKind kind;
  std::string unit;  ///< in SI
  std::string sentence;
  bool is_total = false;  ///< one value for a whole region rather than one a particle
};

/// One value a particle: displacement, velocity, ...
const std::vector<QuantityInfo>& particle_quantities();
/// One value for all particles of a region: energies, momenta, reaction force, time step.
const std::vector<QuantityInfo>& total_quantities();
/// Either of the two; nullptr if there is none of that name.
const QuantityInfo* find_quantity(std::string_view name);

const std::vector<std::string>& field_names();           ///< names of particle_quantities()
const std::vector<std::string>& probe_quantity_names();  ///< names of both lists
/// The components that a probe may ask for: none for a scalar; x y z magnitude; xx xy ... for a tensor.
std::vector<std::string> component_names(const QuantityInfo& quantity, int dimension);

}  // namespace sinew
