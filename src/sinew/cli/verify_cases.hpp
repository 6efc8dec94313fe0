#pragma once
/// Which cases `sinew verify` runs, and the rows that come out.

#include <sinew/cli/expect.hpp>
#include <string>
#include <vector>

namespace sinew {

/// A case with expected values.
struct VerifyCase {
  std::string path, name;
  std::string problem;   ///< why it cannot be run: an error of the case file
  int skipped_rows = 0;  ///< rows that the tier leaves out
  bool skipped = false;  ///< the whole case is left out
};

/// What became of it.
struct VerifyResult {
  std::vector<ExpectSummary> rows;
  std::string problem;  ///< why there are no rows
  double seconds = 0.0;
};

/// Each path a case file, or a folder in which all *.toml files with a [case] and [[expect]] count (reference.toml never does).
/// Sorted by path; equal names get a number. CaseError for a path that is not there or holds no case.
std::vector<VerifyCase> find_verify_cases(const std::vector<std::string>& paths, Tier tier);

/// The table, without the closing line.
std::string verify_table(const std::vector<VerifyCase>& cases, const std::vector<VerifyResult>& results);

/// The rows as JSON: { "rows": [ { "case", "quantity", "published", "computed", "tolerance", "absolute", "pass", ... } ], ... }.
std::string verify_json(const std::vector<VerifyCase>& cases, const std::vector<VerifyResult>& results);

/// Rows passed, failed (a case without rows counts as one), skipped.
struct VerifyCounts {
  int passed = 0, failed = 0, skipped = 0;
};
VerifyCounts count_rows(const std::vector<VerifyCase>& cases, const std::vector<VerifyResult>& results);

}  // namespace sinew
