#include <dbd/planner/drive.h>
#include <dbd/planner/plan_route.h>
#include <gtest/gtest.h>
#include <octomap/OcTree.h>

#include "candidate_test_terrain.h"
#include "support/terrain_files.h"

namespace dbd {
namespace {

constexpr double kVoxel = 0.25;

// Level ground of 60 m x 30 m at a height of 100 m, with an OctoMap of what is built at x = 30.
class Overhang : public testing::Test {
 protected:
  // Voxels from `low` to `high` above the ground, y from `south` to `north`, 1 m thick.
  void Build(double south, double north, double low, double high) {
    for (double x = 29.5; x < 30.5; x += kVoxel) {
      for (double y = south; y < north; y += kVoxel) {
        for (double z = low; z < high; z += kVoxel) {
          const double half = 0.5 * kVoxel;
          tree_.updateNode(x + half, y + half, 100 + z + half, true);
        }
      }
    }
  }

  std::shared_ptr<const Terrain> Load(UnknownSpace unknown_space = UnknownSpace::kFree) {
    TestRaster raster;
    raster.columns = 60;
    raster.rows = 30;
    raster.transform = {500000, 1, 0, 5200030, 0, -1};
    raster.value = [](int, int) { return 100.0; };
    TerrainFiles files;
    files.elevation = raster.Write(directory_.File("dem.tif"));
    files.obstacles = directory_.File("built.bt");
    files.obstacles_placement.origin = {500000, 5200000};
    files.unknown_space = unknown_space;
    tree_.writeBinary(files.obstacles);
    return LoadTerrain(files);
  }

  Outcome DriveAcross(const Terrain& terrain) {
    const Path path({Local(terrain, 8, 15), Local(terrain, 52, 15)});
    return DrivePath(terrain, *TestVehicle(), path, path.Position(0), 0, {}).outcome;
  }

  static Eigen::Vector2d Local(const Terrain& terrain, double x, double y) {
    return terrain.frame().ToLocal({500000 + x, 5200000 + y});
  }

  TemporaryDirectory directory_;
  octomap::OcTree tree_{kVoxel};
};

TEST_F(Overhang, HighEnoughIsDrivenUnder) {
  const double height = TestVehicle()->outline.height;
  Build(0, 30, std::ceil((height + 0.3) / kVoxel) * kVoxel, 4);
  EXPECT_EQ(DriveAcross(*Load()), Outcome::kReached);
}

TEST_F(Overhang, TooLowIsHit) {
  const double height = TestVehicle()->outline.height;
  Build(0, 30, std::floor((height - 0.3) / kVoxel) * kVoxel, 4);
  EXPECT_EQ(DriveAcross(*Load()), Outcome::kCollided);
}

TEST_F(Overhang, AWallIsHit) {
  Build(0, 30, 0, 1.5);
  EXPECT_EQ(DriveAcross(*Load()), Outcome::kCollided);
}

// The wall's only gap is a gate of 7 m with a deck over it.
TEST_F(Overhang, RoutesGoThroughAGateInAWall) {
  Build(0, 18, 0, 4);
  Build(25, 30, 0, 4);
  Build(18, 25, 3, 4);
  const auto terrain = Load();
  PlanRequest request;
  request.start = Local(*terrain, 8, 15);
  request.goal = Local(*terrain, 52, 15);
  PlanOptions options;
  options.sampling.candidates = 6;
  const Plan plan = PlanRoute(terrain, TestVehicle(), request, options);
  ASSERT_TRUE(plan.chosen.has_value()) << plan.reason;
  const double wall = Local(*terrain, 30, 0).x();
  for (const TraceSample& sample : plan.rollouts[static_cast<std::size_t>(*plan.chosen)].trace) {
    if (std::abs(sample.x - wall) > 0.5) continue;
    EXPECT_GT(sample.y, Local(*terrain, 0, 18).y());
    EXPECT_LT(sample.y, Local(*terrain, 0, 25).y());
  }
  // Without the gate there is no route.
  Build(18, 25, 0, 3);
  const Plan none = PlanRoute(Load(), TestVehicle(), request, options);
  EXPECT_EQ(none.status, PlanStatus::kNoGo);
}

// Only the bridge was seen, so all else is in the way when the request says so.
TEST_F(Overhang, UnseenSpaceIsFreeUnlessTheRequestSaysOtherwise) {
  Build(0, 30, 3, 4);
  EXPECT_EQ(DriveAcross(*Load(UnknownSpace::kFree)), Outcome::kReached);
  EXPECT_EQ(DriveAcross(*Load(UnknownSpace::kBlocked)), Outcome::kCollided);
}

}  // namespace
}  // namespace dbd
