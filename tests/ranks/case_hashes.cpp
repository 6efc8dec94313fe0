/// Runs a few steps of every case of the repository, and of two that combine what those do not, on the ranks of mpiexec, in small blocks so that all have some, and prints a line for each: its name and what must not
/// depend on ranks or threads.

#include <omp.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <sinew/io/read_toml.hpp>
#include <sinew/model/simulation.hpp>
#include <sinew/neighbors/threads.hpp>
#include <sinew/particles/particles.hpp>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using namespace sinew;

std::vector<std::string> case_files() {
  std::vector<std::string> files;
  for (const char* folder : {"examples", "validation", "tests/ranks"})
    for (const auto& entry : fs::recursive_directory_iterator(std::string(SINEW_SOURCE_FOLDER) + "/" + folder))
      if (entry.path().extension() == ".toml" && entry.path().stem() != "reference") files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

/// Everything that steers a run, all of its sums, and all of its state. Equations are solved in another order on other ranks: those cases have none.
std::string mark_of(const std::string& path, const Comm& comm) {
  const Case c = make_case(read_toml_file(path), fs::path(path).parent_path().string());
  if (!c.solver.is_explicit()) return "solves equations";
  const auto simulation = Simulation::build(c, comm);
  for (int k = 0; k < 5; ++k) simulation->step(1e300);
  const Energies e = simulation->energies();
  const Momenta m = simulation->momenta();
  std::vector<double> numbers{simulation->time(), simulation->stable_time_step(),
                              e.kinetic,          e.strain,
                              e.hourglass,        e.external_work,
                              e.dissipated,       m.linear[0],
                              m.linear[1],        m.angular[2]};
  for (double value : simulation->probe_values()) numbers.push_back(value);
  std::uint64_t sums = 0;
  for (double number : numbers) sums = (sums ^ std::bit_cast<std::uint64_t>(number)) * 0x100000001b3ULL;
  char text[64];
  std::snprintf(text, sizeof text, "%s %016llx", simulation->state_hash().c_str(), static_cast<unsigned long long>(sums));
  return text;
}

}  // namespace

/// case_hashes THREADS
int main(int count, char** arguments) {
  const Comm comm = Comm::world();
  omp_set_num_threads(count > 1 ? std::stoi(arguments[1]) : 1);
  largest_block = 60;
  fewest_for_threads = 0;
  for (const std::string& path : case_files()) {
    const std::string mark = mark_of(path, comm);
    if (comm.root()) std::printf("%s %s\n", fs::relative(path, SINEW_SOURCE_FOLDER).c_str(), mark.c_str());
  }
  Comm::finalize();
  return 0;
}
