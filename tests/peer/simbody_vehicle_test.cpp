#include "simbody_vehicle.h"

#include <dbd/core/scenario_record.h>
#include <dbd/core/vehicle_variant.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "support/core_vehicle.h"
#include "suspension_corner.h"

namespace dbd {
namespace {

const VehicleModel& Vehicle() {
  static const VehicleModel vehicle = WithReferenceTires(Tm27());
  return vehicle;
}

GuideForces Guide(const Scenario& scenario) {
  return {.target_speed = scenario.target_speed, .standing_time = scenario.standing_time};
}

PeerDrive Drive(const Scenario& scenario, const PeerOptions& options = {}) {
  return DriveWithSimbody(scenario, Vehicle(), Guide(scenario), options);
}

void ExpectAgreement(const std::vector<SignalAgreement>& agreement, double r_squared, double rms) {
  EXPECT_GE(agreement.size(), 6u);
  for (const SignalAgreement& signal : agreement) {
    if (signal.name.starts_with("Ft_") || signal.name.starts_with("zw_")) continue;
    EXPECT_GE(signal.r_squared, r_squared) << signal.name;
    EXPECT_LE(signal.rms, rms) << signal.name;
  }
}

// Ideal links carry what the springs leave: loads and spring forces of the statics by hand, and no
// motion from the design pose. 2 (1439.977 + 2238.773) N = 750 kg * 9.81 m/s^2.
TEST(SimbodyVehicle, DesignPoseIsTheEquilibrium) {
  Scenario scenario = MakeScenario("A");
  scenario.duration = 1;
  const PeerDrive drive = Drive(scenario, {.accuracy = 1e-6, .constraint_tolerance = 1e-9});
  ASSERT_EQ(drive.rows.size(), 251u);
  for (const TrajectoryRow& row : {drive.rows.front(), drive.rows.back()}) {
    EXPECT_NEAR(row.z_ref, 0.381, 1e-6);
    EXPECT_NEAR(row.x_cg, 0.784, 1e-6);
    EXPECT_NEAR(row.pitch, 0, 1e-6);
    EXPECT_NEAR(row.roll, 0, 1e-6);
    EXPECT_NEAR(row.tire_force[0], 1439.977, 0.1);
    EXPECT_NEAR(row.tire_force[3], 2238.773, 0.1);
    EXPECT_NEAR(row.spring_force[1], 2848.872, 0.1);
    EXPECT_NEAR(row.spring_force[2], 3822.042, 0.1);
  }
}

// What an ideal rod carries at rest is the tension that the trim has given the stiff link, but for
// the 5 % that come from the toe joint, which takes over a part of the inclined tie rod's load.
TEST(SimbodyVehicle, FrontLinkCarriesWhatTheStiffLinkDoes) {
  Scenario scenario = MakeScenario("A");
  scenario.duration = 0.1;
  const PeerDrive drive =
      Drive(scenario, {.accuracy = 1e-6, .constraint_tolerance = 1e-9, .link_forces = true});
  ASSERT_EQ(drive.front_link_force.size(), drive.rows.size());
  Simulation simulation(Vehicle(), *scenario.ground,
                        {.tire = TireKind::kVerticalDisc, .guide = Guide(scenario)});
  simulation.Place(Eigen::Vector2d::Zero(), 0);
  simulation.Advance({});
  const int link = FindCorner(Vehicle(), WheelOrder(Vehicle())[0]).upper_links.front();
  EXPECT_NEAR(drive.front_link_force.back(), simulation.LinkForce(link), 30);
  EXPECT_LT(simulation.LinkForce(link), -500);
}

TEST(SimbodyVehicle, RefusesAnUnknownIntegrator) {
  Scenario scenario = MakeScenario("A");
  scenario.duration = 0.1;
  EXPECT_EQ(InputErrorOf([&] { Drive(scenario, {.integrator = "guess"}); }),
            "integrator \"guess\" is not known; there are merson, runge-kutta-3 and cpodes");
}

// Two formulations and two codes: springs in the place of joints against constraints.
TEST(SimbodyVehicle, AgreesWithStiffLinks) {
  Scenario scenario = MakeScenario("A");
  scenario.duration = 8;  // over the bump and two swings
  const VehicleModel stiff = WithSteps(WithLinkStiffness(Vehicle(), 10), 0.5);
  const SimulationOptions rig{.tire = TireKind::kVerticalDisc, .guide = Guide(scenario)};
  const auto rows = RecordScenario(scenario, stiff, rig);
  ExpectAgreement(CompareTrajectories(rows, Drive(scenario).rows), 0.998, 0.01);
}

// A third code with ideal joints; where its trajectories are there. 0.1 % of the range is ten times
// what the error control leaves.
TEST(SimbodyVehicle, AgreesWithTheReferenceTrajectory) {
  const std::string file = std::string(DBD_SHARED_DATA) + "/../reference/tm27-multibody/A.csv";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no reference data";
  Scenario scenario = MakeScenario("A");
  scenario.duration = 8;
  const PeerDrive drive = Drive(scenario, {.accuracy = 1e-4, .constraint_tolerance = 1e-6});
  ExpectAgreement(CompareTrajectories(drive.rows, ReadTrajectory(file)), 0.9999, 0.001);
}

}  // namespace
}  // namespace dbd
