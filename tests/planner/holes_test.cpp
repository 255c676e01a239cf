#include <dbd/planner/plan_route.h>
#include <dbd/planner/scoring.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "candidate_test_terrain.h"
#include "support/terrain_files.h"

namespace dbd {
namespace {

// Whether a wheel of the vehicle at a sample touches ground that is not known: under its hub, as on
// level ground, or under the corners of its footprint.
bool TouchesUnknown(const Terrain& terrain, const VehicleModel& vehicle,
                    const TraceSample& sample) {
  const Eigen::Vector2d ahead(std::cos(sample.yaw), std::sin(sample.yaw));
  const Eigen::Vector2d left(-ahead.y(), ahead.x());
  for (const WheelModel& wheel : vehicle.wheels) {
    const auto& body = vehicle.bodies[static_cast<std::size_t>(wheel.body)];
    const Eigen::Vector3d p_BH = body.p_RB + wheel.p_BH - vehicle.bodies[0].p_RB;
    const double reach = 0.4 * wheel.tire.width;  // a little less for the suspension's travel
    for (const std::array<double, 2>& corner :
         {std::array{0.0, 0.0}, {1.0, 1.0}, {1.0, -1.0}, {-1.0, 1.0}, {-1.0, -1.0}}) {
      const Eigen::Vector2d place = Eigen::Vector2d(sample.x, sample.y) +
                                    (p_BH.x() + reach * corner[0]) * ahead +
                                    (p_BH.y() + reach * corner[1]) * left;
      if (!terrain.IsKnown(place.x(), place.y())) return true;
    }
  }
  return false;
}

// Of all drives that reached the goal, not of the chosen one alone.
void ExpectNoWheelTouchesAHole(const Terrain& terrain, const Plan& plan) {
  ASSERT_TRUE(plan.chosen.has_value()) << plan.reason;
  const auto vehicle = TestVehicle();
  for (std::size_t i = 0; i < plan.rollouts.size(); ++i) {
    if (!plan.scores[i].feasible) continue;
    for (const TraceSample& sample : plan.rollouts[i].trace) {
      ASSERT_FALSE(TouchesUnknown(terrain, *vehicle, sample))
          << "candidate " << i << " after " << sample.s << " m";
    }
  }
}

TEST(Holes, AreNotTouchedByAnyWheel) {
  // Rolling ground of 120 m x 60 m with holes of one to three cells, about 10 m apart, but none
  // near start and goal.
  constexpr int kColumns = 121, kRows = 61;
  std::vector<float> heights;
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      heights.push_back(static_cast<float>(std::sin(0.1 * column) + std::cos(0.15 * row)));
    }
  }
  std::mt19937 random(3);
  for (int hole = 0; hole < 50; ++hole) {
    const int column = 16 + static_cast<int>(random() % 85);
    const int row = 3 + static_cast<int>(random() % 53);
    const int size = 1 + hole % 3;
    for (int i = 0; i < size * size; ++i) {
      heights[static_cast<std::size_t>(row + i / size) * kColumns + column + i % size] =
          std::numeric_limits<float>::quiet_NaN();
    }
  }
  const auto terrain =
      std::make_shared<const Terrain>(LocalFrame("", Eigen::Vector2d::Zero()),
                                      HeightMap(TestGrid(kColumns, kRows, 1.0), std::move(heights)),
                                      MaterialMap(TestMaterial("ground", 1.8e6)), ObstacleMap());
  ASSERT_GT(terrain->heights().unknown_share(), 0.02);
  PlanRequest request;
  request.start = {8, 30};
  request.goal = {112, 30};
  PlanOptions options;
  options.sampling.candidates = 8;
  ExpectNoWheelTouchesAHole(*terrain, PlanRoute(terrain, TestVehicle(), request, options));
}

TEST(Holes, OfARealMapAreNotTouchedByAnyWheel) {
  const std::string file = SharedFile("dem/slovenia_TM1_564_146_nodata.tif");
  if (file.empty()) GTEST_SKIP() << "no shared data";
  const auto terrain = LoadElevationOnly(file);
  ASSERT_GT(terrain->heights().unknown_share(), 0);
  PlanRequest request;
  request.start = terrain->frame().ToLocal({564560, 146570});
  request.goal = terrain->frame().ToLocal({564640, 146630});
  PlanOptions options;
  options.sampling.candidates = 6;
  ExpectNoWheelTouchesAHole(*terrain, PlanRoute(terrain, TestVehicle(), request, options));
}

}  // namespace
}  // namespace dbd
