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

/// How a driver starts on a grade.
struct StartStyle {
  double slip;  ///< of the driven wheels above which the torque is cut
  double ramp;  ///< share of full torque by which it changes at every control step
};

/// Whether the vehicle gains height. The brakes are released when the torque holds the vehicle.
bool ClimbsWith(const StartStyle& style, const VehicleModel& vehicle, double angle,
                const SoilSample& soil) {
  const auto ground = MakePlaneGround(std::tan(angle), 0, soil);
  Simulation simulation(vehicle, *ground);
  simulation.Place(Eigen::Vector2d::Zero(), 0, 2);
  const double full = FullThrottleTorque(vehicle.powertrain, vehicle.powertrain.min_speed) * 1.5;
  const double holding =
      vehicle.total_mass() * kGravity * std::sin(angle) / TractionPerEngineTorque(vehicle);
  double torque = 0;
  bool held = true;
  while (simulation.time() < 8) {
    held = held && torque < std::min(holding, 0.99 * full);
    const bool spinning = !held && Spinning(vehicle, simulation, style.slip);
    torque = std::clamp(torque + (spinning ? -style.ramp : style.ramp) * full, 0.0, full);
    simulation.Advance({.engine_torque = torque, .brake = held ? 1.0 : 0.0});
  }
  const ChassisView chassis = simulation.Chassis();
  const bool upright = std::abs(chassis.pitch + angle) < Degrees(20);  // did not rear up
  return simulation.IsSane() && upright && chassis.forward_speed > kCreep;
}

/// A good driver finds the slip that pulls best, and does not make a tractor rear up.
bool Climbs(const VehicleModel& vehicle, double angle, const SoilSample& soil) {
  for (const double slip : {0.35, 0.5, 0.7}) {
    for (const double ramp : {0.02, 0.002}) {
      if (ClimbsWith({slip, ramp}, vehicle, angle, soil)) return true;
    }
  }
  return false;
}

/// By bisection between 60 % and 140 % of a guess.
double SteepestStart(const VehicleModel& vehicle, const SoilSample& soil, double guess) {
  double low = 0.6 * guess, high = 1.4 * guess;
  while (high - low > Degrees(0.25)) {
    const double middle = 0.5 * (low + high);
    (Climbs(vehicle, middle, soil) ? low : high) = middle;
  }
  return low;
}

/// Motion resistance of a wheel at its best slip: its load acts that share of the radius ahead of
/// the axle, which is what the drive torque feels of it.
double ResistanceRatio(const VehicleModel& vehicle, const WheelModel& wheel,
                       const SoilSample& soil) {
  const TireModel& tire = wheel.tire;
  const double deflection = wheel.static_load / tire.stiffness;
  const double mobility =
      std::min(80.0, BrixiusMobilityNumber(soil.cone_index, wheel.static_load, tire.width,
                                           2 * tire.radius, deflection / tire.section_height));
  const bool driven = vehicle.axles[static_cast<std::size_t>(wheel.axle)].driven;
  return MotionResistanceRatio(tire.traction, mobility,
                               driven ? MaxNetTraction(tire.traction, mobility).slip : 0);
}

/// sin(angle) = net traction / weight with the loads of that slope: the rear carries h sin more,
/// and every load acts ahead of its axle.
double TractionLimit(const VehicleModel& original, const SoilSample& soil) {
  VehicleModel vehicle = original;
  const double weight = vehicle.total_mass() * kGravity;
  double mean = 0, spread = 0;
  const auto x_of = [&](const WheelModel& wheel) {
    return original.axles[static_cast<std::size_t>(wheel.axle)].x;
  };
  for (const WheelModel& wheel : original.wheels) mean += x_of(wheel);
  mean /= static_cast<double>(original.wheels.size());
  for (const WheelModel& wheel : original.wheels) spread += std::pow(x_of(wheel) - mean, 2);
  double angle = 0;
  for (int i = 0; i < 200; ++i) {
    double moment = weight * original.mass_center_height() * std::sin(angle);
    for (const WheelModel& wheel : vehicle.wheels) {
      moment += ResistanceRatio(vehicle, wheel, soil) * wheel.static_load * wheel.tire.radius;
    }
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

/// Soil so soft that traction allows no more than this angle.
SoilSample SoilThatAllows(double angle, const VehicleModel& vehicle) {
  double soft = 30e3, firm = 3e6;
  while (firm > 1.001 * soft) {
    const double middle = std::sqrt(soft * firm);
    (TractionLimit(vehicle, {.cone_index = middle}) < angle ? soft : firm) = middle;
  }
  return {.cone_index = firm};
}

class Grade : public ::testing::TestWithParam<std::string> {};

TEST_P(Grade, SteepestStartAgreesWithStatics) {
  const auto vehicle = LoadVehicle(GetParam());
  const SoilSample soft = SoilThatAllows(Degrees(8), *vehicle);
  for (const SoilSample& soil : {SoilSample{.cone_index = 1.8e6}, {.cone_index = 4e5}, soft}) {
    const double traction = TractionLimit(*vehicle, soil), power = PowerLimit(*vehicle, soil);
    const double hand = std::min(traction, power);
    const double driven = SteepestStart(*vehicle, soil, hand);
    const std::string kpa = std::to_string(std::lround(soil.cone_index / 1e3));
    RecordProperty("driven_deg_" + kpa, std::to_string(ToDegrees(driven)));
    RecordProperty((traction < power ? "traction_deg_" : "power_deg_") + kpa,
                   std::to_string(ToDegrees(hand)));
    EXPECT_NEAR(driven, hand, 0.1 * hand)
        << "cone index " << kpa << " kPa, by traction " << ToDegrees(traction) << " deg, by power "
        << ToDegrees(power) << " deg";
  }
}

INSTANTIATE_TEST_SUITE_P(BuiltIn, Grade, ::testing::ValuesIn(BuiltInVehicleNames()),
                         [](const auto& test) { return Underscored(test.param); });

}  // namespace
}  // namespace dbd
