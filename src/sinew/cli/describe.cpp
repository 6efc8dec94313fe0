#include <filesystem>
#include <fmt/format.h>
#include <sinew/cli/catalog.hpp>
#include <sinew/cli/options.hpp>
#include <sinew/io/file.hpp>

namespace sinew {

namespace {

std::vector<std::string> kind_names() {
  std::vector<std::string> names;
  for (const CatalogKind& kind : catalog()) names.push_back(kind.name);
  return names;
}

void print_kind(const CatalogKind& kind) {
  fmt::print("{}  ({})\n", kind.name, kind.selector);
  if (kind.entries.empty()) fmt::print("  none yet\n");
  for (const CatalogEntry& entry : kind.entries) fmt::print("  {:<30} {}\n", entry.name, entry.sentence);
}

/// Prints every entry of that name (a name may be a kind, too); false if there is none.
bool print_named(const std::string& name, bool markdown) {
  bool found = false;
  for (const CatalogKind& kind : catalog())
    for (const CatalogEntry& entry : kind.entries) {
      if (kind.name != name && entry.name != name) continue;
      fmt::print("{}{}", found && !markdown ? "\n" : "", markdown ? entry_markdown(entry) : entry_text(entry));
      found = true;
    }
  return found;
}

void write_pages(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw CaseError("cannot make the folder " + folder + ": " + error.message());
  for (const CatalogKind& kind : catalog()) {
    write_atomically(folder + "/" + kind.name + ".md", kind_markdown(kind));
    fmt::print("{}/{}.md\n", folder, kind.name);
  }
}

[[noreturn]] void fail_unknown(const std::string& name) {
  std::vector<std::string> names = kind_names();
  for (const CatalogKind& kind : catalog())
    for (const CatalogEntry& entry : kind.entries) names.push_back(entry.name);
  throw CaseError(unknown_name_message("name", name, names));
}

}  // namespace

int list_verb(const std::string& kind_name) {
  bool found = false;
  for (const CatalogKind& kind : catalog()) {
    if (!kind_name.empty() && kind.name != kind_name) continue;
    if (found) fmt::print("\n");
    print_kind(kind);
    found = true;
  }
  if (!found) throw CaseError(unknown_name_message("kind", kind_name, kind_names()));
  return done;
}

int describe_verb(const DescribeOptions& options) {
  if (options.all) {
    if (!options.folder.empty()) {
      write_pages(options.folder);
      return done;
    }
    for (const CatalogKind& kind : catalog()) {
      if (options.markdown)
        fmt::print("{}\n", kind_markdown(kind));
      else
        for (const CatalogEntry& entry : kind.entries) fmt::print("{}\n", entry_text(entry));
    }
    return done;
  }
  if (!options.folder.empty()) throw CaseError("describe: -o writes the whole reference; give it together with --all");
  if (options.name.empty()) throw CaseError("describe: give a name, or --all. `sinew list` shows the names.");
  if (!print_named(options.name, options.markdown)) fail_unknown(options.name);
  return done;
}

}  // namespace sinew
