#include "candidate_correction.h"

#include <gtest/gtest.h>

#include "candidate_test_terrain.h"

namespace dbd {
namespace {

class CorrectCollidedTest : public testing::Test {
 protected:
  /// A drive eastwards along `candidate` that lies `aside` to the left of y = 50, from x = 20 on.
  void Add(Candidate candidate, double aside, Outcome outcome, double until = 100) {
    const auto vehicle = TestVehicle();
    const double ahead = vehicle->bodies[0].p_RB.x() - vehicle->path_point_x();  // of the body
    Rollout rollout;
    rollout.outcome = outcome;
    for (double x = 10; x <= until; x += 1) {
      TraceSample row;
      row.x = x + ahead;
      row.y = 50 + (x < 20 ? aside * (x - 10) / 10 : aside);
      rollout.trace.push_back(row);
    }
    candidates_.push_back(std::move(candidate));
    rollouts_.push_back(rollout);
    scores_.emplace_back();
  }

  static Candidate Straight(double layer_cost) {
    return {"roadmap", Path({{10, 50}, {110, 50}}), layer_cost};
  }

  std::vector<Candidate> Correct(int most = 8) const {
    return CorrectCollided(*TestVehicle(), {candidates_, rollouts_, scores_}, most);
  }

  static double YAt(const Path& path, double x) {
    return path.Position(path.NearestArcLength({x, 50}, 0, path.length())).y();
  }

  std::vector<Candidate> candidates_;
  std::vector<Rollout> rollouts_;
  std::vector<Score> scores_;
};

TEST_F(CorrectCollidedTest, MovesThePathToTheOtherSide) {
  Add(Straight(30), 0.4, Outcome::kCollided);
  const Candidate corrected = Correct().at(0);
  EXPECT_EQ(corrected.origin, "roadmap+corrected");
  EXPECT_EQ(corrected.meant.points(), candidates_[0].path.points());
  EXPECT_EQ(corrected.path.points().front(), Eigen::Vector2d(10, 50));
  EXPECT_EQ(corrected.path.points().back(), Eigen::Vector2d(110, 50));
  EXPECT_NEAR(YAt(corrected.path, 15), 49.8, 2e-3);
  EXPECT_NEAR(YAt(corrected.path, 60), 49.6, 1e-6);
}

// Where nothing was driven any more, the last deviation fades away over 6 m.
TEST_F(CorrectCollidedTest, LeavesWhatWasNotDriven) {
  Add(Straight(30), 0.4, Outcome::kCollided, 60);
  const Path path = Correct().at(0).path;
  EXPECT_NEAR(YAt(path, 63), 49.8, 2e-3);
  EXPECT_NEAR(YAt(path, 70), 50, 1e-9);
}

// The second drive is half as far off: its correction goes on from the first one.
TEST_F(CorrectCollidedTest, GoesOnFromACorrection) {
  Add(Straight(30), 0.4, Outcome::kCollided);
  Add(Correct().at(0), 0.2, Outcome::kCollided);
  const std::vector<Candidate> again = Correct();
  ASSERT_EQ(again.size(), 1u);  // the first drive has had its turn
  EXPECT_EQ(again[0].origin, "roadmap+corrected");
  EXPECT_EQ(again[0].meant.points(), candidates_[0].path.points());
  EXPECT_NEAR(YAt(again[0].path, 60), 49.4, 1e-6);
}

TEST_F(CorrectCollidedTest, TakesTheCheapestThatTouchedSomething) {
  Add(Straight(30), 0.4, Outcome::kReached);
  Candidate other{"roadmap", Path({{10, 50}, {110, 50.001}}), 20};
  Add(other, 0.4, Outcome::kCollided);
  other = {"abit-star", Path({{10, 50}, {110, 50.002}}), 10};
  Add(other, 0.4, Outcome::kCollided);
  EXPECT_EQ(Correct().size(), 2u);
  const std::vector<Candidate> one = Correct(1);
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(one[0].origin, "abit-star+corrected");
  EXPECT_EQ(one[0].layer_cost, 10);
}

TEST_F(CorrectCollidedTest, HasNothingToDoOnTheWay) {
  Add(Straight(30), 0.01, Outcome::kCollided);
  EXPECT_TRUE(Correct().empty());
}

}  // namespace
}  // namespace dbd
