#include <dbd/core/units.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "support/core_vehicle.h"

namespace dbd {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::StartsWith;

std::shared_ptr<const VehicleModel> Changed(const std::function<void(json&)>& change) {
  json file = Tm27Json();
  change(file);
  return ParseVehicle(file.dump(), "v.json");
}

struct BadFile {
  const char* name;
  std::function<void(json&)> change;
  const char* message;  // beginning of what must be said
};

class VehicleFileErrors : public ::testing::TestWithParam<BadFile> {};

TEST_P(VehicleFileErrors, OneLineNamesFileKeyValueAndRule) {
  const std::string message = InputErrorOf([] { Changed(GetParam().change); });
  EXPECT_THAT(message, StartsWith(GetParam().message));
  EXPECT_EQ(message.find('\n'), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(
    VehicleFile, VehicleFileErrors,
    ::testing::Values(
        BadFile{"WrongKey", [](json& f) { f["chassis"]["weight"] = 5; },
                R"(v.json: chassis.weight: is not a known key; did you mean ")"},
        BadFile{"MisspeltOptionalKey", [](json& f) { f["axles"][0]["tire"]["lateral_rat"] = 5; },
                R"(v.json: axles[0].tire.lateral_rat: is not a known key; did you mean )"
                R"("lateral_rate"?)"},
        BadFile{"UnknownTopKey", [](json& f) { f["powertrian"] = 1; },
                R"(v.json: powertrian: is not a known key; did you mean "powertrain"?)"},
        BadFile{"NegativeMass", [](json& f) { f["chassis"]["mass"] = -612.9; },
                "v.json: chassis.mass: is -612.9, must be between 1e-06 and 100000"},
        BadFile{"ZeroCarrierMass",
                [](json& f) { f["axles"][0]["suspension"]["carrier"]["mass"] = 0; },
                "v.json: axles[0].suspension.carrier.mass: is 0, must be between"},
        BadFile{"ImpossibleInertia",
                [](json& f) {
                  f["chassis"]["inertia"] = {1, 1, 3};
                },
                "v.json: chassis.inertia: one moment is larger than the sum of the others"},
        BadFile{"NegativeInertia",
                [](json& f) {
                  f["chassis"]["inertia"] = {1, -1, 1};
                },
                "v.json: chassis.inertia: must be positive in all three axes"},
        BadFile{"MissingKey", [](json& f) { f["axles"][1]["tire"].erase("radius"); },
                "v.json: axles[1].tire.radius: is missing"},
        BadFile{"WrongSchema", [](json& f) { f["schema"] = "dbd.vehicle/9"; },
                R"(v.json: schema: is "dbd.vehicle/9", must be "dbd.vehicle/1")"},
        BadFile{"TextInsteadOfNumber", [](json& f) { f["reference_height"] = "high"; },
                R"(v.json: reference_height: is "high", must be a number)"},
        BadFile{"MassCentreOutsideTheAxles",
                [](json& f) {
                  f["chassis"]["center_of_mass"] = {2.35, 0, 0.094};
                },
                R"(v.json: axles: wheel "rear left" carries -)"},
        BadFile{"UnknownSuspension", [](json& f) { f["axles"][0]["suspension"]["type"] = "leaf"; },
                R"(v.json: axles[0].suspension.type: is "leaf", must be )"},
        BadFile{"UnknownDifferential",
                [](json& f) { f["axles"][0]["differential"]["type"] = "magic"; },
                R"(v.json: axles[0].differential.type: is "magic", must be open, )"},
        BadFile{"FractionalPoints", [](json& f) { f["axles"][0]["tire"]["points"] = 30.5; },
                "v.json: axles[0].tire.points: is 30.5, must be whole"},
        BadFile{"TooFewPoints", [](json& f) { f["axles"][0]["tire"]["points"] = 8; },
                "v.json: axles[0].tire.points: is 8, must be between 12 and 64"},
        BadFile{"RightWheelGiven",
                [](json& f) {
                  f["axles"][0]["center"] = {0, -0.754};
                },
                "v.json: axles[0].center: must be the left wheel's"},
        BadFile{"NothingDriven", [](json& f) { f["axles"][0]["driven"] = false; },
                "v.json: axles: none is driven"},
        BadFile{"NothingSteers",
                [](json& f) {
                  f["axles"][1]["steer_ratio"] = 0;
                  f["axles"][1].erase("max_steer_deg");
                },
                "v.json: axles: none steers"},
        BadFile{"OneAxle", [](json& f) { f["axles"].erase(0); },
                "v.json: axles: needs at least two"},
        BadFile{"NoGear", [](json& f) { f["powertrain"]["gear_ratios"] = json::array(); },
                "v.json: powertrain.gear_ratios: needs at least one gear"},
        BadFile{"NegativeGear",
                [](json& f) {
                  f["powertrain"]["gear_ratios"] = {3, -1};
                },
                "v.json: powertrain.gear_ratios: must all be greater than 0"},
        BadFile{"ShortPoint",
                [](json& f) {
                  f["chassis"]["center_of_mass"] = {1, 2};
                },
                "v.json: chassis.center_of_mass: is [1,2], must be a list of 3 numbers"}),
    [](const auto& param) { return std::string(param.param.name); });

TEST(VehicleFile, RefusesTextThatIsNotJson) {
  EXPECT_EQ(InputErrorOf([] { ParseVehicle("{\"schema\":", "v.json"); }),
            "v.json: is not valid JSON");
}

TEST(VehicleFile, ReadsTheTm27) {
  const VehicleModel& v = Tm27();
  EXPECT_EQ(v.bodies.size(), 5u);  // chassis and four wheel carriers
  EXPECT_EQ(v.links.size(), 18u);  // four for each wheel and two tie rods
  EXPECT_EQ(v.springs.size(), 4u);
  EXPECT_EQ(v.joints.size(), 6u);  // toe everywhere, camber at the rear
  EXPECT_EQ(v.wheels.size(), 4u);
  EXPECT_TRUE(v.axles[0].driven);
  EXPECT_FALSE(v.axles[1].driven);
  // Torque at 3000 rpm: -3e-6 * 9e6 + 0.0193 * 3000 + 58.378 = 89.278 N m.
  const auto& [a, b, c] = v.powertrain.torque_polynomial;
  const double w = Rpm(3000);
  EXPECT_NEAR((a * w + b) * w + c, 89.278, 1e-9);
}

TEST(VehicleFile, TireStiffnessIsEstimatedOnlyWhenNotGiven) {
  EXPECT_NEAR(Tm27().wheels[0].tire.stiffness, 235152, 1);  // Lines & Murphy, rear
  const auto soft = Changed([](json& f) { f["axles"][0]["tire"]["stiffness"] = 75000; });
  EXPECT_EQ(soft->wheels[0].tire.stiffness, 75000);
}

TEST(VehicleFile, StepsOverrideTheRuleAndAreSynchronised) {
  const auto v = Changed([](json& f) {
    f["steps"] = {{"construction", 1e-3}, {"tire", 2.5e-3}, {"control", 10e-3}};
  });
  EXPECT_DOUBLE_EQ(v->steps.construction, 1e-3);
  EXPECT_DOUBLE_EQ(v->steps.tire, 2e-3);  // whole multiple, never slower than asked
  EXPECT_DOUBLE_EQ(v->steps.control, 10e-3);
  EXPECT_DOUBLE_EQ(v->steps.spring, 2e-3);  // not given: as the rule chose
}

TEST(VehicleFile, FreeLengthMayBeGiven) {
  const auto v =
      Changed([](json& f) { f["axles"][0]["suspension"]["spring"]["free_length"] = 0.65; });
  EXPECT_EQ(v->springs[0].free_length, 0.65);
}

TEST(VehicleFile, WheelsOnBothSidesMirrorEachOther) {
  const VehicleModel& v = Tm27();
  for (const AxleModel& axle : v.axles) {
    const Eigen::Vector3d left = v.bodies[v.wheels[axle.left].body].p_RB;
    const Eigen::Vector3d right = v.bodies[v.wheels[axle.right].body].p_RB;
    EXPECT_EQ(left, Eigen::Vector3d(right.x(), -right.y(), right.z()));
    EXPECT_GT(left.y(), 0);
  }
}

}  // namespace
}  // namespace dbd
