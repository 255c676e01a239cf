#include <dbd/core/scenario_record.h>
#include <dbd/core/units.h>
#include <dbd/core/vehicle_variant.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "support/core_vehicle.h"

namespace dbd {
namespace {

TEST(RecordScenario, KeepsARowEveryFourMilliseconds) {
  Scenario scenario = MakeScenario("A");
  scenario.duration = 1;
  std::vector<double> times;
  const auto rows = RecordScenario(scenario, Tm27(), {}, [&times](const Simulation& simulation) {
    times.push_back(simulation.time());
  });
  ASSERT_EQ(rows.size(), 251u);
  ASSERT_EQ(times.size(), 251u);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_NEAR(rows[i].t, 0.004 * static_cast<double>(i), 1e-9);
    EXPECT_EQ(rows[i].t, times[i]);
  }
}

// Statics of the reference: half of the weight, 750 kg * 9.81 / 2 = 3678.75 N, is 1439.977 N in
// front and 2238.773 N behind; springs at half of the arm carry 2848.872 and 3822.042 N.
TEST(RecordScenario, RigAndDiscTireStandAsTheReferenceDoes) {
  Scenario scenario = MakeScenario("A");
  scenario.duration = 1;
  const SimulationOptions rig{.tire = TireKind::kVerticalDisc, .guide = GuideForces{}};
  const auto rows = RecordScenario(scenario, WithReferenceTires(Tm27()), rig);
  EXPECT_NEAR(rows.back().tire_force[0], 1439.977, 1);
  EXPECT_NEAR(rows.back().tire_force[2], 2238.773, 1);
  EXPECT_NEAR(rows.back().spring_force[1], 2848.872, 1);
  EXPECT_NEAR(rows.back().spring_force[3], 3822.042, 1);
  EXPECT_NEAR(rows.back().z_ref, 0.381, 1e-4);
  EXPECT_NEAR(rows.back().wheel_height[0], 0.310544, 1e-5);
  EXPECT_NEAR(rows.back().wheel_height[2], 0.320673, 1e-5);
}

// On level ground a vehicle's springs and tires do not depend on the side; rigid axles have none.
TEST(RecordScenario, EveryVehicleHasARow) {
  for (const std::string& name : BuiltInVehicleNames()) {
    const auto vehicle = LoadVehicle(name);
    Scenario scenario = MakeScenario("A");
    scenario.duration = 0.1;
    const TrajectoryRow row = RecordScenario(scenario, *vehicle).back();
    double front_and_rear = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_GT(row.tire_force[i], 0) << name;
      front_and_rear += row.tire_force[i];
    }
    EXPECT_NEAR(row.spring_force[0], row.spring_force[1], 0.02 * front_and_rear) << name;
    EXPECT_NEAR(row.spring_force[2], row.spring_force[3], 0.02 * front_and_rear) << name;
    const double weight = kGravity * vehicle->total_mass();
    if (vehicle->axles.size() == 2) {
      EXPECT_NEAR(front_and_rear, weight, 0.02 * weight) << name;
    } else {
      EXPECT_LT(front_and_rear, 0.9 * weight) << name;  // the middle axle carries the rest
    }
  }
}

/// Trajectories of a constraint-based multibody program, one per scenario; skipped where they are
/// absent.
class ReferenceTrajectory : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(Path(GetParam() + ".csv"))) GTEST_SKIP() << "no reference data";
  }

  static std::string Path(const std::string& file) {
    return std::string(DBD_SHARED_DATA) + "/../reference/tm27-multibody/" + file;
  }

  static std::vector<SignalAgreement> Agreement(double link_stiffness, double step_factor) {
    Scenario scenario = MakeScenario(GetParam());
    if (GetParam() == "C") scenario.ground = ReadGridGround(Path("terrain_C.csv"));
    const VehicleModel vehicle =
        WithSteps(WithLinkStiffness(WithReferenceTires(Tm27()), link_stiffness), step_factor);
    const SimulationOptions rig{.tire = TireKind::kVerticalDisc,
                                .guide = GuideForces{.target_speed = scenario.target_speed}};
    return CompareTrajectories(RecordScenario(scenario, vehicle, rig),
                               ReadTrajectory(Path(GetParam() + ".csv")));
  }

  /// Height, pitch, roll and the four springs, as far as they move in this scenario.
  static bool IsCompared(const std::string& signal) {
    return signal == "z_cg" || signal == "pitch" || signal == "roll" || signal.starts_with("Fs_");
  }
};

TEST_P(ReferenceTrajectory, IsTheLimitOfStiffLinks) {
  int compared = 0;
  for (const SignalAgreement& signal : Agreement(10, 0.5)) {
    if (!IsCompared(signal.name)) continue;
    EXPECT_GE(signal.r_squared, 0.998) << signal.name;
    EXPECT_LE(signal.rms, 0.01) << signal.name;
    EXPECT_LE(signal.peak_error, 0.03) << signal.name;
    ++compared;
  }
  EXPECT_EQ(compared, GetParam() == "C" ? 7 : 6);  // A and B do not roll
}

// The paper claims R2 > 0.9 for its links.
TEST_P(ReferenceTrajectory, IsMetByThePapersLinks) {
  for (const SignalAgreement& signal : Agreement(1, 1)) {
    if (!IsCompared(signal.name)) continue;
    EXPECT_GT(signal.r_squared, 0.9) << signal.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Scenarios, ReferenceTrajectory, testing::Values("A", "B", "C"),
                         [](const auto& scenario) { return scenario.param; });

}  // namespace
}  // namespace dbd
