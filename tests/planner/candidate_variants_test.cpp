#include "candidate_variants.h"

#include <dbd/planner/polyline_separation.h>
#include <gtest/gtest.h>

#include "candidate_test_terrain.h"

namespace dbd {
namespace {

class VaryBestTest : public testing::Test {
 protected:
  void Add(double y, Outcome outcome, double progress, double total) {
    candidates_.push_back({"roadmap", Path({{10, y}, {190, y}}), 30});
    Rollout rollout;
    rollout.outcome = outcome;
    rollout.progress = progress;
    rollout.place = {10 + 180 * progress, y, 0};
    rollout.margins = {{"shock", 2.5, 2.0, 0.2, 90, {100, y}}};
    for (double s = 0; s <= 180 * progress; s += 1) {
      TraceSample sample;
      sample.s = s;
      sample.x = 10 + s;
      sample.y = y;
      sample.speed = 6;
      rollout.trace.push_back(sample);
    }
    rollouts_.push_back(rollout);
    Score score;
    score.feasible = outcome == Outcome::kReached;
    if (score.feasible) score.total = total;
    scores_.push_back(score);
  }

  std::vector<Candidate> Vary(int count, std::uint64_t seed = 1) const {
    return VaryBest(layer_, *TestVehicle(), {candidates_, rollouts_, scores_}, count, seed);
  }

  Terrain terrain_ = SurfaceTerrain(201, 101, 1, [](double, double) { return 0.0; });
  TrafficabilityLayer layer_{terrain_, *TestVehicle(), 8.0};
  std::vector<Candidate> candidates_;
  std::vector<Rollout> rollouts_;
  std::vector<Score> scores_;
};

TEST_F(VaryBestTest, VariesTheBestAndKeepsItsEnds) {
  Add(30, Outcome::kReached, 1, 60);
  Add(70, Outcome::kReached, 1, 50);
  const std::vector<Candidate> variants = Vary(8);
  EXPECT_GE(variants.size(), 6u);
  int of_best = 0;
  for (const Candidate& variant : variants) {
    const std::vector<Eigen::Vector2d>& points = variant.path.points();
    const bool is_of_best = points.front() == Eigen::Vector2d(10, 70);
    const double y = is_of_best ? 70 : 30;
    of_best += is_of_best;
    EXPECT_EQ(points.front(), Eigen::Vector2d(10, y));
    EXPECT_EQ(points.back(), Eigen::Vector2d(190, y));
    for (const Eigen::Vector2d& point : points) EXPECT_LE(std::abs(point.y() - y), 5);
    EXPECT_TRUE(variant.origin.starts_with("roadmap+"));
    EXPECT_GT(variant.layer_cost, 0);
  }
  EXPECT_GE(2 * of_best, static_cast<int>(variants.size()));
}

TEST_F(VaryBestTest, BendsCanBeSteeredAndDiffer) {
  Add(50, Outcome::kReached, 1, 60);
  const double sharpest = 1.05 / TestVehicle()->min_turning_radius();
  const std::vector<Candidate> variants = Vary(6);
  for (const Candidate& variant : variants) {
    for (double s = 0; s < variant.path.length(); s += 0.5) {
      EXPECT_LE(std::abs(variant.path.Curvature(s, 1.5)), 1.05 * sharpest);
    }
  }
  for (std::size_t i = 2; i < variants.size(); ++i) {
    EXPECT_GT(Separation(variants[i].path.points(), variants[1].path.points()), 0);
  }
}

// 30 % slower than the 6 m/s at the tight place, from 15 m before to 5 m behind x = 100, which is
// s = 90.
TEST_F(VaryBestTest, SlowsDownBeforeATightPlace) {
  Add(50, Outcome::kReached, 1, 60);
  const Candidate first = Vary(1).at(0);
  EXPECT_EQ(first.origin, "roadmap+slower");
  ASSERT_EQ(first.speed_caps.size(), 1u);
  EXPECT_DOUBLE_EQ(first.speed_caps[0].from, 75);
  EXPECT_DOUBLE_EQ(first.speed_caps[0].to, 95);
  EXPECT_DOUBLE_EQ(first.speed_caps[0].speed, 4.2);
}

TEST_F(VaryBestTest, SlowsDownOnlyOnce) {
  Add(50, Outcome::kReached, 1, 60);
  const Candidate slower = Vary(1).at(0);
  Add(50, Outcome::kReached, 1, 62);
  candidates_.back() = slower;
  for (const Candidate& variant : Vary(4)) {
    if (variant.path.points() != slower.path.points()) continue;
    EXPECT_EQ(variant.speed_caps.size(), 2u);  // of the slower one itself
  }
}

TEST_F(VaryBestTest, WithoutSuccessVariesWhatCameFarthest) {
  Add(30, Outcome::kImmobilized, 0.2, 0);
  Add(50, Outcome::kCollided, 0.7, 0);
  for (const Candidate& variant : Vary(1)) EXPECT_EQ(variant.path.Position(0).y(), 50);
}

TEST_F(VaryBestTest, IsTheSameForTheSameSeed) {
  Add(50, Outcome::kReached, 1, 60);
  const std::vector<Candidate> one = Vary(5), again = Vary(5), other = Vary(5, 2);
  ASSERT_EQ(one.size(), again.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].path.points(), again[i].path.points());
  }
  EXPECT_NE(one[1].path.points(), other[1].path.points());
}

}  // namespace
}  // namespace dbd
