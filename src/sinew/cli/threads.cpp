#include <sinew/cli/threads.hpp>

#include <algorithm>
#include <cstdlib>
#include <omp.h>
#include <sinew/core/error.hpp>
#include <unistd.h>

namespace sinew {

namespace {

constexpr int most_threads = 4096;

/// Cores for the threads of this rank.
int own_cores(const Comm& comm) {
  const int usable = omp_get_num_procs();  // of the process: a launcher may have bound it to some
  const bool all_of_the_machine = usable == static_cast<int>(sysconf(_SC_NPROCESSORS_ONLN));
  return all_of_the_machine ? std::max(1, usable / comm.node_size()) : usable;
}

}  // namespace

int use_threads(const ComputeOptions& options, const Comm& comm) {
  if (options.ranks > 0 && options.ranks != comm.size())
    throw CaseError("-n asks for " + std::to_string(options.ranks) + " ranks, but " + std::to_string(comm.size()) +
                    " were started. Leave out -n under mpiexec or srun.");
  if (options.threads < 0 || options.threads > most_threads)
    throw CaseError("-t: " + std::to_string(options.threads) + " threads are not possible; allowed are 1 to " +
                    std::to_string(most_threads) + ", and 0 for all cores.");
  int threads = options.threads;
  if (threads == 0) threads = std::getenv("OMP_NUM_THREADS") ? omp_get_max_threads() : own_cores(comm);
  omp_set_dynamic(0);
  omp_set_num_threads(threads);
  return threads;
}

void let_idle_threads_sleep(char** arguments) {
  if (std::getenv("OMP_WAIT_POLICY") || std::getenv("GOMP_SPINCOUNT")) return;
  setenv("OMP_WAIT_POLICY", "passive", 1);
  execv("/proc/self/exe", arguments);  // returns only if it cannot be done: then go on as we are
}

}  // namespace sinew
