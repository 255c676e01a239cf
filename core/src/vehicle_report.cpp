#include <dbd/core/mobility.h>
#include <dbd/core/powertrain.h>
#include <dbd/core/scenario.h>
#include <dbd/core/simulation.h>
#include <dbd/core/terramechanics.h>
#include <dbd/core/units.h>
#include <dbd/core/vehicle_report.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "time_steps.h"
#include "vibration.h"

namespace dbd {
namespace {

void Settle(const VehicleModel& vehicle, VehicleReport& report) {
  const auto ground = MakePlaneGround(0, 0);
  Simulation simulation(vehicle, *ground);
  simulation.Place(Eigen::Vector2d::Zero(), 0, 3.0);
  simulation.Advance({.brake = 1});
  for (std::size_t i = 0; i < vehicle.wheels.size(); ++i) {
    const WheelView wheel = simulation.Wheel(static_cast<int>(i));
    report.wheel_loads.push_back(wheel.load);
    report.tire_deflections.push_back(wheel.deflection);
  }
  for (std::size_t i = 0; i < vehicle.springs.size(); ++i) {
    report.spring_forces.push_back(simulation.SpringForce(static_cast<int>(i)));
  }
  const ChassisView chassis = simulation.Chassis();
  const Eigen::Vector3d reference = chassis.p_WB - chassis.q_WB * vehicle.bodies[0].p_RB;
  report.settled_height_error = reference.z() - vehicle.reference_height;
  report.settled_pitch = chassis.pitch;
}

void FindCriticalSteps(const VehicleModel& vehicle, VehicleReport& report) {
  report.critical_groups = GroupCriticalSteps(vehicle);
  report.critical_translational = std::numeric_limits<double>::infinity();
  report.critical_rotational = std::numeric_limits<double>::infinity();
  for (const LinkModel& link : vehicle.links) {
    const CriticalStep critical = CriticalStepOf(vehicle, link);
    report.critical_translational = std::min(report.critical_translational, critical.translational);
    report.critical_rotational = std::min(report.critical_rotational, critical.rotational);
  }
}

/// Torque at the driven wheels against weight and rolling resistance, in the lowest gear.
double PowerGrade(const VehicleModel& vehicle) {
  double radius = 0, resistance = 0;
  for (const WheelModel& wheel : vehicle.wheels) {
    const TireModel& tire = wheel.tire;
    if (vehicle.axles[static_cast<std::size_t>(wheel.axle)].driven) {
      radius = LoadedRollingRadius(tire.radius, wheel.static_load / tire.stiffness);
    }
    resistance += wheel.static_load * tire.traction.carcass_loss;
  }
  const double weight = vehicle.total_mass() * kGravity;
  const double force = MaxWheelTorque(vehicle.powertrain) / radius - resistance;
  return std::asin(std::clamp(force / weight, 0.0, 1.0));
}

void FindRanges(VehicleModel vehicle, VehicleReport& report) {
  for (const PowertrainModel::Range& range : vehicle.powertrain.ranges) {
    vehicle.powertrain.transfer_ratio = range.ratio;
    report.ranges.push_back({range.name, range.ratio, TopSpeed(vehicle), PowerGrade(vehicle)});
  }
}

}  // namespace

VehicleReport CheckVehicle(const VehicleModel& vehicle) {
  VehicleReport report;
  report.mass = vehicle.total_mass();
  report.mass_center_height = vehicle.mass_center_height();
  Settle(vehicle, report);
  double fastest = 0;
  report.modes = FindModes(vehicle, &fastest);
  report.fastest_mode_limit = 2 / fastest;
  FindCriticalSteps(vehicle, report);
  report.top_speed = TopSpeed(vehicle);
  report.traction_grade = std::atan(std::max(0.0, MaxNetTractionRatio(vehicle, SoilSample{})));
  report.power_grade = PowerGrade(vehicle);
  FindRanges(vehicle, report);
  report.stability_angle = StaticStabilityAngle(vehicle);
  report.min_turning_radius = vehicle.min_turning_radius();
  return report;
}

}  // namespace dbd
