/// The user's order, in pieces. How ranks exchange them is tested in tests/ranks.

#include <gtest/gtest.h>

#include <sinew/parallel/user_order.hpp>

namespace sinew {
namespace {

TEST(UserRange, PiecesFollowEachOther) {
  for (const std::size_t total : {0, 1, 5, 64, 1000})
    for (const int ranks : {1, 2, 3, 7}) {
      std::size_t next = 0;
      for (int r = 0; r < ranks; ++r) {
        const UserRange range = user_range(total, r, ranks);
        EXPECT_EQ(range.first, next);
        EXPECT_EQ(range.leads, r == 0);
        EXPECT_EQ(range.rows(), range.count + (range.first + range.count < total));
        EXPECT_LE(range.count, total / ranks + 1);
        next += range.count;
      }
      EXPECT_EQ(next, total);
    }
}

TEST(UserOrder, OfAProcessAlone) {
  const UserOrder order(Comm(), {2, 0, -1, 1});
  EXPECT_EQ(order.slots(), (std::vector<int>{0, 1, 3}));
  const std::vector<double> rows{20, 21, 0, 1, 10, 11};
  const std::vector<double> sorted = order.to_range(rows, 2);
  EXPECT_EQ(sorted, (std::vector<double>{0, 1, 10, 11, 20, 21}));
  EXPECT_EQ(order.from_range(sorted, 2), rows);
  EXPECT_EQ(order.whole(sorted, 2), sorted);
}

TEST(SumOverBlocks, OfAProcessAlone) {
  const std::vector<int> blocks{0, 1, 2};
  const std::vector<double> partial{1, 10, 2, 20, 3, 30};
  EXPECT_EQ(sum_over_blocks(Comm(), blocks, partial, 2), (std::vector<double>{6, 60}));
}

}  // namespace
}  // namespace sinew
