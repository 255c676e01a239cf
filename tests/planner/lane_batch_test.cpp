#include "lane_batch.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace dbd {
namespace {

std::vector<std::size_t> OrderOf(const std::vector<double>& lengths, std::size_t lanes,
                                 bool best_first) {
  std::vector<Path> paths;
  for (const double length : lengths) paths.emplace_back(Path({{0, 0}, {length, 0}}));
  std::vector<DriveTask> tasks(paths.size());
  for (std::size_t i = 0; i < paths.size(); ++i) tasks[i].path = &paths[i];
  return StartingOrder(tasks, lanes, best_first);
}

TEST(StartingOrder, TheLongestBegin) {
  using Order = std::vector<std::size_t>;
  EXPECT_EQ(OrderOf({5, 9, 7, 6, 7, 2}, 2, false), (Order{1, 2, 4, 3, 0, 5}));
  EXPECT_EQ(OrderOf({5, 9}, 3, false), (Order{1, 0}));
  EXPECT_EQ(OrderOf({}, 3, false), Order{});
}

TEST(StartingOrder, BestFirstOnlyTheLastOnEachLaneBeginWithTheLongest) {
  using Order = std::vector<std::size_t>;
  EXPECT_EQ(OrderOf({5, 9, 7, 6, 8, 2}, 2, true), (Order{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(OrderOf({5, 9, 7, 6, 2, 8}, 2, true), (Order{0, 1, 2, 3, 5, 4}));
  EXPECT_EQ(OrderOf({5, 9, 6, 7, 2, 7}, 3, true), (Order{0, 1, 2, 3, 5, 4}));
  EXPECT_EQ(OrderOf({5, 9, 6, 7}, 3, true), (Order{0, 1, 2, 3}));
  EXPECT_EQ(OrderOf({5, 9}, 3, true), (Order{0, 1}));
  EXPECT_EQ(OrderOf({}, 3, true), Order{});
}

TEST(DriveQueue, GivesEachTaskOnceInItsOrder) {
  std::vector<DriveTask> tasks(3);
  std::vector<Rollout> rollouts(3);
  DriveQueue queue{tasks, {2, 0, 1}, rollouts, {}, {}};
  EXPECT_EQ(queue.TakeNext(), 2);
  EXPECT_EQ(queue.TakeNext(), 0);
  EXPECT_EQ(queue.TakeNext(), 1);
  EXPECT_EQ(queue.TakeNext(), std::nullopt);
  EXPECT_EQ(queue.TakeNext(), std::nullopt);
}

}  // namespace
}  // namespace dbd
