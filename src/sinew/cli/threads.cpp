#include <sinew/cli/threads.hpp>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <omp.h>
#include <sinew/core/error.hpp>
#include <unistd.h>

namespace sinew {

namespace {

constexpr int most_threads = 4096;

/// Number of processes that a launcher of MPI (Open MPI, MPICH, Slurm) has started.
int launched_processes() {
  for (const char* variable : std::array{"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "SLURM_STEP_NUM_TASKS"})
    if (const char* text = std::getenv(variable)) return std::atoi(text);
  return 1;
}

}  // namespace

int use_threads(const ComputeOptions& options) {
  const int processes = std::max(options.ranks, launched_processes());
  if (processes > 1)
    throw CaseError("asked for " + std::to_string(processes) +
                    " processes, but this version computes in one process with threads: leave out -n and mpiexec, and choose the "
                    "number of threads with -t (default: all cores).");
  if (options.ranks < 1)
    throw CaseError("-n: " + std::to_string(options.ranks) + " processes are not possible; it can only be 1.");
  if (options.threads < 0 || options.threads > most_threads)
    throw CaseError("-t: " + std::to_string(options.threads) + " threads are not possible; allowed are 1 to " +
                    std::to_string(most_threads) + ", and 0 for all cores.");
  const int threads = options.threads == 0 ? omp_get_max_threads() : options.threads;
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
