#include "lattice_search.h"

#include <dbd/planner/candidate_curve.h>
#include <dbd/planner/candidate_sampler.h>
#include <dbd/planner/stop.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "candidate_test_terrain.h"

namespace dbd {
namespace {

// 1 m cells, 60 x 50: three walls of posts with gaps of 6 m, by turns at both ends.
Terrain Slalom() {
  std::vector<std::string> drawing(50, std::string(60, '.'));
  for (int wall = 0; wall < 3; ++wall) {
    for (int row = 0; row < 50; ++row) {
      const bool gap = wall % 2 == 0 ? row >= 2 && row < 8 : row >= 42 && row < 48;
      if (!gap) drawing[row][15 + 15 * wall] = '#';
    }
  }
  return DrawnTerrain(drawing, 1.0);
}

RoadmapQuery FromWestToEast(const TrafficabilityLayer& layer) {
  RoadmapQuery query;
  query.starts = {{6, 25, 0}};
  query.goals = {{54, 25, 0}};
  query.min_corner = layer.min_corner();
  query.max_corner = layer.max_corner();
  return query;
}

class LatticeSearch : public testing::Test {
 protected:
  double radius() const { return TestVehicle()->min_turning_radius(); }
  const Terrain terrain_ = Slalom();
  const TrafficabilityLayer layer_{terrain_, *TestVehicle(), 8.0};
};

TEST_F(LatticeSearch, FindsTheWayThroughASlalom) {
  const RoadmapQuery query = FromWestToEast(layer_);
  const std::vector<Pose2> way = SearchLattice(layer_, radius(), query, {});
  ASSERT_GE(way.size(), 2u);
  EXPECT_EQ(way.front().position(), query.starts[0].position());
  EXPECT_EQ(way.back().position(), query.goals[0].position());
  const std::vector<Pose2> dense = DensePoses(way, radius());
  EXPECT_TRUE(AllGo(layer_, dense));
  // Through the gaps: up, down, up again.
  EXPECT_GT(dense.size(), 100u);
}

TEST_F(LatticeSearch, NeighboursAreNearEnoughToBeNodesOfARoadmap) {
  const std::vector<Pose2> way = SearchLattice(layer_, radius(), FromWestToEast(layer_), {});
  for (std::size_t i = 2; i + 1 < way.size(); ++i) {  // the last curve may be long
    EXPECT_LT((way[i].position() - way[i - 1].position()).norm(), 1.3 * radius());
  }
}

TEST_F(LatticeSearch, GivesUpAfterItsBudget) {
  LatticeOptions options;
  options.expansions = 20;
  EXPECT_TRUE(SearchLattice(layer_, radius(), FromWestToEast(layer_), options).empty());
}

TEST_F(LatticeSearch, FindsNothingWhereNothingIs) {
  std::vector<std::string> drawing(50, std::string(60, '.'));
  for (std::string& row : drawing) row[30] = '#';
  const Terrain walled = DrawnTerrain(drawing, 1.0);
  const TrafficabilityLayer layer(walled, *TestVehicle(), 8.0);
  EXPECT_TRUE(SearchLattice(layer, radius(), FromWestToEast(layer), {}).empty());
}

TEST_F(LatticeSearch, ItsWayIsACandidateWhenAskedFor) {
  PlanRequest request;
  request.start = {6, 25};
  request.goal = {54, 25};
  PlanOptions options;
  options.sampling = {.candidates = 6, .roadmap_nodes = 200, .planner_iterations = 100};
  options.sampling.narrow_ways = true;
  const CandidateSet set =
      SampleCandidates(terrain_, *TestVehicle(), layer_, request, options, nullptr);
  EXPECT_TRUE(
      std::any_of(set.candidates.begin(), set.candidates.end(),
                  [](const Candidate& candidate) { return candidate.origin == "lattice"; }));
  for (const Candidate& candidate : set.candidates)
    EXPECT_TRUE(std::isfinite(candidate.layer_cost));
}

/// A lane of 6 m between posts, closed in the west and open in the east: too narrow to turn in.
Terrain Lane() {
  std::vector<std::string> drawing(50, std::string(60, '.'));
  for (int column = 2; column < 30; ++column) drawing[21][column] = drawing[28][column] = '#';
  for (int row = 21; row <= 28; ++row) drawing[row][2] = '#';
  return DrawnTerrain(drawing, 1.0);
}

TEST(LatticeSearchReversing, BacksOutOfALane) {
  const Terrain terrain = Lane();
  const TrafficabilityLayer layer(terrain, *TestVehicle(), 8.0);
  const double radius = TestVehicle()->min_turning_radius();
  RoadmapQuery query = FromWestToEast(layer);
  query.starts = {{12, 24.5, WrapAngle(std::numbers::pi)}};
  query.goals = {{54, 25, 0}};
  EXPECT_TRUE(SearchLattice(layer, radius, query, {}).empty());
  LatticeOptions options;
  options.reversing = true;
  const std::vector<Pose2> way = SearchLattice(layer, radius, query, options);
  ASSERT_FALSE(way.empty());
  const std::vector<Pose2> dense = DensePoses(way, radius);
  EXPECT_TRUE(AllGo(layer, dense));
  EXPECT_TRUE(Reverses(dense));
  EXPECT_LT(PathAlong(dense, {12, 24.5}, {54, 25}).stretches().size(), 4u);  // no needless changes
}

TEST_F(LatticeSearch, StopsWhenAsked) {
  std::stop_source source;
  source.request_stop();
  EXPECT_THROW(SearchLattice(layer_, radius(), FromWestToEast(layer_), {}, source.get_token()),
               StopRequested);
}

}  // namespace
}  // namespace dbd
