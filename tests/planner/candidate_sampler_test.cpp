#include <dbd/core/error.h>
#include <dbd/planner/candidate_sampler.h>
#include <dbd/planner/polyline_separation.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include <tbb/global_control.h>

#include "candidate_test_terrain.h"

namespace dbd {
namespace {

using testing::AllOf;
using testing::HasSubstr;

PlanRequest Between(double x0, double y0, double x1, double y1) {
  PlanRequest request;
  request.start = {x0, y0};
  request.goal = {x1, y1};
  return request;
}

PlanOptions SmallOptions(int candidates) {
  PlanOptions options;
  options.sampling.candidates = candidates;
  options.sampling.roadmap_nodes = 1000;
  options.threads = 2;
  return options;
}

CandidateSet Sample(const Terrain& terrain, const PlanRequest& request,
                    const PlanOptions& options) {
  const auto vehicle = TestVehicle();
  const TrafficabilityLayer layer(terrain, *vehicle, options.max_speed);
  return SampleCandidates(terrain, *vehicle, layer, request, options, nullptr);
}

// What every candidate must be.
void ExpectSound(const Terrain& terrain, const PlanRequest& request, const CandidateSet& set) {
  const auto vehicle = TestVehicle();
  const TrafficabilityLayer layer(terrain, *vehicle, 8.0);
  double last_cost = 0;
  for (const Candidate& candidate : set.candidates) {
    const auto& points = candidate.path.points();
    EXPECT_EQ(points.front(), request.start);
    EXPECT_EQ(points.back(), request.goal);
    EXPECT_GE(candidate.layer_cost, last_cost);
    last_cost = candidate.layer_cost;
    for (std::size_t i = 1; i < points.size(); ++i) {
      EXPECT_LE((points[i] - points[i - 1]).norm(), 1.0 + 1e-6);
    }
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      // Of a circle through three points at equal steps, the heading at the middle one.
      const Eigen::Vector2d ahead = points[i + 1] - points[i - 1];
      const double heading = std::atan2(ahead.y(), ahead.x());
      EXPECT_TRUE(layer.Evaluate(points[i].x(), points[i].y(), heading).go());
    }
  }
}

double LeastSeparation(const CandidateSet& set) {
  double least = 1e9;
  for (std::size_t i = 0; i < set.candidates.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      least = std::min(
          least, Separation(set.candidates[i].path.points(), set.candidates[j].path.points()));
    }
  }
  return least;
}

Terrain Hills() {
  return SurfaceTerrain(301, 301, 1.0, [](double x, double y) {
    return 10 * std::sin(x / 23) * std::sin(y / 19) + 3 * std::sin(x / 7 + y / 11);
  });
}

TEST(SampleCandidates, GivesTheNumberAskedForAllDifferent) {
  const Terrain terrain = Hills();
  const PlanRequest request = Between(20, 30, 280, 270);
  const CandidateSet set = Sample(terrain, request, SmallOptions(20));
  ASSERT_EQ(set.candidates.size(), 20u);
  EXPECT_FALSE(set.diagnosis.has_value());
  ExpectSound(terrain, request, set);
  EXPECT_GE(LeastSeparation(set), 4.0);  // 5 m over coarser traces
  std::set<std::string> origins;
  for (const Candidate& candidate : set.candidates) origins.insert(candidate.origin);
  EXPECT_EQ(origins.size(), 3u);
}

TEST(SampleCandidates, IsTheSameForAnyNumberOfThreads) {
  const Terrain terrain = Hills();
  PlanOptions options = SmallOptions(12);
  const tbb::global_control allow(tbb::global_control::max_allowed_parallelism, 3);
  std::vector<CandidateSet> sets;
  for (const int threads : {1, 2, 3}) {
    options.threads = threads;
    sets.push_back(Sample(terrain, Between(20, 30, 280, 270), options));
  }
  for (const CandidateSet& set : sets) {
    ASSERT_EQ(set.candidates.size(), sets[0].candidates.size());
    for (std::size_t i = 0; i < set.candidates.size(); ++i) {
      EXPECT_EQ(set.candidates[i].origin, sets[0].candidates[i].origin);
      EXPECT_EQ(set.candidates[i].layer_cost, sets[0].candidates[i].layer_cost);
      EXPECT_EQ(set.candidates[i].path.points(), sets[0].candidates[i].path.points());
    }
  }
}

