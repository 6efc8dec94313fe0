#pragma once
/// Everything that a case can name, from the declarations that the case reader checks against.

#include <sinew/model/case.hpp>
#include <string>
#include <vector>

namespace sinew {

struct CatalogEntry {
  std::string name, sentence, source;
  std::vector<ParameterDoc> parameters;
};

struct CatalogKind {
  std::string name;      ///< "materials"
  std::string selector;  ///< how a case file names one: `model = "..."` in [material.NAME]
  std::vector<CatalogEntry> entries;
};

/// materials, kernels, ..., in the order of the documentation; last the sections of the case file.
const std::vector<CatalogKind>& catalog();

/// As a terminal or, with `markdown`, a page shows it.
std::string entry_text(const CatalogEntry& entry);
std::string entry_markdown(const CatalogEntry& entry);
std::string kind_markdown(const CatalogKind& kind);

}  // namespace sinew
