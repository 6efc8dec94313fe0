#include <sinew/cli/catalog.hpp>

#include <algorithm>
#include <sinew/implicit/newmark.hpp>
#include <sinew/model/boundary_keys.hpp>
#include <sinew/model/field_names.hpp>
#include <sinew/time/registry.hpp>

namespace sinew {

namespace {

template <class T>
CatalogEntry entry_of() {
  CatalogEntry entry{std::string(T::name), std::string(T::summary), "", parameter_docs<T>()};
  if constexpr (requires { T::source; }) entry.source = T::source;
  return entry;
}

template <class Registry>
CatalogKind kind_of(const std::string& name, const std::string& selector) {
  CatalogKind kind{name, selector, {}};
  Registry::for_each([&]<class T>() { kind.entries.push_back(entry_of<T>()); });
  return kind;
}

CatalogKind formulations() {
  return {"formulations",
          "[formulation] model = \"NAME\"",
          {{"total_lagrangian",
            "Kernel and neighbors in the reference configuration; conserves momenta by construction.",
            "Ganzenmueller (2015); Ren et al. (2020)",
            {}},
           {"updated_lagrangian",
            "Kernel and neighbors on the current configuration: conventional SPH for solids, and its cures.",
            "Gray, Monaghan & Swift (2001); Islam & Peng (2019), sec. 2",
            {}}}};
}

CatalogKind boundaries() {
  CatalogKind kind{"boundaries", "[[boundary]] NAME = ...", {}};
  const std::vector<ParameterDoc> docs = parameter_docs<BoundaryKeys>();
  const auto parameter = [&](const std::string& name) {
    return std::find_if(docs.begin(), docs.end(), [&](const ParameterDoc& doc) { return doc.name == name; });
  };
  for (const std::string name : {"displacement", "velocity", "force", "traction", "pressure", "wall"}) {
    CatalogEntry entry{name, parameter(name)->sentence, "", {*parameter(name)}};
    if (name == "pressure" || name == "wall") entry.parameters.push_back(*parameter("normal"));
    if (name == "pressure" || name == "traction") entry.parameters.push_back(*parameter("area"));
    kind.entries.push_back(std::move(entry));
  }
  return kind;
}

CatalogKind quantities(const std::string& name, const std::string& selector, const std::vector<QuantityInfo>& infos) {
  CatalogKind kind{name, selector, {}};
  for (const QuantityInfo& info : infos)
    kind.entries.push_back({info.name, info.sentence + (info.unit == "1" ? "" : " [" + info.unit + "]"), "", {}});
  return kind;
}

/// "[[probe]]" -> "probe".
std::string bare_section(const std::string& section) {
  const std::size_t begin = section.find_first_not_of('[');
  return section.substr(begin, section.find_first_of("].", begin) - begin);
}

CatalogKind sections() {
  CatalogKind kind{"sections", "sections of the case file", {}};
  for (const auto& [section, docs] : case_sections()) {
    std::string sentence = "Section " + section + " of the case file.";
    if (docs.empty()) sentence += " Names for numbers, which formulas may use; --set and [study] change them.";
    kind.entries.push_back({bare_section(section), sentence, "", docs});
  }
  return kind;
}

}  // namespace

const std::vector<CatalogKind>& catalog() {
  static const std::vector<CatalogKind> kinds{
      kind_of<Materials>("materials", "[material.NAME] model = \"NAME\""),
      kind_of<DamageModels>("damages", "[material.NAME] damage = { model = \"NAME\" }"),
      kind_of<Kernels>("kernels", "[formulation] kernel = \"NAME\""),
      kind_of<Corrections>("corrections", "[formulation] correction = \"NAME\""),
      kind_of<Stabilizations>("stabilizations", "[formulation] stabilization = [ { model = \"NAME\" } ]"),
      formulations(),
      kind_of<Joined<Integrators, ImplicitIntegrators>>("integrators", "[solver] integrator = \"NAME\""),
      boundaries(),
      kind_of<ContactLaws>("contacts", "[[contact]] model = \"NAME\""),
      kind_of<WallShapes>("walls", "[[wall]] geometry = { shape = \"NAME\" }"),
      kind_of<Geometries>("geometries", "[[body]] geometry = { shape = \"NAME\" }"),
      quantities("fields", "[output] fields, [[probe]] quantity", particle_quantities()),
      quantities("totals", "[[probe]] quantity", total_quantities()),
      sections()};
  return kinds;
}

}  // namespace sinew
