#include "deepest_sinkage.h"

#include <dbd/core/mobility.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "candidate_test_terrain.h"

namespace dbd {
namespace {

std::vector<WheelView> RandomWheels(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<WheelView> wheels(4);
  for (WheelView& wheel : wheels) {
    wheel.load = std::max(0.0, 6000 * uniform(random) - 600);
    wheel.cone_index = uniform(random) < 0.5 ? 3e5 : 2e6 * uniform(random);
    wheel.deflection = 0.06 * uniform(random);
    wheel.slip = uniform(random) < 0.3 ? 0 : 2 * uniform(random) - 1;
  }
  if (uniform(random) < 0.3) wheels[3] = wheels[0];
  return wheels;
}

double DeepestByHand(const Terrain& terrain, const VehicleModel& vehicle,
                     const std::vector<WheelView>& wheels, const SinkageOptions& options) {
  double deepest = 0;
  for (std::size_t i = 0; i < wheels.size(); ++i) {
    const WheelView& wheel = wheels[i];
    if (wheel.load <= 0) continue;
    SoilSample soil = terrain.Soil(0, 0);
    soil.cone_index = wheel.cone_index;
    const int pass = i < 2 ? 2 : 1;  // rear axle first
    deepest = std::max(deepest, WheelSinkage(vehicle.wheels[i].tire, soil, wheel.load,
                                             wheel.deflection, wheel.slip, pass, options));
  }
  return deepest;
}

void ExpectTheSameBits(const Terrain& terrain, const VehicleModel& vehicle,
                       const SinkageOptions& options) {
  DeepestSinkage sinkage(terrain, vehicle, options);
  std::mt19937 random(7);
  for (int i = 0; i < 2000; ++i) {
    const std::vector<WheelView> wheels = RandomWheels(random);
    EXPECT_EQ(sinkage.Of(wheels), DeepestByHand(terrain, vehicle, wheels, options));
  }
}

TEST(DeepestSinkage, IsThatOfEveryWheelAskedAlone) {
  const Terrain terrain = SurfaceTerrain(20, 20, 1, [](double, double) { return 0.0; });
  VehicleModel vehicle = *LoadVehicle("tomcar-tm27");
  ASSERT_LT(vehicle.axles[static_cast<std::size_t>(vehicle.wheels[0].axle)].x,
            vehicle.axles[static_cast<std::size_t>(vehicle.wheels[2].axle)].x);
  ExpectTheSameBits(terrain, vehicle, {});
  ExpectTheSameBits(terrain, vehicle, {.multipass_exponent = 3});
  vehicle.wheels[1].tire.width *= 2;
  ExpectTheSameBits(terrain, vehicle, {});
}

TEST(DeepestSinkage, KnowsWhatIsNegligible) {
  const Terrain terrain = SurfaceTerrain(20, 20, 1, [](double, double) { return 0.0; });
  const auto vehicle = LoadVehicle("tomcar-tm27");
  constexpr double kNegligible = 0.1;
  DeepestSinkage sinkage(terrain, *vehicle, {}, kNegligible), exact(terrain, *vehicle, {});
  std::mt19937 random(8);
  double most = 0;
  int known = 0, deep = 0;
  for (int i = 0; i < 2000; ++i) {
    const std::vector<WheelView> wheels = RandomWheels(random);
    const double depth = exact.Of(wheels);
    if (sinkage.IsNegligible(wheels)) {
      EXPECT_LE(depth, most);
      ++known;
    } else {
      EXPECT_EQ(sinkage.Of(wheels), depth);
      if (depth <= kNegligible) most = std::max(most, depth);
      deep += depth > kNegligible;
    }
  }
  EXPECT_GT(known, 100);
  EXPECT_GT(deep, 100);
}

TEST(DeepestSinkage, NothingTouchesTheGround) {
  const Terrain terrain = SurfaceTerrain(20, 20, 1, [](double, double) { return 0.0; });
  const auto vehicle = LoadVehicle("tomcar-tm27");
  EXPECT_EQ(DeepestSinkage(terrain, *vehicle, {}).Of(std::vector<WheelView>(4)), 0);
}

}  // namespace
}  // namespace dbd
