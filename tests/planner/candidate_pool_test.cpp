#include "candidate_pool.h"

#include <gtest/gtest.h>

namespace dbd {
namespace {

RouteDraft Straight(double y, double cost) {
  RouteDraft draft{"test", {}, cost, {}};
  for (double x = 0; x <= 100; x += 1) draft.poses.push_back({x, y, 0});
  return draft;
}

std::vector<double> CostsOf(CandidatePool pool) {
  std::vector<double> costs;
  for (const RouteDraft& draft : pool.TakeSorted()) costs.push_back(draft.cost);
  return costs;
}

TEST(CandidatePool, TakesRoutesThatDiffer) {
  CandidatePool pool(5);
  EXPECT_TRUE(pool.Offer(Straight(0, 10)));
  EXPECT_FALSE(pool.Offer(Straight(4, 11)));
  EXPECT_TRUE(pool.Offer(Straight(4, 11), 0.5));  // a share of the separation is enough
  EXPECT_TRUE(pool.Offer(Straight(10, 12)));
  EXPECT_EQ(pool.size(), 3);
}

TEST(CandidatePool, RoutesThatAreKnownAreNotTakenAgain) {
  CandidatePool pool(5);
  pool.AddKnown({{"test", Path({{0, 0}, {100, 0}}), 10}});
  EXPECT_FALSE(pool.Offer(Straight(3, 10)));
  EXPECT_TRUE(pool.Offer(Straight(6, 10)));
}

// More than twice the cheapest: only when nothing else is left.
TEST(CandidatePool, DearRoutesComeLast) {
  CandidatePool pool(5);
  EXPECT_TRUE(pool.Offer(Straight(0, 10)));
  EXPECT_FALSE(pool.Offer(Straight(40, 21)));
  EXPECT_FALSE(pool.Offer(Straight(2, 11)));    // a variant, 2 m off
  EXPECT_FALSE(pool.Offer(Straight(0.5, 12)));  // hardly a variant
  CandidatePool filled = pool;
  filled.FillUp(2);
  EXPECT_EQ(CostsOf(filled), (std::vector<double>{10, 11}));
  filled = pool;
  filled.FillUp(3);
  EXPECT_EQ(CostsOf(filled), (std::vector<double>{10, 11, 21}));
  filled = pool;
  filled.FillUp(9);
  EXPECT_EQ(CostsOf(filled), (std::vector<double>{10, 11, 12, 21}));
}

TEST(CandidatePool, NeverTakesTheSameTraceTwice) {
  CandidatePool pool(5);
  pool.Offer(Straight(0, 10));
  pool.Reserve(Straight(0, 10));
  pool.FillUp(2);
  EXPECT_EQ(pool.size(), 1);
}

}  // namespace
}  // namespace dbd
