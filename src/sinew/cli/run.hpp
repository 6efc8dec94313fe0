#pragma once
/// `sinew run`: one case, or all runs of a study.

#include <memory>
#include <sinew/cli/case_input.hpp>
#include <sinew/cli/case_run.hpp>

namespace sinew {

struct RunPlan {
  std::string folder;
  bool force = false, quiet = false;
  std::string label;  ///< before each line of progress
  RunControl control;
};

/// Of the first rank; those of the others say nothing. Collective.
std::unique_ptr<Reporter> make_reporter(const Comm& comm, const RunFolder& folder, bool quiet, const std::string& label = "");

/// Builds and runs it in a new folder. A case that is wrong (CaseError) leaves nothing behind.
RunResult run_case(const Case& c, const RunPlan& plan);

/// All combinations of [study], in NNN_name=value folders of plan.folder, with study.csv and summary.json beside them. A run that
/// fails does not stop the others. Returns the exit code.
int run_study(const CaseInput& input, const Case& c, const RunPlan& plan);

/// One run of a study.
struct StudyPoint {
  std::vector<std::pair<std::string, double>> values;
  std::string folder_name;  ///< "001_n=4"
};
/// All combinations, the first key varies slowest. In the quick tier those that no row of [[expect]] needs are left out.
std::vector<StudyPoint> study_points(const Case& c, Tier tier);

}  // namespace sinew
