#pragma once
/// `-n RANKS`: this program once more, as several ranks.

#include <string>
#include <vector>

namespace sinew {

/// The arguments (of main, without the name of the program) without -n / --ranks and its value.
std::vector<std::string> without_ranks(const std::vector<std::string>& arguments);

/// Starts this program with the arguments as that many ranks under mpiexec, not bound to cores, and waits. Ctrl-C and
/// a polite request to end reach all ranks, which then write a checkpoint. Returns the exit code. Throws CaseError if there is no
/// mpiexec.
int launch_ranks(int ranks, const std::vector<std::string>& arguments);

}  // namespace sinew
