#include <sinew/model/read_case.hpp>

#include <algorithm>

namespace sinew {

namespace {

/// The form that the source of a deformation gradient has; any if it is not known.
std::string customary_momentum(const Node* gradient) {
  const bool symmetric = gradient && gradient->is(Node::Kind::string) && (gradient->text == "rate" || gradient->text == "bond");
  return symmetric ? "symmetric" : "adjoint";
}

bool has_jst(const FormulationCase& formulation) {
  return std::any_of(formulation.stabilizations.begin(), formulation.stabilizations.end(),
                     [](const AnyStabilization& s) { return std::holds_alternative<JstDissipation>(s); });
}

/// What pairs need that both ends weigh alike.
std::string asks_for_equal_radii(const FormulationCase& formulation) {
  if (formulation.momentum == "symmetric") return "momentum = \"symmetric\"";
  if (formulation.deformation_gradient == "bond_variational") return "deformation_gradient = \"bond_variational\"";
  return has_jst(formulation) ? "stabilization \"jst\"" : "";
}

void check_radii(const FormulationCase& formulation, const Node& table) {
  if (!formulation.neighbors) return;
  const Place& place = table.find("neighbors")->place;
  if (formulation.support)
    throw CaseError(place, "[formulation]: \"support\" and \"neighbors\" both set the kernel radius; give only one of them");
  if (const std::string what = asks_for_equal_radii(formulation); !what.empty())
    throw CaseError(place, "[formulation]: \"neighbors\" gives each particle a kernel radius of its own, and " + what +
                               " needs the same for all of a body; use \"support\"");
}

/// Bodies that come apart make their weights anew, particle by particle.
void check_separation(const CaseReader& reader, const Node& table) {
  const FormulationCase& formulation = reader.result.formulation;
  const bool gradient = formulation.deformation_gradient != "direct";
  if (!gradient && formulation.momentum == "adjoint") return;
  for (const BodyCase& body : reader.result.bodies)
    if (body.damage && std::visit([](const auto& damage) { return damage.growth.separate; }, *body.damage)) {
      const std::string key = gradient ? "deformation_gradient" : "momentum";
      throw CaseError(table.find(key)->place, "[formulation]: body \"" + body.name +
                                                  "\" comes apart (separate = true), which needs deformation_gradient = "
                                                  "\"direct\" and momentum = \"adjoint\"");
    }
}

}  // namespace

void read_formulation(CaseReader& reader) {
  Node table = section_table(reader, "formulation");
  if (!table.find("support") && !table.find("neighbors"))
    set_member(table, "support", Node::make_number(FormulationCase::default_support));
  if (!table.find("momentum"))
    set_member(table, "momentum", Node::make_string(customary_momentum(table.find("deformation_gradient")), table.place));
  FormulationCase& formulation = reader.result.formulation;
  Node resolved = read_described(formulation, table, "[formulation]", reader.reading);
  formulation.place = table.place;
  check_radii(formulation, table);
  check_separation(reader, table);
  if (formulation.deformation_gradient == "bond_variational" && formulation.momentum != "adjoint")
    throw CaseError(
        table.find("momentum")->place,
        "[formulation]: the force of \"bond_variational\" is the gradient of its energy; momentum must be \"adjoint\"");
  add_resolved(reader, "formulation", std::move(resolved));
}

}  // namespace sinew
