#include <dbd/core/error.h>
#include <dbd/planner/trafficability.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "candidate_test_terrain.h"

namespace dbd {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kEast = 0;
constexpr double kNorth = kPi / 2;
constexpr double kWest = kPi;

// Rises to the east at a constant angle.
Terrain Incline(double degrees, double cone_index = 1.8e6) {
  const double grade = std::tan(degrees * kPi / 180);
  return SurfaceTerrain(
      41, 41, 1.0, [grade](double x, double) { return grade * x; }, cone_index);
}

NoGoReason ReasonAt(const Terrain& terrain, double x, double y, double heading) {
  const auto vehicle = TestVehicle();
  return ReasonAtMiddle(TrafficabilityLayer(terrain, *vehicle, 8.0), x, y, heading);
}

TEST(Trafficability, LevelFirmGroundIsGoAtAboutFullSpeed) {
  const Terrain terrain = Incline(0);
  const auto vehicle = TestVehicle();
  const TrafficabilityLayer layer(terrain, *vehicle, 8.0);
  for (double heading = -3; heading < 3; heading += 0.5) {
    EXPECT_TRUE(layer.Evaluate(20, 20, heading).go());
    EXPECT_GE(layer.SecondsPerMetre(20, 20, heading), layer.min_seconds_per_metre());
    EXPECT_LT(layer.SecondsPerMetre(20, 20, heading), 2 * layer.min_seconds_per_metre());
  }
  EXPECT_DOUBLE_EQ(layer.min_seconds_per_metre(), 1.0 / 8.0);
}

TEST(Trafficability, LimitsDependOnTheHeading) {
  // max_roll 0.52 rad = 29.8 deg, with the tolerance 32.8 deg; max_slope 34.95, with it 38.4 deg.
  EXPECT_EQ(ReasonAt(Incline(28), 20, 20, kNorth), NoGoReason::kNone);
  EXPECT_EQ(ReasonAt(Incline(34), 20, 20, kNorth), NoGoReason::kRoll);
  EXPECT_EQ(ReasonAt(Incline(34), 20, 20, kWest), NoGoReason::kNone);
  EXPECT_EQ(ReasonAt(Incline(40), 20, 20, kWest), NoGoReason::kSlope);
}

TEST(Trafficability, SoftGroundIsClimbedLessSteeply) {
  // The net traction ratio of the test vehicle is above tan(20 deg) = 0.36 on firm ground and
  // below it on a cone index of 150 kPa; downhill needs none.
  EXPECT_EQ(ReasonAt(Incline(20, 1.8e6), 20, 20, kEast), NoGoReason::kNone);
  EXPECT_EQ(ReasonAt(Incline(20, 1.5e5), 20, 20, kEast), NoGoReason::kTraction);
  EXPECT_EQ(ReasonAt(Incline(20, 1.5e5), 20, 20, kWest), NoGoReason::kNone);
  EXPECT_EQ(ReasonAt(Incline(3, 1.5e5), 20, 20, kEast), NoGoReason::kNone);
}

TEST(Trafficability, CostGrowsWithTheUseOfLimits) {
  double last = 0;
  for (const double degrees : {0.0, 5.0, 10.0, 15.0, 20.0, 25.0, 29.0}) {
    const Terrain terrain = Incline(degrees);
    const auto vehicle = TestVehicle();
    const TrafficabilityLayer layer(terrain, *vehicle, 8.0);
    const double across = layer.SecondsPerMetre(20, 20, kNorth);
    EXPECT_GT(across, last) << degrees;
    last = across;
    if (degrees == 0) continue;
    EXPECT_GT(layer.SecondsPerMetre(20, 20, kEast), layer.SecondsPerMetre(20, 20, kWest));
  }
  EXPECT_GT(last, 10.0 / 8.0);
}

TEST(Trafficability, GradientIsThatOfAPlaneInAnyDirection) {
  // z = 0.2 x + 0.1 y: along (2, 1) the grade is sqrt(0.05), across it none. Up costs more than
  // along the contour, and both diagonals of equal slope cost the same.
  const Terrain terrain =
      SurfaceTerrain(41, 41, 0.5, [](double x, double y) { return 0.2 * x + 0.1 * y; });
  const auto vehicle = TestVehicle();
  const TrafficabilityLayer layer(terrain, *vehicle, 8.0);
  const double up = std::atan2(1, 2);
  EXPECT_NEAR(layer.SecondsPerMetre(10, 10, up + 0.4), layer.SecondsPerMetre(10, 10, up - 0.4),
              1e-4);
  EXPECT_NEAR(layer.SecondsPerMetre(10, 10, up + kPi / 2),
              layer.SecondsPerMetre(10, 10, up - kPi / 2), 1e-4);
}

TEST(Trafficability, StepsOfALargerWheelAreNoGoAndKerbsAreNot) {
  const auto step = [](double height) {
    return SurfaceTerrain(41, 41, 0.5,
                          [height](double x, double) { return x < 10 ? 0.0 : height; });
  };
  EXPECT_EQ(ReasonAt(step(0.15), 10, 10, kEast), NoGoReason::kNone);
  EXPECT_EQ(ReasonAt(step(0.8), 10, 10, kEast), NoGoReason::kStep);
}

TEST(Trafficability, BellyTouchesACrestWhenCrossedNotWhenFollowed) {
  // A ridge running north, 22 deg on both sides: over a wheelbase of 2 m the middle stands
  // 0.4 m above the wheels when crossed.
  const Terrain ridge =
      SurfaceTerrain(81, 81, 0.5, [](double x, double) { return -0.45 * std::abs(x - 20); });
  EXPECT_EQ(ReasonAt(ridge, 20, 20, kEast), NoGoReason::kClearance);
  EXPECT_EQ(ReasonAt(ridge, 20, 20, kNorth), NoGoReason::kNone);
}

TEST(Trafficability, NamesWhatIsInTheWay) {
  const Terrain terrain = DrawnTerrain(
      {
          "....................",
          "....................",
          "..~~~....???....mmm.",
          "..~~~....???....mmm.",
          "..~~~....???....mmm.",
          "....................",
          "....................",
          "....................",
      },
      2.0);
  const auto vehicle = TestVehicle();
  const TrafficabilityLayer layer(terrain, *vehicle, 8.0);
  // Cells are 2 m; the southmost row lies at y = 0, the blocks at y = 6 ... 10.
  EXPECT_EQ(ReasonAtMiddle(layer, 6, 8, kEast), NoGoReason::kImpassableMaterial);
  EXPECT_EQ(ReasonAtMiddle(layer, 20, 8, kEast), NoGoReason::kUnknownGround);
  const NoGoReason mud = ReasonAtMiddle(layer, 34, 8, kEast);
  EXPECT_TRUE(mud == NoGoReason::kSinkage || mud == NoGoReason::kTraction);
  EXPECT_EQ(ReasonAtMiddle(layer, -3, 8, kEast), NoGoReason::kOutsideMap);
  EXPECT_EQ(ReasonAtMiddle(layer, 0.1, 8, kEast), NoGoReason::kOutsideMap);
  EXPECT_EQ(ReasonAtMiddle(layer, std::nan(""), 8, kEast), NoGoReason::kOutsideMap);
  EXPECT_TRUE(std::isinf(layer.SecondsPerMetre(6, 8, kEast)));
  EXPECT_EQ(ReasonAtMiddle(layer, 13, 8, kEast), NoGoReason::kNone);
}

TEST(Trafficability, ObstaclesAreMetByTheOrientedBox) {
  // Two walls 3 m apart leave room for the vehicle lengthwise, not crosswise.
  const std::string open(40, '.');
  const std::string wall(40, '#');
  const Terrain terrain = DrawnTerrain({open, open, open, open, wall, open, open, open, open, open,
                                        open, wall, open, open, open, open},
                                       0.5);
  // Walls at y = 2 and 5.5 (rows 4 and 11 from the south): free between 2.25 and 5.25 m.
  const auto vehicle = TestVehicle();
  const TrafficabilityLayer layer(terrain, *vehicle, 8.0);
  EXPECT_EQ(ReasonAtMiddle(layer, 10, 3.75, kEast), NoGoReason::kNone);
  EXPECT_EQ(ReasonAtMiddle(layer, 10, 3.75, kNorth), NoGoReason::kObstacle);
  EXPECT_EQ(ReasonAtMiddle(layer, 10, 2.5, kEast), NoGoReason::kObstacle);
}

TEST(Trafficability, ElbowRoomBesideObstaclesIsCheaper) {
  const std::string open(40, '.');
  const std::string wall(40, '#');
  const Terrain terrain = DrawnTerrain({open, open, wall, open, open, open, open, open, open, open,
                                        open, open, wall, open, open, open},
                                       0.5);
  // Walls at y = 1.5 and 6.5: free between 1.75 and 6.25 m.
  const auto vehicle = TestVehicle();
  const TrafficabilityLayer layer(terrain, *vehicle, 8.0);
  const double middle = layer.SecondsPerMetre(10, 4, kEast);
  const double nearest = 1.75 + vehicle->outline.half_width + 0.2;  // to a wall: the margin is left
  for (const double y : {nearest + 0.1, 8 - nearest - 0.1}) {
    const double tight = layer.SecondsPerMetre(10, y, kEast);
    EXPECT_TRUE(std::isfinite(tight)) << y;
    EXPECT_GT(tight, 1.5 * middle) << y;
  }
}

TEST(Trafficability, LargeMapsGetCoarserCells) {
  TrafficabilityOptions options;
  options.max_cells = 1000;
  const Terrain terrain = Incline(10);
  const auto vehicle = TestVehicle();
  const TrafficabilityLayer layer(terrain, *vehicle, 8.0, options);
  EXPECT_LE(layer.columns() * layer.rows(), 1000);
  EXPECT_GT(layer.resolution(), 1.0);
  EXPECT_TRUE(layer.Evaluate(20, 20, kEast).go());
}

TEST(TrafficabilityOptions, NameTheFieldAndTheRule) {
  TrafficabilityOptions options;
  options.tolerance = 2;
  try {
    options.Validate();
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "trafficability.tolerance: 2.000000 must be in [0, 0.5]");
  }
}

TEST(NoGoReason, EveryReasonHasItsOwnName) {
  for (int i = 0; i < kNoGoReasonCount; ++i) {
    for (int j = 0; j < i; ++j) {
      EXPECT_STRNE(NoGoReasonName(NoGoReason(i)), NoGoReasonName(NoGoReason(j)));
      EXPECT_STRNE(NoGoReasonText(NoGoReason(i)), NoGoReasonText(NoGoReason(j)));
    }
  }
}

}  // namespace
}  // namespace dbd
