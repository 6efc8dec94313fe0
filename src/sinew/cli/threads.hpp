#pragma once
/// How many threads compute, and that it is one process.

#include <sinew/cli/options.hpp>

namespace sinew {

/// Sets the number of threads (0: what OMP_NUM_THREADS says, or all cores) and returns it. Throws CaseError for a number that is not
/// possible, and if more than one process is asked for, by -n or by a launcher of MPI.
int use_threads(const ComputeOptions& options);

/// Lets idle threads sleep instead of spin, unless the user chose otherwise. The OpenMP runtime reads that once, when the program is loaded, so
/// the program starts itself again with the choice in its environment. On a busy machine spinning threads take the cores from the working ones: a
/// step was measured to become up to 20 times slower.
void let_idle_threads_sleep(char** arguments);

}  // namespace sinew
