#pragma once
/// The starter cases of `sinew new`.

#include <string>
#include <vector>

namespace sinew {

struct CaseTemplate {
  std::string name, sentence, text;
};

/// beam, pull, block3d: each runs as it is, in a few seconds.
const std::vector<CaseTemplate>& case_templates();

}  // namespace sinew
