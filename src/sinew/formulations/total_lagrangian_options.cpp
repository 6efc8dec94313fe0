#include <sinew/formulations/total_lagrangian.hpp>

namespace sinew {

std::string_view name_of(WaveSpeed speed) {
  constexpr std::string_view names[] = {"bound", "stretch", "reference"};
  return names[static_cast<int>(speed)];
}

std::string_view name_of(DeformationGradient form) {
  constexpr std::string_view names[] = {"direct", "rate", "bond", "bond_variational"};
  return names[static_cast<int>(form)];
}

std::string_view name_of(MomentumForm form) {
  constexpr std::string_view names[] = {"adjoint", "symmetric"};
  return names[static_cast<int>(form)];
}

bool TotalLagrangianOptions::separates() const {
  for (std::size_t body = 0; body < damages.size(); ++body)
    if (separates(body)) return true;
  return false;
}

bool may_use_lattice(const TotalLagrangianOptions& options) {
  return options.lattice && !options.separates() && !options.extended() &&
         std::visit([](const auto& c) { return c.radial; }, options.correction);
}

}  // namespace sinew
