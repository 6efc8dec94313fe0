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

}  // namespace

void read_solver_and_output(CaseReader& reader) {
  const Node table = section_table(reader, "solver");
  const std::vector<StageCase>& stages = reader.result.stages;
  if (!reader.root.find("solver") && stages.empty()) throw CaseError(reader.root.place, no_end);
  check_keys(table, "[solver]", described_keys<SolverCase>());
  SolverCase& solver = reader.result.solver;
  define_end_time(reader, table);
  Node resolved = read_described(solver, table, "[solver]", reader.reading);
  if (!stages.empty()) solver.end_time = stages.back().end;
  if (!std::isfinite(solver.end_time) && !solver.max_steps) throw CaseError(table.place, no_end);
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
