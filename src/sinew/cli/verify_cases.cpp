#include <sinew/cli/verify_cases.hpp>

#include <algorithm>
#include <filesystem>
#include <map>
#include <sinew/cli/case_input.hpp>
#include <sinew/core/error.hpp>

namespace sinew {

namespace {

namespace fs = std::filesystem;

bool is_candidate(const fs::path& path) { return path.extension() == ".toml" && path.filename() != "reference.toml"; }

/// The candidates below a folder, without hidden folders.
std::vector<std::string> toml_files(const std::string& folder) {
  std::vector<std::string> files;
  for (auto entry = fs::recursive_directory_iterator(folder); entry != fs::recursive_directory_iterator(); ++entry) {
    const bool hidden = entry->path().filename().string().starts_with(".");
    if (entry->is_directory() && hidden) entry.disable_recursion_pending();
    if (!hidden && entry->is_regular_file() && is_candidate(entry->path())) files.push_back(entry->path().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Nothing for a file that is no case with expected values; a file that cannot be understood is a case with a problem.
std::optional<VerifyCase> read_verify_case(const std::string& path, Tier tier) {
  VerifyCase found{path, fs::path(path).stem().string(), "", 0, false};
  try {
    const CaseInput input = read_case_input(path, {});
    if (!input.root.find("case") || !input.root.find("expect")) return std::nullopt;
    const Case c = make_case(input.root, input.folder);
    found.name = c.general.name;
    const auto wanted = [&](const ExpectCase& expect) { return included(expect, tier); };
    const auto rows = static_cast<int>(std::count_if(c.expects.begin(), c.expects.end(), wanted));
    found.skipped = (tier == Tier::quick && c.general.tier == "full") || rows == 0;
    found.skipped_rows = static_cast<int>(c.expects.size()) - (found.skipped ? 0 : rows);
  } catch (const CaseError& error) {
    found.problem = error.what();
  }
  return found;
}

void number_equal_names(std::vector<VerifyCase>& cases) {
  std::map<std::string, int> used;
  for (VerifyCase& c : cases)
    if (const int count = ++used[c.name]; count > 1) c.name += "_" + std::to_string(count);
}

}  // namespace

std::vector<VerifyCase> find_verify_cases(const std::vector<std::string>& paths, Tier tier) {
  std::vector<VerifyCase> cases;
  for (const std::string& path : paths) {
    std::error_code ignored;
    if (!fs::exists(path, ignored)) throw CaseError("verify: there is no file or folder " + path + ".");
    const bool folder = fs::is_directory(path);
    const std::size_t before = cases.size();
    for (const std::string& file : folder ? toml_files(path) : std::vector{path})
      if (std::optional<VerifyCase> found = read_verify_case(file, tier)) cases.push_back(std::move(*found));
    if (cases.size() == before)
      throw CaseError("verify: " + path + (folder ? " holds no case" : " is no case") + " with [case] and [[expect]].");
  }
  number_equal_names(cases);
  return cases;
}

VerifyCounts count_rows(const std::vector<VerifyCase>& cases, const std::vector<VerifyResult>& results) {
  VerifyCounts counts;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    counts.skipped += cases[i].skipped_rows;
    if (!results[i].problem.empty()) ++counts.failed;
    for (const ExpectSummary& row : results[i].rows) ++(row.pass ? counts.passed : counts.failed);
  }
  return counts;
}

}  // namespace sinew
