#include <dbd/core/scene.h>

#include <dbd/core/scenario.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/core_vehicle.h"

namespace dbd {
namespace {

std::shared_ptr<const VehicleModel> Car() {
  static const auto car = LoadVehicle("tomcar-tm27");
  return car;
}

SceneVehicle CarAt(double x, int ahead = -1) {
  return {.model = Car(), .position = {x, 0}, .ahead = ahead};
}

/// One item at a time, from the last to the first, with two workers by turns.
class BackwardExecutor final : public LockstepExecutor {
 public:
  int worker_count() const override { return 2; }
  void Run(std::int64_t rounds, int items, const RoundFunction& work) override {
    for (std::int64_t round = 0; round < rounds; ++round) {
      for (int item = items; item-- > 0;) work(item % 2, round, item, item + 1);
    }
  }
};

/// With drivers that follow the x axis at `speed`, `spacing` between steering origins.
std::vector<SceneVehicle> Convoy(int count, double spacing, double speed) {
  DriverOptions options;
  options.target_speed = speed;
  const auto driver = std::make_shared<const Driver>(*Car(), Path({{-200, 0}, {500, 0}}), options);
  std::vector<SceneVehicle> vehicles;
  for (int i = 0; i < count; ++i) {
    vehicles.push_back(CarAt(-spacing * i, i - 1));
    vehicles.back().driver = driver;
  }
  return vehicles;
}

TEST(Scene, VehiclesFarApartMoveAsInSimulationsOfTheirOwnBitByBit) {
  const auto ground = MakeRandomGround(-80, 0.1, 0.5, 3);
  Scene scene(Convoy(3, 40, 5), *ground);
  SerialExecutor serial;
  scene.Advance(1.0, serial);
  // Gaps of 37 m allow 23 m/s: no driver is held back.
  for (int i = 0; i < 3; ++i) {
    Simulation alone(*Car(), *ground);
    alone.Place({-40.0 * i, 0}, 0);
    const SceneVehicle vehicle = Convoy(3, 40, 5)[static_cast<std::size_t>(i)];
    DriverState state;
    while (alone.time() < 1.0 - 1e-9) {
      const DriverView view = alone.ViewForDriver();
      alone.Advance(vehicle.driver->Update(view, alone.control_step(), state));
    }
    EXPECT_EQ(scene.StateHash(i), alone.StateHash()) << i;
    EXPECT_EQ(scene.Chassis(i).p_WB, alone.Chassis().p_WB) << i;
  }
}

TEST(Scene, OrderAndDivisionOfTheVehiclesChangeNoBit) {
  const auto ground = MakeRandomGround(-30, 0.1, 0.5, 4);
  const auto drive = [&](LockstepExecutor& executor) {
    Scene scene(Convoy(4, 3.2, 4), *ground);  // 0.3 m between bumpers
    scene.Advance(1.5, executor);
    return scene.StateHash();
  };
  SerialExecutor serial;
  BackwardExecutor backward;
  EXPECT_EQ(drive(serial), drive(backward));
}

TEST(Scene, LengthOfAdvancesChangesNoBit) {
  const auto ground = MakePlaneGround(0, 0);
  SerialExecutor serial;
  Scene once(Convoy(2, 4, 4), *ground), often(Convoy(2, 4, 4), *ground);
  once.Advance(0.5, serial);
  for (int i = 0; i < 50; ++i) often.Advance(0.01, serial);
  EXPECT_EQ(once.StateHash(), often.StateHash());
  EXPECT_NEAR(often.time(), 0.5, 1e-12);
}

TEST(Scene, PushedVehicleMovesAndIsNotPassedThrough) {
  const auto ground = MakePlaneGround(0, 0);
  std::vector<SceneVehicle> vehicles{CarAt(0), CarAt(-3.5, 0)};
  vehicles[1].command.engine_torque = 40;  // in gear; nobody drives the one ahead
  Scene scene(vehicles, *ground);
  EXPECT_NEAR(scene.Gap(1), 0.6, 0.01);  // 3.5 m less a length of 2.9 m
  SerialExecutor serial;
  const double start = scene.Chassis(0).p_WB.x();
  double pressed = 0, deepest = 0;
  for (int i = 0; i < 400; ++i) {
    scene.Advance(0.01, serial);
    pressed = std::max(pressed, scene.BumperForce(1));
    deepest = std::min(deepest, scene.Gap(1));
  }
  EXPECT_GT(scene.Chassis(0).p_WB.x() - start, 2.0);
  EXPECT_GT(pressed, 1000);
  EXPECT_LT(pressed, 40e3);
  EXPECT_GT(deepest, -0.15);
  EXPECT_TRUE(scene.IsSane());
}

TEST(Scene, ConvoyKeepsTheConstantTimeGap) {
  const auto ground = MakePlaneGround(0, 0);
  Scene scene(Convoy(4, 8, 4), *ground);
  SerialExecutor serial;
  double smallest = 100;
  for (int i = 0; i < 250; ++i) {
    scene.Advance(0.1, serial);
    for (int v = 1; v < 4; ++v) smallest = std::min(smallest, scene.Gap(v));
  }
  // Steady: 3 m + 1.5 s * 4 m/s = 9 m.
  for (int v = 1; v < 4; ++v) {
    EXPECT_NEAR(scene.Chassis(v).forward_speed, 4.0, 0.1) << v;
    EXPECT_NEAR(scene.Gap(v), 9.0, 0.3) << v;
  }
  EXPECT_GT(smallest, 2.5);
}

TEST(Scene, ShortestConstructionStepHoldsForAll) {
  auto slow = std::make_shared<VehicleModel>(*Car());
  slow->steps.construction = slow->steps.spring = 1e-3;
  const auto ground = MakePlaneGround(0, 0);
  Scene scene({CarAt(0), {.model = slow, .position = {-20, 0}}}, *ground);
  EXPECT_EQ(scene.step(), 1e-3);
  EXPECT_EQ(scene.body_count(), 10);
}

TEST(Scene, StateOfAFiveBodyVehicleIsCompact) {
  const auto ground = MakePlaneGround(0, 0);
  const Scene scene({CarAt(0)}, *ground);
  EXPECT_LT(scene.StateBytes(0), 3072u);
}

TEST(Scene, RefusesWhatMakesNoSense) {
  const auto ground = MakePlaneGround(0, 0);
  const auto message = [&](const std::vector<SceneVehicle>& vehicles, SceneOptions options = {}) {
    return InputErrorOf([&] { Scene scene(vehicles, *ground, options); });
  };
  EXPECT_EQ(message({}), "scene: needs at least one vehicle");
  EXPECT_EQ(message({CarAt(0), CarAt(-5, 1)}),
            "scene: vehicle 1: ahead is 1, must be an earlier vehicle or -1");
  EXPECT_EQ(message({CarAt(0), CarAt(-5, 0), CarAt(-10, 0)}),
            "scene: vehicle 2: is behind vehicle 0, as is vehicle 1");
  EXPECT_EQ(message({SceneVehicle{}}), "scene: vehicle 0: needs a model");
  SceneVehicle towed = CarAt(0);
  towed.drawbar = DrawbarModel{};
  EXPECT_EQ(message({towed}), "scene: vehicle 0: has a drawbar but nothing ahead");
  towed.ahead = 0;
  towed.drawbar->length = 0;
  EXPECT_EQ(message({CarAt(0), towed}), "scene: vehicle 1: drawbar.length must be greater than 0");
  EXPECT_EQ(message({CarAt(0)}, {.gap = {.time_gap = 0}}),
            "scene: time_gap must be greater than 0");
}

}  // namespace
}  // namespace dbd
