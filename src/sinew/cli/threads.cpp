#include <sinew/cli/threads.hpp>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <omp.h>
#include <sched.h>
#include <sinew/core/error.hpp>
#include <unistd.h>

namespace sinew {

namespace {

constexpr int most_threads = 4096;

/// A number for the machine and the cores of it that this process may use: equal for ranks that share them.
int cores_mark() {
  cpu_set_t cores;
  CPU_ZERO(&cores);
  sched_getaffinity(0, sizeof cores, &cores);
  char machine[256] = {};
  gethostname(machine, sizeof machine - 1);
  std::string all(machine);
  for (int k = 0; k < CPU_SETSIZE; ++k) all += CPU_ISSET(k, &cores) ? '1' : '0';
  return static_cast<int>(std::hash<std::string>{}(all));
}

/// Cores for the threads of this rank: those that it may use, shared with the ranks that may use the same. A launcher may have bound it to some.
int own_cores(const Comm& comm) {
  const int mark = cores_mark();
  const std::vector<int> marks = comm.gather_all(std::span<const int>(&mark, 1));
  const auto sharing = static_cast<int>(std::count(marks.begin(), marks.end(), mark));
  return std::max(1, omp_get_num_procs() / sharing);
}

/// Processes that srun has started without telling them of each other would all do the whole work.
void check_launcher(const Comm& comm) {
  const char* tasks = std::getenv("SLURM_STEP_NUM_TASKS");
  if (tasks && std::atoi(tasks) > 1 && comm.alone() && !Comm::launched())
    throw CaseError("srun has started " + std::string(tasks) +
                    " processes that do not know of each other. Start them with srun --mpi=pmix, or with mpiexec.");
}

void check_options(const ComputeOptions& options, const Comm& comm) {
  check_launcher(comm);
  if (options.ranks > 0 && options.ranks != comm.size())
    throw CaseError("-n asks for " + std::to_string(options.ranks) + " ranks, but " + std::to_string(comm.size()) +
                    " were started. Leave out -n under mpiexec or srun.");
  if (options.threads < 0 || options.threads > most_threads)
    throw CaseError("-t: " + std::to_string(options.threads) + " threads are not possible; allowed are 1 to " +
                    std::to_string(most_threads) + ", and 0 for all cores.");
}

}  // namespace

int use_threads(const ComputeOptions& options, const Comm& comm) {
  comm.together([&] { check_options(options, comm); });
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
