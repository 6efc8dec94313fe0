#include <sinew/model/read_case.hpp>

#include <algorithm>
#include <cmath>

namespace sinew {
namespace {

constexpr const char* no_end = "[solver]: \"end_time\" is missing. Give the time at which the run ends, or max_steps.";

/// end_time comes first, since the other keys may use it.
void define_end_time(CaseReader& reader, const Node& table) {
  const Node* node = table.find("end_time");
  if (!reader.result.stages.empty()) {
    if (node) throw CaseError(node->place, "[solver]: with [[stage]] the run ends with the last stage; leave end_time out");
    reader.reading.constants["end_time"] = reader.result.stages.back().end;
  }
  if (!node) return;
  FieldSpec spec;
  spec.owner = "[solver]";
  spec.key = "end_time";
  spec.unit = "s";
  spec.range = positive;
  reader.reading.constants["end_time"] = read_number(*node, spec, reader.reading);
}

bool names_mode(const Node& table, const std::string& name) {
  const Node* mode = table.find("mode");
  return mode && mode->is(Node::Kind::string) && mode->text == name;
}

/// What is customary in a mode, where the case says nothing.
void fill_in_customary(const CaseReader& reader, Node& table) {
  const auto fill = [&](const std::string& key, const Node& value) {
    if (!table.find(key)) set_member(table, key, value);
  };
  if (names_mode(table, "implicit")) fill("integrator", Node::make_string("newmark", table.place));
  if (!names_mode(table, "static") || !reader.result.stages.empty()) return;
  fill("end_time", Node::make_number(1.0, table.place));
  fill("time_step", Node::make_string("end_time/10", table.place));
}

/// Keys that mean something in some modes only.
const std::vector<std::string> of_explicit{"cfl", "wave_speed"};
const std::vector<std::string> of_motion{"integrator", "damping", "step_error", "numerical_damping"};
const std::vector<std::string> of_equations{"ramp",          "longest_step", "tolerance",         "most_iterations",
                                            "linear_solver", "petsc",        "numerical_damping", "step_error"};

/// So that the resolved case is one again.
void erase_others(const SolverCase& solver, Node& resolved) {
  const auto erase = [&](const std::vector<std::string>& keys) {
    for (const std::string& key : keys) erase_member(resolved, key);
  };
  if (solver.is_explicit()) return erase(of_equations);
  erase(of_explicit);
  if (solver.is_static()) erase(of_motion);
}

/// What a solver of equations does not know.
void check_equations(const CaseReader& reader, const Node& table) {
  const Case& c = reader.result;
  const FormulationCase& f = c.formulation;
  const auto refuse = [&](const Place& place, const std::string& text) {
    throw CaseError(place, "[solver]: mode = \"" + c.solver.mode + "\" " + text);
  };
  const auto refuse_keys = [&](const std::vector<std::string>& keys, const std::string& what) {
    for (const std::string& key : keys)
      if (const Node* node = table.find(key)) refuse(node->place, "does not know " + key + ", which belongs to " + what);
  };
  refuse_keys(of_explicit, "mode = \"explicit\"");
  if (c.solver.is_static()) refuse_keys(of_motion, "motion in time");
  if (!c.solver.time_step) refuse(table.place, "needs time_step, the length of the first step");
  if (f.model != "total_lagrangian") refuse(f.place, "goes with model = \"total_lagrangian\"");
  if (f.deformation_gradient != "direct" || f.momentum != "adjoint")
    refuse(f.place, "goes with deformation_gradient = \"direct\" and momentum = \"adjoint\"");
  if (f.reference_update) refuse(f.place, "goes without reference_update");
  if (f.project_angular_momentum) refuse(f.place, "goes without project_angular_momentum");
  for (const AnyStabilization& any : f.stabilizations) {
    if (std::holds_alternative<JstDissipation>(any)) refuse(f.place, "goes without jst");
    if (std::holds_alternative<ArtificialViscosity>(any) && !c.solver.is_static())
      refuse(f.place, "goes without artificial_viscosity");
    const auto* stiffness = std::get_if<HourglassStiffness>(&any);
    if (stiffness && !stiffness->conservative())
      refuse(f.place, "goes with normalization = \"conservative\" of hourglass_stiffness, or with hourglass_energy");
  }
  for (const BodyCase& body : c.bodies)
    if (body.damage) refuse(body.place, "goes without damage, and body \"" + body.name + "\" has it");
  for (const char* section : {"contact", "wall"})
    if (const Node* node = reader.root.find(section)) refuse(node->place, std::string("knows no [[") + section + "]]");
}

/// Integrators belong to a mode.
void check_integrator(const SolverCase& solver, const Node& table) {
  if (solver.is_static()) return;
  const bool explicit_one = solver.integrator == "velocity_verlet" || solver.integrator == "rk3";
  if (explicit_one == solver.is_explicit()) return;
  const Node* node = table.find("integrator");
  throw CaseError(node ? node->place : table.place, "[solver]: integrator \"" + solver.integrator + "\" belongs to mode = \"" +
                                                        (explicit_one ? "explicit" : "implicit") + "\"");
}

}  // namespace

void read_solver_and_output(CaseReader& reader) {
  Node table = section_table(reader, "solver");
  fill_in_customary(reader, table);
  const std::vector<StageCase>& stages = reader.result.stages;
  if (!reader.root.find("solver") && stages.empty()) throw CaseError(reader.root.place, no_end);
  check_keys(table, "[solver]", described_keys<SolverCase>());
  SolverCase& solver = reader.result.solver;
  define_end_time(reader, table);
  Node resolved = read_described(solver, table, "[solver]", reader.reading);
  if (!stages.empty()) solver.end_time = stages.back().end;
  if (!std::isfinite(solver.end_time) && !solver.max_steps) throw CaseError(table.place, no_end);
  check_integrator(solver, table);
  if (!solver.is_explicit()) check_equations(reader, table);
  if (solver.integrator == "rk3" && (reader.root.find("contact") || reader.root.find("wall")))
    throw CaseError(table.find("integrator")->place,
                    "[solver]: integrator \"rk3\" knows no contact and no walls; use \"velocity_verlet\"");
  if (reader.result.formulation.reference_update && solver.wave_speed != "bound")
    throw CaseError(table.find("wave_speed")->place, "[solver]: reference_update goes with wave_speed \"bound\"");
  if (reader.result.formulation.model == "updated_lagrangian") {
    if (solver.integrator != "velocity_verlet")
      throw CaseError(table.find("integrator")->place,
                      "[solver]: \"updated_lagrangian\" goes with integrator \"velocity_verlet\"");
    if (solver.wave_speed != "bound")
      throw CaseError(table.find("wave_speed")->place, "[solver]: \"updated_lagrangian\" goes with wave_speed \"bound\"");
  }
  erase_others(solver, resolved);
  add_resolved(reader, "solver", std::move(resolved));

  const Node output_table = section_table(reader, "output");
  OutputCase& output = reader.result.output;
  add_resolved(reader, "output", read_described(output, output_table, "[output]", reader.reading));
  if (reader.result.formulation.model == "updated_lagrangian" &&
      std::find(output.fields.begin(), output.fields.end(), "hourglass_error") != output.fields.end())
    throw CaseError(output_table.find("fields")->place,
                    "[output]: fields: hourglass_error does not exist with \"updated_lagrangian\", whose deformation gradient is "
                    "not one of displacements");
  const bool png = output.picture.ends_with(".png") && output.picture.find('/') == std::string::npos;
  if (!output.picture.empty() && !png)
    throw CaseError(
        output_table.find("picture")->place,
        "[output]: picture must be a file name that ends with .png, without folders, found \"" + output.picture + "\"");
}

}  // namespace sinew
