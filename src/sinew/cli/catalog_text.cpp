#include <fmt/format.h>
#include <sinew/cli/catalog.hpp>

namespace sinew {

namespace {

/// "must be given" or "default 0.3".
std::string need_text(const ParameterDoc& doc) {
  if (doc.required) return "must be given";
  return doc.default_text.empty() ? "optional" : "default " + doc.default_text;
}

std::string parameter_text(const ParameterDoc& doc) {
  std::string text = fmt::format("  {}: {}", doc.name, doc.type);
  if (!doc.unit.empty()) text += " [" + doc.unit + "]";
  if (!doc.range.empty()) text += ", " + doc.range;
  return text + ", " + need_text(doc) + "\n      " + doc.sentence + "\n";
}

/// For a cell of a table.
std::string cell(const std::string& text) {
  std::string escaped;
  for (const char c : text) escaped += c == '|' ? "\\|" : std::string(1, c);
  return escaped;
}

std::string code_cell(const std::string& text) { return text.empty() ? "" : "`" + cell(text) + "`"; }

}  // namespace

std::string entry_text(const CatalogEntry& entry) {
  std::string text = entry.name + ": " + entry.sentence + "\n";
  if (!entry.source.empty()) text += "source: " + entry.source + "\n";
  for (const ParameterDoc& doc : entry.parameters) text += parameter_text(doc);
  return text;
}

std::string entry_markdown(const CatalogEntry& entry) {
  std::string text = "## `" + entry.name + "`\n\n" + entry.sentence + "\n\n";
  if (!entry.source.empty()) text += "Source: " + entry.source + "\n\n";
  if (entry.parameters.empty()) return text;
  text += "| key | type | unit | allowed | default | meaning |\n|---|---|---|---|---|---|\n";
  for (const ParameterDoc& doc : entry.parameters)
    text += fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", doc.name, cell(doc.type), cell(doc.unit), cell(doc.range),
                        doc.required ? "must be given" : code_cell(doc.default_text), cell(doc.sentence));
  return text + "\n";
}

std::string kind_markdown(const CatalogKind& kind) {
  std::string title = kind.name;
  title[0] = static_cast<char>(title[0] - 'a' + 'A');
  std::string text =
      "# " + title + "\n\nWritten by `sinew describe --all -o docs/reference`. In a case file: `" + kind.selector + "`.\n\n";
  if (kind.entries.empty()) text += "None yet.\n\n";
  for (const CatalogEntry& entry : kind.entries) text += entry_markdown(entry);
  text.pop_back();
  return text;
}

}  // namespace sinew
