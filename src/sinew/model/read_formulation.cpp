#include <sinew/model/read_case.hpp>

namespace sinew {

void read_formulation(CaseReader& reader) {
  Node table = section_table(reader, "formulation");
  if (!table.find("support") && !table.find("neighbors"))
    set_member(table, "support", Node::make_number(FormulationCase::default_support));
  FormulationCase& formulation = reader.result.formulation;
  Node resolved = read_described(formulation, table, "[formulation]", reader.reading);
  formulation.place = table.place;
  if (formulation.support && formulation.neighbors)
    throw CaseError(table.find("neighbors")->place,
                    "[formulation]: \"support\" and \"neighbors\" both set the kernel radius; give only one of them");
  add_resolved(reader, "formulation", std::move(resolved));
}

}  // namespace sinew
