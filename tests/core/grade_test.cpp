#include <dbd/core/mobility.h>
#include <dbd/core/powertrain.h>
#include <dbd/core/scenario.h>
#include <dbd/core/terramechanics.h>
#include <dbd/core/units.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/core_drive.h"
#include "support/core_vehicle.h"

namespace dbd {
namespace {

// The steepest grade on which a vehicle starts, by simulation, against statics.

constexpr double kCreep = 0.3;  // [m/s] slower, motion resistance is not yet full

/// Whether the driven wheels slip more than `most`; rolling back does not count.
bool Spinning(const VehicleModel& vehicle, const Simulation& simulation, double most) {
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < vehicle.wheels.size(); ++i) {
    const WheelModel& wheel = vehicle.wheels[i];
    if (!vehicle.axles[static_cast<std::size_t>(wheel.axle)].driven) continue;
    sum += simulation.Wheel(static_cast<int>(i)).spin * wheel.tire.radius;
    ++count;
  }
  const double wheels = sum / count, ground = std::max(0.0, simulation.Chassis().forward_speed);
  return wheels - ground > most * std::max(wheels, 0.5);
}

/// Whether the vehicle gains height with full torque, cut where the wheels slip more than `slip`.
bool ClimbsWith(double slip, const VehicleModel& vehicle, double angle, const SoilSample& soil) {
  const auto ground = MakePlaneGround(std::tan(angle), 0, soil);
  Simulation simulation(vehicle, *ground);
  simulation.Place(Eigen::Vector2d::Zero(), 0, 2);
  const double full = FullThrottleTorque(vehicle.powertrain, vehicle.powertrain.min_speed) * 1.5;
  double torque = 0;
  while (simulation.time() < 10) {
    const bool held = simulation.time() < 0.5;  // brakes released when the torque is there
    const bool spinning = !held && Spinning(vehicle, simulation, slip);
    torque = std::clamp(torque + (spinning ? -0.02 : 0.02) * full, 0.0, full);
    simulation.Advance({.engine_torque = torque, .brake = held ? 1.0 : 0.0});
  }
  return simulation.IsSane() && simulation.Chassis().forward_speed > kCreep;
}

/// A good driver finds the slip that pulls best.
bool Climbs(const VehicleModel& vehicle, double angle, const SoilSample& soil) {
  for (const double slip : {0.35, 0.5, 0.7}) {
    if (ClimbsWith(slip, vehicle, angle, soil)) return true;
  }
  return false;
}

double SteepestStart(const VehicleModel& vehicle, const SoilSample& soil) {
  double low = 0, high = Degrees(50);
  while (high - low > Degrees(0.25)) {
    const double middle = 0.5 * (low + high);
    (Climbs(vehicle, middle, soil) ? low : high) = middle;
  }
  return low;
}

/// sin(angle) = net traction / weight with the loads of that slope: the rear carries h sin more.
double TractionLimit(const VehicleModel& original, const SoilSample& soil) {
  VehicleModel vehicle = original;
  const double weight = vehicle.total_mass() * kGravity;
  double mean = 0, spread = 0;
  const auto x_of = [&](const WheelModel& wheel) { return original.axles[wheel.axle].x; };
  for (const WheelModel& wheel : original.wheels) mean += x_of(wheel);
  mean /= static_cast<double>(original.wheels.size());
  for (const WheelModel& wheel : original.wheels) spread += std::pow(x_of(wheel) - mean, 2);
  double angle = 0;
  for (int i = 0; i < 200; ++i) {
    const double moment = weight * original.mass_center_height() * std::sin(angle);
    for (std::size_t w = 0; w < vehicle.wheels.size(); ++w) {
      const double load = original.wheels[w].static_load * std::cos(angle) -
                          moment * (x_of(original.wheels[w]) - mean) / spread;
      vehicle.wheels[w].static_load = std::max(load, 1.0);
    }
    const double ratio = std::clamp(MaxNetTractionRatio(vehicle, soil), 0.0, 1.0);
    angle += 0.2 * (std::asin(ratio) - angle);
  }
  return angle;
}

/// Torque in the lowest gear at creeping speed (idle: the clutch slips), less motion resistance.
double PowerLimit(const VehicleModel& vehicle, const SoilSample& soil) {
  const PowertrainModel& p = vehicle.powertrain;
  const double ratio = p.gear_ratios.front() * p.transfer_ratio * p.final_ratio;
  double radius = 0, resistance = 0;
  for (const WheelModel& wheel : vehicle.wheels) {
    const TireModel& tire = wheel.tire;
    const double deflection = wheel.static_load / tire.stiffness;
    if (vehicle.axles[static_cast<std::size_t>(wheel.axle)].driven) {
      radius = LoadedRollingRadius(tire.radius, deflection);
    }
    const double mobility =
        std::min(80.0, BrixiusMobilityNumber(soil.cone_index, wheel.static_load, tire.width,
                                             2 * tire.radius, deflection / tire.section_height));
    resistance += wheel.static_load * MotionResistanceRatio(tire.traction, mobility, 0);
  }
  const double torque = FullThrottleTorque(p, kCreep / radius * ratio) * ratio * p.efficiency;
  const double weight = vehicle.total_mass() * kGravity;
  double angle = 0;
  for (int i = 0; i < 50; ++i) {
    angle =
        std::asin(std::clamp((torque / radius - resistance * std::cos(angle)) / weight, 0.0, 1.0));
  }
  return angle;
}

class Grade : public ::testing::TestWithParam<std::string> {};

TEST_P(Grade, SteepestStartAgreesWithStatics) {
  const auto vehicle = LoadVehicle(GetParam());
  for (const double cone_index : {1.8e6, 4e5}) {
    const SoilSample soil{.cone_index = cone_index};
    const double traction = TractionLimit(*vehicle, soil), power = PowerLimit(*vehicle, soil);
    const double hand = std::min(traction, power);
    EXPECT_NEAR(SteepestStart(*vehicle, soil), hand, 0.1 * hand)
        << "cone index " << cone_index << ", by traction " << ToDegrees(traction)
        << " deg, by power " << ToDegrees(power) << " deg";
  }
}

INSTANTIATE_TEST_SUITE_P(BuiltIn, Grade, ::testing::ValuesIn(BuiltInVehicleNames()),
                         [](const auto& test) {
                           std::string name = test.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace dbd
