#pragma once
/// A case file with the overrides of the command line.

#include <sinew/core/node.hpp>
#include <string>
#include <utility>
#include <vector>

namespace sinew {

struct CaseInput {
  Node root;
  std::string folder;  ///< that file names in the case are relative to
};

/// Reads the file and puts each "key.path=value" into it. Throws CaseError.
CaseInput read_case_input(const std::string& path, const std::vector<std::string>& overrides);

/// The same case with other values at the given key paths, and without [study] and [[expect]]: one run of a study.
Node study_member(const Node& root, const std::vector<std::pair<std::string, double>>& values);

}  // namespace sinew
