/// The same bits for any number of threads, and across a restart.

#include <gtest/gtest.h>
#include <omp.h>

#include "clouds.hpp"
#include "run_case.hpp"

namespace sinew {
namespace {

using namespace sinew::testing;

std::string hash_with(const std::string& text, int threads) {
  omp_set_num_threads(threads);
  const auto simulation = simulation_of(text);
  run_steps(*simulation, 20);
  return simulation->state_hash();
}

TEST(Determinism, SameBitsOnAnyNumberOfThreads) {
  const BlockSize small(1000);
  for (int dimension : {2, 3}) {
    std::string text = free_block(dimension);
    const auto at = text.find("spacing = 0.1");
    text.replace(at, 13, dimension == 2 ? "spacing = 0.01" : "spacing = 0.025");
    const std::string one = hash_with(text, 1);
    for (int threads : {2, 3, 4, 8}) EXPECT_EQ(hash_with(text, threads), one) << dimension << "D, " << threads << " threads";
  }
}

/// With blocks so small that the cases have several: otherwise the test would prove nothing.
TEST(Determinism, SeveralBlocks) {
  const BlockSize small(1000);
  std::string text = free_block(2);
  text.replace(text.find("spacing = 0.1"), 13, "spacing = 0.01");
  EXPECT_GE(simulation_of(text)->facts().blocks, 8);
}

/// Every ghost belongs to another block of the same body, and its force finds the way there.
TEST(Determinism, GhostsAreSpilledIntoTheirOwners) {
  const BlockSize small(300);
  const Cloud<2> cloud = make_cloud<2>(60, 0.3, 2.41, true, 2, 11);
  TotalLagrangian<2> solid(cloud.particles, cloud.radius, options<2>(material_with<NeoHookean>(1.0, 1.0, 0.3), 2));
  const Blocks& blocks = solid.pairs().blocks;
  ASSERT_GT(blocks.count(), 10);
  std::vector<int> seen(blocks.ghosts, 0);
  for (const Spill& spill : blocks.in) {
    const Block &from = blocks.all[spill.from], &to = blocks.all[spill.to];
    EXPECT_EQ(from.body, to.body);
    EXPECT_NE(spill.from, spill.to);
    for (int r = spill.first_run; r < spill.end_run; ++r) {
      const sinew::Run& run = blocks.runs[r];
      EXPECT_TRUE(r >= from.first_ghost && r < from.end_runs);
      EXPECT_TRUE(run.slot >= to.begin && run.slot + run.length <= to.end);
      for (int k = 0; k < run.length; ++k) {
        EXPECT_EQ(blocks.slots_of(from)[run.place + k], run.slot + k);
        ++seen[run.spill + k];
      }
    }
  }
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), blocks.ghosts);
}

TEST(Determinism, BlocksThatSeeTooMuchAreAnError) {
  const std::size_t usual = place_limit;
  place_limit = 400;
  try {
    const Cloud<2> cloud = make_cloud<2>(20, 0.3, 2.41, false, 1, 5);
    TotalLagrangian<2> solid(cloud.particles, cloud.radius, options<2>(material_with<NeoHookean>(1.0, 1.0, 0.3)));
    ADD_FAILURE() << "no error";
  } catch (const CaseError& error) {
    EXPECT_NE(std::string(error.what()).find("Make [formulation] support smaller"), std::string::npos) << error.what();
  }
  place_limit = usual;
}

TEST(Determinism, RestartGivesTheBitsOfARunThatNeverStopped) {
  const std::string text = free_block(2,
                                      "damping = 0.5\n[region]\nleft = { where = \"X < 0.2\" }\ntop = { where = \"Y > 0.95\" }\n"
                                      "[[boundary]]\nregion = \"left\"\nvelocity = [\"0.1*sin(50*t)\", 0]\n"
                                      "[[boundary]]\nregion = \"top\"\ntraction = [0, \"5*t\"]\n"
                                      "[body_force]\nacceleration = [0, -9.81]\n");
  const auto whole = simulation_of(text), first = simulation_of(text), second = simulation_of(text);
  run_steps(*whole, 40);
  run_steps(*first, 17);
  second->restore(first->save());
  run_steps(*second, 23);
  EXPECT_EQ(second->state_hash(), whole->state_hash());
  EXPECT_EQ(second->time(), whole->time());
  EXPECT_EQ(second->steps(), whole->steps());
  EXPECT_EQ(second->energies().external_work, whole->energies().external_work);
  EXPECT_EQ(second->energies().balance_error(), whole->energies().balance_error());
}

/// Looking at a run does not change it.
TEST(Determinism, ProbesAndSnapshotsLeaveTheBitsAlone) {
  const auto quiet = simulation_of(free_block(3)), watched = simulation_of(free_block(3));
  for (int k = 0; k < 10; ++k) {
    quiet->step(1e300);
    watched->step(1e300);
    watched->snapshot({"von_mises_stress", "displacement"});
    watched->expect_record();
    watched->energies();
  }
  EXPECT_EQ(quiet->state_hash(), watched->state_hash());
}

}  // namespace
}  // namespace sinew
