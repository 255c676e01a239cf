#include <dbd/core/scenario.h>
#include <dbd/core/units.h>
#include <gtest/gtest.h>

#include "support/core_vehicle.h"

namespace dbd {
namespace {

TEST(Scenario, DefinitionsAfterThePaper) {
  EXPECT_EQ(ScenarioNames(), (std::vector<std::string>{"A", "B", "C", "D"}));
  EXPECT_EQ(MakeScenario("A").target_speed, 5);
  EXPECT_EQ(MakeScenario("B").target_speed, 2);
  EXPECT_EQ(MakeScenario("B").duration, 20);
  for (const std::string& name : ScenarioNames()) {
    const Scenario scenario = MakeScenario(name);
    EXPECT_EQ(scenario.name, name);
    EXPECT_EQ(scenario.standing_time, 2);
    EXPECT_GT(scenario.duration, scenario.standing_time);
    EXPECT_EQ(scenario.ground->Height(0, 0), 0);  // starts on the level
  }
}

TEST(Scenario, UnknownNameListsTheKnownOnes) {
  EXPECT_EQ(InputErrorOf([] { MakeScenario("E"); }),
            "scenario \"E\" is not known; there are A, B, C and D");
}

TEST(Scenario, BumpIsAHalfCylinder) {
  const auto ground = MakeBumpGround(15, 0.1);
  EXPECT_DOUBLE_EQ(ground->Height(15, 3), 0.1);
  EXPECT_NEAR(ground->Height(15.06, -2), 0.08, 1e-12);  // 3-4-5
  EXPECT_EQ(ground->Height(15.1001, 0), 0);
}

TEST(Scenario, WavesHaveTheirLengthAndAmplitude) {
  const auto ground = MakeSineGround(5, 30, 0.1, 5);
  EXPECT_NEAR(ground->Height(6.25, 0), 0.1, 1e-12);
  EXPECT_NEAR(ground->Height(8.75, 9), -0.1, 1e-12);
  EXPECT_NEAR(ground->Height(27.5, 0), 0, 1e-12);
  EXPECT_EQ(ground->Height(4, 0), 0);
  EXPECT_EQ(ground->Height(31, 0), 0);
}

TEST(Scenario, RandomRoadIsDrawnByItsSeed) {
  const auto a = MakeRandomGround(3, 0.2, 0.5, 1), b = MakeRandomGround(3, 0.2, 0.5, 1);
  const auto other = MakeRandomGround(3, 0.2, 0.5, 2);
  double low = 1, high = -1, sum = 0, difference = 0;
  int count = 0;
  for (double x = 4; x < 200; x += 0.5) {
    for (double y = -5; y < 5; y += 0.5) {
      const double z = a->Height(x, y);
      EXPECT_EQ(z, b->Height(x, y));
      difference += std::abs(z - other->Height(x, y));
      low = std::min(low, z), high = std::max(high, z), sum += z, ++count;
    }
  }
  EXPECT_GE(low, 0);
  EXPECT_LE(high, 0.2);
  EXPECT_NEAR(sum / count, 0.1, 0.005);             // uniform: half the amplitude
  EXPECT_NEAR(difference / count, 0.2 / 3, 0.005);  // mean distance of two uniform numbers
  EXPECT_LT(low, 0.01);
  EXPECT_GT(high, 0.19);
}

TEST(Scenario, RandomRoadIsBilinearBetweenItsNodes) {
  const auto g = MakeRandomGround(3, 0.2, 0.5, 1);
  const double corners =
      g->Height(10, 1) + g->Height(10.5, 1) + g->Height(10, 1.5) + g->Height(10.5, 1.5);
  EXPECT_NEAR(g->Height(10.25, 1.25), corners / 4, 1e-12);
  EXPECT_EQ(g->Height(2, 0.3), 0);
}

TEST(Scenario, PlaneHasItsGradesAndSoil) {
  const auto ground = MakePlaneGround(0.1, -0.2, {4e5, 0.5});
  EXPECT_NEAR(ground->Height(3, 4), 0.3 - 0.8, 1e-15);
  EXPECT_EQ(ground->Soil(1, 1).cone_index, 4e5);
  EXPECT_EQ(ground->Soil(1, 1).friction_limit, 0.5);
}

class HighestWithin : public ::testing::TestWithParam<std::shared_ptr<const Ground>> {};

TEST_P(HighestWithin, IsAnUpperBoundOfTheHeightsAround) {
  const Ground& ground = *GetParam();
  for (double x = -3; x < 35; x += 0.77) {
    for (const double y : {-4.0, 0.1, 3.3}) {
      for (const double radius : {0.1, 0.44, 1.5}) {
        double bound = 0;
        ground.HighestWithin(radius, 1, &x, &y, &bound);
        for (double dx = -radius; dx <= radius; dx += radius / 8) {
          const double reach = std::sqrt(radius * radius - dx * dx);
          for (const double dy : {-reach, -0.5 * reach, 0.0, 0.5 * reach, reach}) {
            ASSERT_GE(bound, ground.Height(x + dx, y + dy) - 1e-12) << x << " " << y;
          }
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Grounds, HighestWithin,
                         ::testing::Values(MakeBumpGround(15, 0.1), MakeSineGround(5, 30, 0.1, 5),
                                           MakeRandomGround(3, 0.2, 0.5, 1),
                                           MakePlaneGround(0.3, -0.4)));

struct Drive {
  double distance = 0, highest_pitch = 0, highest_load = 0, final_speed = 0;
  bool sane = true;
};

Drive Complete(const std::string& name) {
  const Scenario scenario = MakeScenario(name);
  Simulation simulation = StartScenario(scenario, Tm27());
  ScenarioDriver driver(scenario, Tm27());
  Drive drive;
  while (simulation.time() < scenario.duration) {
    driver.Advance(simulation);
    const ChassisView chassis = simulation.Chassis();
    drive.highest_pitch = std::max(drive.highest_pitch, std::abs(chassis.pitch));
    for (int i = 0; i < 4; ++i) {
      drive.highest_load = std::max(drive.highest_load, simulation.Wheel(i).load);
    }
    drive.sane = drive.sane && simulation.IsSane();
    drive.distance = chassis.p_WB.x();
    drive.final_speed = chassis.forward_speed;
    EXPECT_LT(std::abs(chassis.p_WB.y()), 0.5);
  }
  return drive;
}

// Largest pitch and load of an independent prototype: 3.8 / 5.8 / 3.8 / 7.6 deg, 7.2 / 3.2 / 5.3 /
// 7.3 kN; C and D depend on the drawn road.
TEST(ScenarioDrive, ABump) {
  const Drive drive = Complete("A");
  EXPECT_TRUE(drive.sane);
  EXPECT_GT(drive.distance, 30);
  EXPECT_NEAR(ToDegrees(drive.highest_pitch), 3.8, 0.6);
  EXPECT_NEAR(drive.highest_load, 7200, 1500);
  EXPECT_NEAR(drive.final_speed, 5, 0.3);
}

TEST(ScenarioDrive, BWaves) {
  const Drive drive = Complete("B");
  EXPECT_TRUE(drive.sane);
  EXPECT_GT(drive.distance, 30);
  EXPECT_NEAR(ToDegrees(drive.highest_pitch), 5.8, 0.6);
  EXPECT_NEAR(drive.highest_load, 3200, 400);
}

TEST(ScenarioDrive, CAndDRoughRoads) {
  for (const char* name : {"C", "D"}) {
    const Drive drive = Complete(name);
    EXPECT_TRUE(drive.sane) << name;
    EXPECT_GT(drive.distance, 8) << name;
    EXPECT_LT(ToDegrees(drive.highest_pitch), 15) << name;
    EXPECT_LT(drive.highest_load, 15e3) << name;
  }
}

}  // namespace
}  // namespace dbd
