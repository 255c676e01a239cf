#include <dbd/planner/extra_cost.h>
#include <gtest/gtest.h>

namespace dbd {
namespace {

ExtraCost Blank() { return ExtraCost({-10, -20}, {90, 60}, 1.0); }

double Crossing(const ExtraCost& cost, double y, double from, double to) {
  double seconds = 0;
  constexpr double kStep = 0.05;
  for (double x = from; x < to; x += kStep) seconds += kStep * cost.SecondsPerMetre(x, y);
  return seconds;
}

TEST(ExtraCost, IsNothingAtFirstAndOutside) {
  ExtraCost cost = Blank();
  cost.AddCone({-10, -20}, 15, 60);
  EXPECT_EQ(Blank().SecondsPerMetre(0, 0), 0);
  EXPECT_GT(cost.SecondsPerMetre(-9, -19), 0);
  EXPECT_EQ(cost.SecondsPerMetre(-10.5, -19), 0);
  EXPECT_EQ(cost.SecondsPerMetre(500, 500), 0);
}

// A triangle of base 2 r and height h = seconds / r has the area `seconds`.
TEST(ExtraCost, ConeCostsItsSecondsThroughTheMiddleAndLessBesideIt) {
  ExtraCost cost = Blank();
  cost.AddCone({30, 10}, 12, 60);
  EXPECT_NEAR(cost.SecondsPerMetre(30, 10), 60.0 / 12, 0.3);  // cells round the tip off
  EXPECT_NEAR(Crossing(cost, 10, 10, 50), 60, 1);
  EXPECT_LT(Crossing(cost, 18, 10, 50), 20);
  EXPECT_EQ(Crossing(cost, 24, 10, 50), 0);
}

TEST(ExtraCost, AddedConesAddUpAndRaisedOnesDoNot) {
  ExtraCost added = Blank(), raised = Blank();
  for (int i = 0; i < 3; ++i) {
    added.AddCone({30, 10}, 12, 20);
    raised.RaiseToCone({30, 10}, 12, 20);
  }
  EXPECT_NEAR(Crossing(added, 10, 10, 50), 60, 1);
  EXPECT_NEAR(Crossing(raised, 10, 10, 50), 20, 0.5);
  added.Add(raised);
  EXPECT_NEAR(Crossing(added, 10, 10, 50), 80, 1.5);
}

}  // namespace
}  // namespace dbd
