#pragma once
/// What this program is.

#include <string>

namespace sinew {

std::string program_version();   ///< "0.1.0"
std::string program_commit();    ///< of git when it was built, with "-dirty" if files were changed; "unknown" without git
std::string vector_registers();  ///< "AVX-512", "AVX2", ...: what the compiler was allowed to use
std::string version_text();      ///< several lines: version, commit, compiler, libraries, vector registers

}  // namespace sinew
