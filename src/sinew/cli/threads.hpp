#pragma once
/// How many threads compute.

#include <sinew/cli/options.hpp>
#include <sinew/parallel/comm.hpp>

namespace sinew {

/// Sets the number of threads of this rank and returns it. 0: what OMP_NUM_THREADS says, or the cores that this rank may use; those that several ranks
/// may use are shared. Throws CaseError for a number that is not possible, if -n asks for other ranks than there are, and for ranks that do not know of each
/// other. Collective.
int use_threads(const ComputeOptions& options, const Comm& comm);

/// Lets idle threads sleep instead of spin, unless the user chose otherwise. The OpenMP runtime reads that once, when the program is loaded, so
/// the program starts itself again with the choice in its environment. On a busy machine spinning threads take the cores from the working ones: a
/// step was measured to become up to 20 times slower.
void let_idle_threads_sleep(char** arguments);

}  // namespace sinew
