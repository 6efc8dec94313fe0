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
  for (int dimension : {2, 3}) {
    std::string text = free_block(dimension);
    const auto at = text.find("spacing = 0.1");
    text.replace(at, 13, dimension == 2 ? "spacing = 0.01" : "spacing = 0.025");
    const std::string one = hash_with(text, 1);
    for (int threads : {2, 3, 4, 8}) EXPECT_EQ(hash_with(text, threads), one) << dimension << "D, " << threads << " threads";
  }
}

/// The case above has several chunks: otherwise the test would prove nothing.
TEST(Determinism, SeveralChunksOfBothStreams) {
  std::string text = free_block(2);
  text.replace(text.find("spacing = 0.1"), 13, "spacing = 0.01");
  EXPECT_GE(simulation_of(text)->facts().chunks, 4);
}

/// Chunks of one stream never write the same row.
TEST(Determinism, ChunksOfOneStreamDoNotMeet) {
  const Cloud<2> cloud = make_cloud<2>(100, 0.3, 2.41, true, 2, 11);
  const TotalLagrangian<2> solid(cloud.particles, cloud.radius, options<2>(material_with<NeoHookean>(1.0, 1.0, 0.3), 2));
  ASSERT_GT(solid.chunks().size(), 4u);
  std::vector<int> owner[2] = {std::vector<int>(cloud.particles.slots, -1), std::vector<int>(cloud.particles.slots, -1)};
  for (std::size_t c = 0; c < solid.chunks().size(); ++c) {
    const Chunk& chunk = solid.chunks()[c];
    for (int slot = lanes * chunk.first_slice; slot < lanes * chunk.end_slice; ++slot)
      for (int j : solid.neighbors(slot)) {
        int& who = owner[chunk.stream][j];
        EXPECT_TRUE(who == -1 || who == static_cast<int>(c));
        who = static_cast<int>(c);
      }
  }
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
    watched->energies();
  }
  EXPECT_EQ(quiet->state_hash(), watched->state_hash());
}

}  // namespace
}  // namespace sinew