TEST(SampleCandidates, OtherSeedsGiveOtherRoutes) {
  const Terrain terrain = Hills();
  PlanOptions options = SmallOptions(6);
  const CandidateSet one = Sample(terrain, Between(20, 30, 280, 270), options);
  options.seed = 2;
  const CandidateSet two = Sample(terrain, Between(20, 30, 280, 270), options);
  EXPECT_NE(one.candidates[0].path.points(), two.candidates[0].path.points());
}

TEST(SampleCandidates, RespectsGivenHeadings) {
  const Terrain terrain = Hills();
  PlanRequest request = Between(40, 40, 250, 250);
  request.start_heading = 3.0;
  request.goal_heading = -1.0;
  const CandidateSet set = Sample(terrain, request, SmallOptions(6));
  ASSERT_EQ(set.candidates.size(), 6u);
  for (const Candidate& candidate : set.candidates) {
    // A chord of at most 1 m of a circle of 3.7 m lies within 0.14 rad of the heading.
    EXPECT_NEAR(std::remainder(candidate.path.Heading(0) - 3.0, 6.283185307), 0, 0.15);
    const double end = candidate.path.Heading(candidate.path.length());
    EXPECT_NEAR(std::remainder(end + 1.0, 6.283185307), 0, 0.15);
  }
}

TEST(SampleCandidates, TurnsNoTighterThanTheVehicleCan) {
  const Terrain terrain = Hills();
  const auto vehicle = TestVehicle();
  const CandidateSet set = Sample(terrain, Between(20, 30, 280, 270), SmallOptions(8));
  for (const Candidate& candidate : set.candidates) {
    const auto& points = candidate.path.points();
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      const Eigen::Vector2d a = points[i] - points[i - 1];
      const Eigen::Vector2d b = points[i + 1] - points[i];
      const double turn = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
      // Chords of an arc turn by half of their summed arc lengths over the radius.
      const double arc = 0.5 * (a.norm() + b.norm());
      EXPECT_LE(std::abs(turn), 1.02 * arc / vehicle->min_turning_radius() + 1e-3);
    }
  }
}

TEST(SampleCandidates, FindsTheGapInAWall) {
  // 160 m x 120 m, a wall of posts across with one gap of 5 m at y = 90.
  std::vector<std::string> drawing(120, std::string(160, '.'));
  for (int y = 0; y < 120; ++y) {
    if (y < 88 || y > 92) drawing[119 - y].replace(80, 2, "##");
  }
  const Terrain terrain = DrawnTerrain(drawing, 1.0);
  const PlanRequest request = Between(20, 30, 140, 30);
  const CandidateSet set = Sample(terrain, request, SmallOptions(6));
  ASSERT_EQ(set.candidates.size(), 6u);
  ExpectSound(terrain, request, set);
  for (const Candidate& candidate : set.candidates) {
    EXPECT_LT(DistanceToPolyline({81, 90}, candidate.path.points()), 2.5);
  }
}

TEST(SampleCandidates, GoesRoundAHillOnBothSides) {
  const Terrain terrain = SurfaceTerrain(241, 201, 1.0, [](double x, double y) {
    const double r = std::hypot(x - 120, y - 100);
    return 60 * std::exp(-r * r / (2 * 25 * 25));
  });
  const PlanRequest request = Between(20, 100, 220, 100);
  const CandidateSet set = Sample(terrain, request, SmallOptions(10));
  ASSERT_EQ(set.candidates.size(), 10u);
  ExpectSound(terrain, request, set);
  int north = 0, south = 0;
  for (const Candidate& candidate : set.candidates) {
    const double y = candidate.path.Position(candidate.path.length() / 2).y();
    (y > 100 ? north : south) += 1;
  }
  EXPECT_GT(north, 0);
  EXPECT_GT(south, 0);
}

TEST(SampleCandidates, SteepBandForcesADetour) {
  // A bank of 45 deg from the south edge to y = 120, level beyond it on both sides.
  const Terrain terrain = SurfaceTerrain(201, 201, 1.0, [](double x, double y) {
    const double height = std::clamp(0.1 * (150 - y), 0.0, 3.0) * 2;
    return std::clamp(x - 97.0, 0.0, height);
  });
  const PlanRequest request = Between(30, 40, 170, 40);
  const CandidateSet set = Sample(terrain, request, SmallOptions(4));
  ASSERT_EQ(set.candidates.size(), 4u);
  for (const Candidate& candidate : set.candidates) {
    double top = 0;
    for (const Eigen::Vector2d& point : candidate.path.points()) top = std::max(top, point.y());
    EXPECT_GT(top, 110);
  }
}

