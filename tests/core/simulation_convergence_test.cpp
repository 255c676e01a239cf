#include <dbd/core/scenario.h>
#include <dbd/core/simulation.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/core_vehicle.h"

namespace dbd {
namespace {

VehicleModel WithSteps(double construction) {
  VehicleModel v = Tm27();
  v.steps = {construction, construction, 2 * construction, 4e-3};
  return v;
}

/// Chassis height every 0.02 m of a drive over waves of 5 m and 0.1 m at constant engine torque.
std::vector<double> HeightsAlong(const VehicleModel& vehicle) {
  const auto ground = MakeSineGround(5, 30, 0.1, 5);
  Simulation simulation(vehicle, *ground);
  simulation.Place(Eigen::Vector2d::Zero(), 0);
  std::vector<double> heights;
  Eigen::Vector3d last = simulation.Chassis().p_WB;
  while (heights.size() < 800) {
    simulation.Advance(
        {.engine_torque = std::clamp(60 * (2 - simulation.Chassis().forward_speed), -20.0, 80.0)});
    const Eigen::Vector3d p = simulation.Chassis().p_WB;
    for (double x = 2 + 0.02 * static_cast<double>(heights.size()); x <= p.x();) {
      heights.push_back(last.z() + (p.z() - last.z()) * (x - last.x()) / (p.x() - last.x()));
      x = 2 + 0.02 * static_cast<double>(heights.size());
    }
    last = p;
  }
  heights.resize(800);
  return heights;
}

double RmsDifference(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

TEST(Convergence, HalvingTheStepsReducesTheErrorOnWaves) {
  const auto reference = HeightsAlong(WithSteps(0.125e-3));
  const double coarse = RmsDifference(HeightsAlong(WithSteps(2e-3)), reference);
  const double middle = RmsDifference(HeightsAlong(WithSteps(1e-3)), reference);
  const double fine = RmsDifference(HeightsAlong(WithSteps(0.5e-3)), reference);
  RecordProperty("coarse_um", static_cast<int>(1e6 * coarse));
  RecordProperty("middle_um", static_cast<int>(1e6 * middle));
  RecordProperty("fine_um", static_cast<int>(1e6 * fine));
  EXPECT_LT(coarse, 0.2e-3);  // the default steps: 0.04 mm were measured with a prototype
  EXPECT_LT(middle, 0.75 * coarse);
  EXPECT_LT(fine, 0.75 * middle);
}

}  // namespace
}  // namespace dbd
