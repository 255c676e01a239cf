#include <dbd/planner/drive.h>
#include <dbd/planner/plan_route.h>
#include <dbd/planner/scoring.h>
#include <dbd/terrain/generator.h>
#include <gdal_utils.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>

#include "candidate_test_terrain.h"
#include "support/terrain_files.h"

namespace dbd {
namespace {

// The same hills as a raster in UTM, as a raster in degrees, and as a TIN through its cells.
class SamePlaceTest : public testing::Test {
 protected:
  SamePlaceTest() {
    GeneratorOptions options;
    options.size = 320;
    options.cell_size = 0.5;
    options.relief = 20;
    options.wavelength = 160;
    options.tree_density = 0;
    generated_ = GenerateTerrain(options, directory_.File("land"));
    const Eigen::Vector2d way = generated_.goal - generated_.start;
    start_ = generated_.start + 0.15 * way;
    goal_ = generated_.start + 0.42 * way;
    WriteDegrees();
    utm_ = LoadElevationOnly(generated_.elevation);
    degrees_ = LoadElevationOnly(directory_.File("degrees.tif"));
    WritePoints();
    TerrainFiles tin;
    tin.elevation = directory_.File("points.xyz");
    tin.crs = "EPSG:32633";
    tin_ = LoadTerrain(tin);
  }

  void WriteDegrees() const {
    const GDALDatasetUniquePtr source(
        GDALDataset::Open(generated_.elevation.c_str(), GDAL_OF_RASTER));
    const char* const words[] = {"-t_srs", "EPSG:4326", "-r", "cubic", nullptr};
    GDALWarpAppOptions* options = GDALWarpAppOptionsNew(const_cast<char**>(words), nullptr);
    GDALDatasetH input = GDALDataset::ToHandle(source.get());
    const GDALDatasetUniquePtr warped(GDALDataset::FromHandle(
        GDALWarp(directory_.File("degrees.tif").c_str(), nullptr, 1, &input, options, nullptr)));
    GDALWarpAppOptionsFree(options);
  }

  void WritePoints() const {
    std::ofstream file(directory_.File("points.xyz"));
    const HeightMap& heights = utm_->heights();
    for (int row = 0; row < heights.grid().rows; ++row) {
      for (int column = 0; column < heights.grid().columns; ++column) {
        const Eigen::Vector2d place = utm_->frame().ToMap(heights.grid().Center(column, row));
        char line[100];
        std::snprintf(line, sizeof line, "%.3f %.3f %.5f\n", place.x(), place.y(),
                      heights.CellHeight(column, row));
        file << line;
      }
    }
  }

  Plan PlanOn(const std::shared_ptr<const Terrain>& terrain) const {
    PlanRequest request;
    request.start = terrain->frame().ToLocal(start_);
    request.goal = terrain->frame().ToLocal(goal_);
    PlanOptions options;
    options.sampling.candidates = 4;
    return PlanRoute(terrain, TestVehicle(), request, options);
  }

  static double CostOf(const Plan& plan) {
    EXPECT_TRUE(plan.chosen.has_value()) << plan.reason;
    return plan.scores[static_cast<std::size_t>(plan.chosen.value())].total;
  }

  // Drives the path of another terrain.
  double CostOfPath(const Terrain& terrain, const Path& path, const Terrain& of) const {
    std::vector<Eigen::Vector2d> points;
    for (const Eigen::Vector2d& point : path.points()) {
      points.push_back(terrain.frame().ToLocal(of.frame().ToMap(point)));
    }
    const Path moved(points);
    const Rollout rollout = DrivePath(terrain, *TestVehicle(), moved, moved.Position(0),
                                      moved.Heading(0), {.target_speed = 8, .duration = 100});
    EXPECT_EQ(rollout.outcome, Outcome::kReached) << rollout.reason;
    return ScoreRollout(rollout, {}).total;
  }

  // Of the places of a grid that leave a margin at the map's edge.
  double RmsDifference(const Terrain& terrain) const {
    const HeightMap::Grid& grid = utm_->heights().grid();
    double sum = 0;
    int count = 0;
    for (int row = 4; row + 5 < grid.rows; row += 5) {
      for (int column = 4; column + 5 < grid.columns; column += 5, ++count) {
        const Eigen::Vector2d place = utm_->frame().ToMap(grid.Center(column, row));
        sum += std::pow(
            HeightAtMap(terrain, place.x(), place.y()) - utm_->heights().CellHeight(column, row),
            2);
      }
    }
    return std::sqrt(sum / count);
  }

  TemporaryDirectory directory_;
  GeneratedTerrain generated_;
  Eigen::Vector2d start_;  // map coordinates [m]
  Eigen::Vector2d goal_;
  std::shared_ptr<const Terrain> utm_;
  std::shared_ptr<const Terrain> degrees_;
  std::shared_ptr<const Terrain> tin_;
};

// The raster in degrees is resampled twice by cubics of half a metre; banks lose some centimetres.
TEST_F(SamePlaceTest, HasTheSameHeights) {
  EXPECT_LT(RmsDifference(*tin_), 1e-3);
  EXPECT_LT(RmsDifference(*degrees_), 0.01);
}

TEST_F(SamePlaceTest, RoutesCostTheSame) {
  const Plan plan = PlanOn(utm_);
  const double cost = CostOf(plan);
  EXPECT_NEAR(CostOf(PlanOn(degrees_)), cost, 0.02 * cost);
  EXPECT_NEAR(CostOf(PlanOn(tin_)), cost, 0.02 * cost);

  const Path& path = plan.candidates[static_cast<std::size_t>(plan.chosen.value())].path;
  const double drive = CostOfPath(*utm_, path, *utm_);
  EXPECT_NEAR(CostOfPath(*degrees_, path, *utm_), drive, 0.02 * drive);
  EXPECT_NEAR(CostOfPath(*tin_, path, *utm_), drive, 0.02 * drive);
}

}  // namespace
}  // namespace dbd
