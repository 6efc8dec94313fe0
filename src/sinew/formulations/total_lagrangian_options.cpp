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

template <int D>
FieldsToSave<D> TotalLagrangian<D>::fields_to_save() {
  if (later_)
    return {{{"reference_updates", &later_->number_of_updates()}},
            {{"reference_displacement", &later_->shift()}},
            {{"reference_gradient", &later_->earlier()}}};
  if (matrices_.rate.empty()) return {};
  return {{}, {}, {{"integrated_gradient", &matrices_.gradient}, {"gradient_rate", &matrices_.rate}}};
}

template <int D>
std::vector<std::string> TotalLagrangian<D>::warnings() const {
  if (options_.hourglass || options_.jst) return {};
  return {"zero-energy modes are not controlled: stabilization is off."};
}

/// What a failed run may try about its zero-energy modes.
template <int D>
std::string TotalLagrangian<D>::advice() const {
  const std::optional<HourglassStiffness>& hourglass = options_.hourglass;
  if (options_.momentum == MomentumForm::symmetric)
    return "momentum = \"symmetric\", which can feed motion (try \"bond_variational\", or particles on_faces)";
  if (!hourglass && options_.jst) return "zero-energy modes (try larger coefficients of jst, or hourglass_stiffness)";
  if (!hourglass) return "zero-energy modes, which nothing controls (try stabilization = [{ model = \"hourglass_stiffness\" }])";
  if (!hourglass->conservative())
    return "the central hourglass force, which can feed motion (try normalization = \"conservative\")";
  return "zero-energy modes (try a larger alpha of hourglass_stiffness)";
}

#define SINEW_INSTANTIATE(D)                                              \
  template FieldsToSave<D> TotalLagrangian<D>::fields_to_save();          \
  template std::vector<std::string> TotalLagrangian<D>::warnings() const; \
  template std::string TotalLagrangian<D>::advice() const;
SINEW_INSTANTIATE(2)
SINEW_INSTANTIATE(3)

}  // namespace sinew
