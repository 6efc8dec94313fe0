#pragma once
/// What the command line asks for, verb by verb.

#include <sinew/cli/expect.hpp>
#include <string>
#include <vector>

namespace sinew {

/// Exit codes of the program.
enum ExitCode {
  done = 0,
  verification_failed = 1,
  wrong_input = 2,
  simulation_failed = 3,
  internal_error = 4,
  interrupted = 130
};

struct ComputeOptions {
  int threads = 0;  ///< 0: all cores
  int ranks = 0;    ///< 0: those that were started
};

struct RunOptions : ComputeOptions {
  std::string case_path, folder;  ///< folder empty: runs/NAME
  std::vector<std::string> overrides;
  bool force = false, quiet = false;
  std::string picture;
  Tier tier = Tier::full;
};

struct ResumeOptions : ComputeOptions {
  std::string folder;
  std::vector<std::string> overrides;
  bool quiet = false;
};

struct CheckOptions : ComputeOptions {
  std::vector<int> plan;  ///< numbers of ranks to plan for
  std::string case_path;
  std::vector<std::string> overrides;
};

struct VerifyOptions : ComputeOptions {
  std::vector<std::string> paths;
  Tier tier = Tier::quick;
  std::string json, folder = "runs/verify";
  int jobs = 1;
};

struct DescribeOptions {
  std::string name, folder;
  bool all = false, markdown = false;
};

struct NewOptions {
  std::string name = "beam", file;
};

// The verbs. Each returns an exit code and throws CaseError for input that is wrong.
int run_verb(const RunOptions& options);
int resume_verb(const ResumeOptions& options);
int check_verb(const CheckOptions& options);
int verify_verb(const VerifyOptions& options);
int list_verb(const std::string& kind);
int describe_verb(const DescribeOptions& options);
int new_verb(const NewOptions& options);

}  // namespace sinew
