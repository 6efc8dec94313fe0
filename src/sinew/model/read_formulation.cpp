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

/// Whether a node is a treatment, or a list with one, of that name.
bool names_model(const Node* node, const std::string& name) {
  if (!node) return false;
  if (node->is(Node::Kind::string)) return node->text == name;
  if (node->is(Node::Kind::table)) return node->find("model") && names_model(node->find("model"), name);
  return std::any_of(node->items.begin(), node->items.end(), [&](const Node& item) { return names_model(&item, name); });
}

/// What is customary on the current configuration, where the case says nothing.
void fill_in_customary(Node& table) {
  const auto fill = [&](const std::string& key, Node value) {
    if (!table.find(key)) set_member(table, key, std::move(value));
  };
  fill("kernel", Node::make_string("wendland_c2", table.place));
  if (!table.find("neighbors")) fill("support", Node::make_number(FormulationCase::default_moving_support));
  const bool explains = names_model(table.find("stabilization"), std::string(NonNestedShear::name));
  fill("correction", Node::make_string(explains ? "gradient" : "none", table.place));
  fill("stabilization", Node::make_array());
}

/// What the formulation on the current configuration does not know.
void check_updated(const CaseReader& reader, const Node& table) {
  const FormulationCase& f = reader.result.formulation;
  const auto refuse = [&](const Node* node, const std::string& text) {
    throw CaseError(node ? node->place : table.place, "[formulation]: \"updated_lagrangian\" " + text);
  };
  if (f.neighbors) refuse(table.find("neighbors"), "needs the same kernel radius for all particles; use \"support\"");
  if (f.deformation_gradient != "direct")
    refuse(table.find("deformation_gradient"), "integrates the deformation gradient in time by itself; leave this out");
  if (f.momentum != "adjoint") refuse(table.find("momentum"), "has one form of momentum, \"adjoint\"");
  if (f.project_angular_momentum) refuse(table.find("project_angular_momentum"), "does not project angular momentum");
  const bool known =
      std::holds_alternative<NoCorrection>(f.correction) || std::holds_alternative<GradientCorrection>(f.correction);
  if (!known) refuse(table.find("correction"), "knows the corrections \"none\" and \"gradient\"");
  if (reader.result.general.dimension == 2 && reader.result.general.plane == PlaneState::stress)
    refuse(nullptr, "knows plane strain only, and [case] says plane = \"stress\"");
  if (const Node* contact = reader.root.find("contact"))
    throw CaseError(contact->place,
                    "[[contact]]: with \"updated_lagrangian\" bodies touch as neighbors of each other; leave this out");
  for (const BodyCase& body : reader.result.bodies)
    if (body.damage && std::visit([](const auto& damage) { return damage.growth.separate; }, *body.damage))
      throw CaseError(body.place, "body \"" + body.name +
                                      "\": with \"updated_lagrangian\" neighbors are found anew, and failed particles are not "
                                      "cut off; leave out separate = true");
}

/// What a reference configuration that is renewed does not know.
void check_reference_update(const CaseReader& reader, const Node& table) {
  const FormulationCase& f = reader.result.formulation;
  if (!f.reference_update) return;
  const auto refuse = [&](const std::string& text) {
    throw CaseError(table.find("reference_update")->place, "[formulation]: reference_update " + text);
  };
  if (f.model != "total_lagrangian") refuse("belongs to model = \"total_lagrangian\"; \"" + f.model + "\" has no reference");
  if (f.deformation_gradient != "direct") refuse("goes with deformation_gradient = \"direct\"");
  if (f.momentum != "adjoint") refuse("goes with momentum = \"adjoint\"");
  if (has_jst(f)) refuse("does not go with stabilization \"jst\"");
  if (reader.result.general.dimension == 2 && reader.result.general.plane == PlaneState::stress)
    refuse("goes with plane = \"strain\"");
  for (const BodyCase& body : reader.result.bodies)
    if (body.damage && std::visit([](const auto& damage) { return damage.growth.separate; }, *body.damage))
      refuse("would join again what has come apart; leave out separate = true of body \"" + body.name + "\"");
}

/// Treatments belong to a configuration.
void check_stabilizations(const FormulationCase& f, const Node& table) {
  const bool current = f.model == "updated_lagrangian";
  int repulsions = 0, stiffnesses = 0;
  for (const AnyStabilization& any : f.stabilizations)
    std::visit(
        [&]<class S>(const S& treatment) {
          if constexpr (std::is_same_v<S, NonNestedShear>)
            if (!current && treatment.printed())
              throw CaseError(table.find("stabilization")->place,
                              "[formulation]: non_nested_shear has form = \"printed\" with model = \"updated_lagrangian\" only");
          if (current ? !S::in_current : !S::in_reference)
            throw CaseError(table.find("stabilization")->place, "[formulation]: stabilization \"" + std::string(S::name) +
                                                                    "\" does not go with model = \"" + f.model + "\"");
          repulsions += std::is_same_v<S, ArtificialPressure> || std::is_same_v<S, ArtificialStress>;
          stiffnesses +=
              std::is_same_v<S, HourglassStiffness> || std::is_same_v<S, HourglassEnergy> || std::is_same_v<S, NonNestedShear>;
        },
        any);
  if (stiffnesses > 1)
    throw CaseError(table.find("stabilization")->place,
                    "[formulation]: hourglass_stiffness, hourglass_energy and non_nested_shear are forms of one stiffness; give "
                    "only one of them");
  if (repulsions > 1)
    throw CaseError(
        table.find("stabilization")->place,
        "[formulation]: artificial_pressure and artificial_stress are two forms of one repulsion; give only one of them");
}

}  // namespace

void read_formulation(CaseReader& reader) {
  Node table = section_table(reader, "formulation");
  const bool updated = names_model(table.find("model"), "updated_lagrangian");
  if (updated) fill_in_customary(table);
  if (!table.find("support") && !table.find("neighbors"))
    set_member(table, "support", Node::make_number(FormulationCase::default_support));
  if (!table.find("momentum"))
    set_member(table, "momentum", Node::make_string(customary_momentum(table.find("deformation_gradient")), table.place));
  FormulationCase& formulation = reader.result.formulation;
  Node resolved = read_described(formulation, table, "[formulation]", reader.reading);
  formulation.place = table.place;
  check_radii(formulation, table);
  check_stabilizations(formulation, table);
  check_reference_update(reader, table);
  if (updated)
    check_updated(reader, table);
  else
    check_separation(reader, table);
  if (formulation.deformation_gradient == "bond_variational" && formulation.momentum != "adjoint")
    throw CaseError(
        table.find("momentum")->place,
        "[formulation]: the force of \"bond_variational\" is the gradient of its energy; momentum must be \"adjoint\"");
  add_resolved(reader, "formulation", std::move(resolved));
}

}  // namespace sinew
