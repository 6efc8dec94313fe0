#include <sinew/model/parameters.hpp>
#include <sinew/model/read_case.hpp>

#include <filesystem>

namespace sinew {
namespace {

/// The units come first: parameters may be given with units, and everything else may use parameters.
void read_units(CaseReader& reader, const Node& table) {
  if (const Node* units = table.find("units")) {
    FieldSpec spec;
    spec.owner = "[case]";
    spec.key = "units";
    read_value(reader.reading.units, *units, spec, reader.reading);
  }
}

/// Keys that mean something in two dimensions only.
void check_plane_keys(const GeneralCase& general, const Node& table, Node& resolved) {
  if (general.dimension == 2) return;
  for (const std::string key : {"plane", "thickness"}) {
    if (const Node* given = table.find(key))
      throw CaseError(given->place, "[case]: \"" + key + "\" belongs to two-dimensional cases, but dimension = 3; remove it");
    erase_member(resolved, key);
  }
}

}  // namespace

void read_general(CaseReader& reader) {
  const Node table = section_table(reader, "case");
  read_units(reader, table);
  const Node parameters = section_table(reader, "parameters");
  reader.reading.constants = evaluate_parameters(parameters, reader.reading);
  reader.result.parameters = reader.reading.constants;

  GeneralCase& general = reader.result.general;
  general.name = std::filesystem::path(reader.root.place.file).stem().string();
  Node resolved = read_described(general, table, "[case]", reader.reading);
  check_plane_keys(general, table, resolved);
  if (general.name.empty()) throw CaseError(table.place, "[case]: name must not be empty");
  if (general.name.find('/') != std::string::npos)
    throw CaseError(table.find("name")->place,
                    "[case]: name must not contain \"/\", because the folder of a run is called after it");
  reader.reading.dimension = general.dimension;
  add_resolved(reader, "case", std::move(resolved));
  add_resolved(reader, "parameters", parameters);
}

}  // namespace sinew
