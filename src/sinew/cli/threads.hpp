#pragma once
/// How many threads compute, and that it is one process.

#include <sinew/cli/options.hpp>

namespace sinew {

/// Sets the number of threads (0: what OMP_NUM_THREADS says, or all cores) and returns it. Throws CaseError for a number that is not
/// possible, and if more than one process is asked for, by -n or by a launcher of MPI.
int use_threads(const ComputeOptions& options);

}  // namespace sinew
