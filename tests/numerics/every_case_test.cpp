/// Every case of the repository gives the same bits on any number of threads, with and without a lattice path.

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <filesystem>
#include <sinew/neighbors/threads.hpp>
#include <vector>

#include "clouds.hpp"
#include "run_case.hpp"

namespace sinew {
namespace {

std::vector<std::string> case_files() {
  std::vector<std::string> files;
  for (const char* folder : {"examples", "validation"})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(std::string(SINEW_SOURCE_FOLDER) + "/" + folder))
      if (entry.path().extension() == ".toml" && entry.path().stem() != "reference") files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

class EveryCase : public ::testing::TestWithParam<std::string> {};

/// What steers a run, and all of its state.
std::vector<std::string> marks(const std::string& path, int threads) {
  omp_set_num_threads(threads);
  const Case c = make_case(read_toml_file(path), std::filesystem::path(path).parent_path().string());
  const auto simulation = Simulation::build(c);
  const int steps = c.solver.is_explicit() ? 5 : 1;
  std::vector<std::string> all;
  for (int k = 0; k < steps; ++k) simulation->step(1e300);
  const Energies e = simulation->energies();
  const Momenta m = simulation->momenta();
  for (double number : {simulation->time(), simulation->stable_time_step(), e.kinetic, e.strain, e.hourglass, e.external_work,
                        m.linear[0], m.linear[1], m.angular[2]})
    all.push_back(std::to_string(std::bit_cast<std::uint64_t>(number)));
  all.push_back(simulation->state_hash());
  return all;
}

TEST_P(EveryCase, SameBitsOnAnyNumberOfThreads) {
  const sinew::testing::BlockSize small(100);  // else small cases would have one block
  const int usual = fewest_for_threads;
  fewest_for_threads = 0;  // and use one thread, whatever is asked for
  const auto one = marks(GetParam(), 1);
  for (int threads : {2, 3, 4, 8}) EXPECT_EQ(marks(GetParam(), threads), one) << threads << " threads";
  fewest_for_threads = usual;
}

/// What a run writes to case.resolved.toml, and goes on from, is a case again.
TEST_P(EveryCase, ResolvesToACase) {
  const std::string folder = std::filesystem::path(GetParam()).parent_path().string();
  const Case c = make_case(read_toml_file(GetParam()), folder);
  EXPECT_NO_THROW(make_case(c.resolved, folder));
}

INSTANTIATE_TEST_SUITE_P(Repository, EveryCase, ::testing::ValuesIn(case_files()), [](const auto& file) {
  std::string name = std::filesystem::relative(file.param, SINEW_SOURCE_FOLDER).replace_extension().string();
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
  return name;
});

}  // namespace
}  // namespace sinew
