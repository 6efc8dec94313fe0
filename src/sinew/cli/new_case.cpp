#include <cstdio>
#include <filesystem>
#include <fmt/format.h>
#include <sinew/cli/options.hpp>
#include <sinew/cli/templates.hpp>
#include <sinew/core/error.hpp>
#include <sinew/io/file.hpp>

namespace sinew {

int new_verb(const NewOptions& options) {
  std::vector<std::string> names;
  for (const CaseTemplate& entry : case_templates()) {
    names.push_back(entry.name);
    if (entry.name != options.name) continue;
    const std::string file = options.file.empty() ? entry.name + ".toml" : options.file;
    std::error_code ignored;
    if (std::filesystem::exists(file, ignored))
      throw CaseError("new: " + file + " is there already and is left as it is. Choose another name with -o.");
    write_atomically(file, entry.text);
    fmt::print("wrote {} ({})\ntry: sinew check {}\n     sinew run {}\n", file, entry.sentence, file, file);
    return done;
  }
  throw CaseError(unknown_name_message("template", options.name, names));
}

}  // namespace sinew