TEST(SampleCandidates, FillsUpInANarrowLane) {
  // A lane of 6 m between water: routes cannot differ by 5 m, but the number is kept.
  std::vector<std::string> drawing(40, std::string(120, '~'));
  for (int y = 17; y < 24; ++y) drawing[y] = std::string(120, '.');
  const Terrain terrain = DrawnTerrain(drawing, 1.0);
  PlanRequest request = Between(8, 19.5, 110, 19.5);
  const CandidateSet set = Sample(terrain, request, SmallOptions(6));
  EXPECT_EQ(set.candidates.size(), 6u);
  ExpectSound(terrain, request, set);
}

TEST(SampleCandidates, SaysWhatEnclosesTheGoal) {
  // A trench 4 m deep and 4 m wide round the goal at (100, 60).
  std::vector<std::string> drawing(120, std::string(140, '.'));
  for (int y = 0; y < 120; ++y) {
    for (int x = 0; x < 140; ++x) {
      const double r = std::max(std::abs(x - 100), std::abs(y - 60));
      if (r >= 20 && r < 24) drawing[119 - y][x] = 'v';
    }
  }
  const Terrain terrain = DrawnTerrain(drawing, 1.0);
  const CandidateSet set = Sample(terrain, Between(20, 60, 100, 60), SmallOptions(6));
  EXPECT_TRUE(set.candidates.empty());
  ASSERT_TRUE(set.diagnosis.has_value());
  EXPECT_TRUE(set.diagnosis->reason == NoGoReason::kSlope ||
              set.diagnosis->reason == NoGoReason::kStep);
  EXPECT_THAT(set.diagnosis->why, HasSubstr("the goal is enclosed"));
  // The trench crosses the straight line between x = 76 and x = 80.
  EXPECT_NEAR(set.diagnosis->where.x(), 79, 4);
  EXPECT_NEAR(set.diagnosis->where.y(), 60, 1.5);
}

TEST(SampleCandidates, SaysThatAnEndIsNoPlaceToStand) {
  std::vector<std::string> drawing(60, std::string(60, '.'));
  for (int y = 20; y < 40; ++y) drawing[y].replace(20, 20, std::string(20, '~'));
  const Terrain terrain = DrawnTerrain(drawing, 1.0);
  const CandidateSet set = Sample(terrain, Between(30, 30, 50, 50), SmallOptions(4));
  ASSERT_TRUE(set.diagnosis.has_value());
  EXPECT_EQ(set.diagnosis->reason, NoGoReason::kImpassableMaterial);
  EXPECT_EQ(set.diagnosis->where, Eigen::Vector2d(30, 30));
  EXPECT_EQ(set.diagnosis->why, "the start is no place to stand: the material is impassable");
}

void ExpectInputError(const Terrain& terrain, const PlanRequest& request, const std::string& first,
                      const std::string& second) {
  try {
    Sample(terrain, request, SmallOptions(4));
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr(first), HasSubstr(second)));
  }
}

TEST(SampleCandidates, RefusesEndsThatNoRouteCanHave) {
  std::vector<std::string> drawing(60, std::string(60, '.'));
  for (int y = 20; y < 40; ++y) drawing[y].replace(20, 20, std::string(20, '?'));
  const Terrain terrain = DrawnTerrain(drawing, 1.0);
  ExpectInputError(terrain, Between(-5, 30, 50, 50), "start -5.00,30.00", "inside the terrain");
  ExpectInputError(terrain, Between(5, 30, 50, 99), "goal 50.00,99.00", "inside the terrain");
  ExpectInputError(terrain, Between(5, 30, 30, 30), "goal 30.00,30.00", "known ground");
  ExpectInputError(terrain, Between(5, 30, std::nan(""), 30), "goal", "inside the terrain");
  ExpectInputError(terrain, Between(5, 30, 5, 30.1), "goal 5.00,30.10", "1 m from the start");
}

TEST(SampleCandidates, FindsRoutesOnRealLidar) {
  const std::string file = std::string(DBD_SHARED_DATA) + "/dem/slovenia_TM1_564_146.tif";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is absent";
  TerrainFiles files;
  files.elevation = file;
  const auto terrain = LoadTerrain(files);
  const Eigen::Vector2d start = terrain->frame().ToLocal({564050, 146300});
  const Eigen::Vector2d goal = terrain->frame().ToLocal({564950, 146850});
  const PlanRequest request = Between(start.x(), start.y(), goal.x(), goal.y());
  PlanOptions options;
  options.sampling.candidates = 32;
  const CandidateSet set = Sample(*terrain, request, options);
  ASSERT_EQ(set.candidates.size(), 32u);
  ExpectSound(*terrain, request, set);
}

}  // namespace
}  // namespace dbd
