#include "solid_axle.h"

#include <dbd/core/units.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "support/core_engine.h"
#include "support/core_vehicle.h"

namespace dbd {
namespace {

using nlohmann::json;
using ::testing::StartsWith;

std::shared_ptr<const VehicleModel> Utility(const std::function<void(json&)>& change) {
  json file = json::parse(BuiltInVehicleText("utility-4x4"));
  change(file);
  return ParseVehicle(file.dump(), "v.json");
}

TEST(SolidAxle, OneBodyCarriesBothWheelsOnMirroredLinks) {
  const auto vehicle = Utility([](json&) {});
  EXPECT_EQ(vehicle->bodies.size(), 4u);  // chassis, rear axle, two front carriers
  EXPECT_EQ(vehicle->bodies[1].name, "rear axle");
  int links = 0;
  for (const LinkModel& link : vehicle->links) links += link.body_b == 1;
  EXPECT_EQ(links, 5);  // two pairs of arms and a rod
  for (const int side : {0, 1}) {
    const WheelModel& wheel = vehicle->wheels[static_cast<std::size_t>(side)];
    EXPECT_EQ(wheel.body, 1);
    EXPECT_EQ(wheel.reaction_body, 1);
    EXPECT_FALSE(wheel.steers_hub);
    EXPECT_NEAR(wheel.p_BH.y(), side == 0 ? 0.785 : -0.785, 1e-12);
  }
}

TEST(SolidAxle, SteeredWheelsTurnOnTheAxle) {
  const auto truck = LoadVehicle("truck-6x6");
  for (const WheelModel& wheel : truck->wheels) {
    EXPECT_EQ(wheel.steers_hub, wheel.name.starts_with("front")) << wheel.name;
  }
}

TEST(SolidAxle, SpringsCarryWhatTheAxleItselfDoesNotWeigh) {
  const auto vehicle = Utility([](json&) {});
  const double carried = 2 * vehicle->wheels[0].static_load - 220 * kGravity;
  for (const int i : {0, 1}) {
    const SpringModel& spring = vehicle->springs[static_cast<std::size_t>(i)];
    const double length =
        vehicle->bodies[0].p_RB.z() + spring.p_A.z() - vehicle->bodies[1].p_RB.z() - spring.p_B.z();
    // The Panhard rod and the slightly inclined arms carry a few newtons.
    EXPECT_NEAR(spring.stiffness * (spring.free_length - length), 0.5 * carried, 0.01 * carried);
  }
}

TEST(SpringFile, CurveAndStopsLeaveTheDesignPoseInBalance) {
  const auto linear = Utility([](json&) {});
  const auto curved = Utility([](json& file) {
    json& spring = file["axles"][0]["suspension"]["spring"];
    spring.erase("stiffness");
    spring["curve"] = {{"deflection", {-0.1, 0.0, 0.1, 0.2}}, {"force", {-1000, 0, 4000, 12000}}};
  });
  const SpringModel& a = linear->springs[0];
  const SpringModel& b = curved->springs[0];
  const double length =
      linear->bodies[0].p_RB.z() + a.p_A.z() - linear->bodies[1].p_RB.z() - a.p_B.z();
  EXPECT_NEAR(StrutForce(b, length, 0.0), StrutForce(a, length, 0.0), 1);
  EXPECT_EQ(b.stiffness, 80000);
}

TEST(BumpStop, PushesBackOnBothSidesAndNeverPulls) {
  SpringModel spring;
  spring.stiffness = 1000;
  spring.free_length = 0.5;
  spring.bump_stop.stiffness = 1e5;
  spring.bump_stop.progression = 0.02;
  spring.bump_stop.damping = 1000;
  spring.bump_stop.shortest_length = 0.4;
  spring.bump_stop.longest_length = 0.6;
  EXPECT_NEAR(StrutForce(spring, 0.45, -1.0), 50, 1e-9);
  // 10 mm into the stop: 1e5 * 0.01 * (1 + 0.01 / 0.04) = 1250 N, and 110 N of the spring.
  EXPECT_NEAR(StrutForce(spring, 0.39, 0.0), 1360, 1e-9);
  EXPECT_NEAR(StrutForce(spring, 0.61, 0.0), -1360, 1e-9);
  EXPECT_NEAR(StrutForce(spring, 0.39, -10.0), 110 + 2500, 1e-9);  // at most doubled
  EXPECT_NEAR(StrutForce(spring, 0.39, 10.0), 110, 1e-9);          // lets go, no pull
}

TEST(SpringFile, DampingCurveHasItsOwnRebound) {
  const auto vehicle = Utility([](json&) {});
  const SpringModel& spring = vehicle->springs[0];
  const double rest = StrutForce(spring, 0.35, 0.0);
  EXPECT_NEAR(StrutForce(spring, 0.35, -0.2) - rest, 340, 1e-6);  // compression
  EXPECT_NEAR(StrutForce(spring, 0.35, 0.2) - rest, -580, 1e-6);  // rebound
}

TEST(TransferCase, RangeChoosesTheRatio) {
  EXPECT_EQ(Utility([](json&) {})->powertrain.transfer_ratio, 1.0);
  const auto low = Utility([](json& file) { file["powertrain"]["range"] = "low"; });
  EXPECT_EQ(low->powertrain.transfer_ratio, 2.57);
}

TEST(SolidAxleFile, ErrorsNameKeyAndRule) {
  const auto message = [](const std::function<void(json&)>& change) {
    return InputErrorOf([&] { Utility(change); });
  };
  EXPECT_THAT(message([](json& f) { f["axles"][0]["suspension"].erase("links"); }),
              StartsWith("v.json: axles[0].suspension.link_rate: is not a known key"));
  EXPECT_THAT(message([](json& f) {
                auto& suspension = f["axles"][0]["suspension"];
                suspension.erase("links");
                suspension.erase("link_rate");
                suspension.erase("spring");
              }),
              StartsWith("v.json: axles: nothing holds the \"rear axle\""));
  EXPECT_THAT(message([](json& f) { f["powertrain"]["range"] = "middle"; }),
              StartsWith("v.json: powertrain.range: is \"middle\", must be high or low"));
  EXPECT_THAT(message([](json& f) { f["contacts"][0]["body"] = "rear axel"; }),
              StartsWith("v.json: contacts[0].body: is \"rear axel\", not the name of a body; did "
                         "you mean \"rear axle\"?"));
  EXPECT_THAT(message([](json& f) {
                f["axles"][0]["suspension"]["spring"]["damping_curve"]["force"] = {1, 2, 3, 4, 5};
              }),
              StartsWith("v.json: axles[0].suspension.spring.damping_curve: must pass through"));
}

}  // namespace
}  // namespace dbd
