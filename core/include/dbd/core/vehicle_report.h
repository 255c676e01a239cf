#pragma once

#include <dbd/core/vehicle_model.h>

#include <string>
#include <vector>

namespace dbd {

/// One small oscillation about the static equilibrium.
struct VibrationMode {
  std::string shape;     ///< the body and direction that move most, e.g. "chassis z"
  double frequency = 0;  ///< damped [Hz]
  double damping = 0;    ///< ratio to critical [-]
};

/// Critical steps of the force elements of one kind on one pair of bodies, left and right together.
/// Infinity: the group has no such motion.
struct CriticalGroup {
  std::string name;  ///< e.g. "links, rear axle"
  int count = 0;
  double translational = 0;  ///< least sqrt(m/k) [s]
  double rotational = 0;     ///< least sqrt(I/(k r^2)) [s]
};

/// What one range of the transfer case gives.
struct RangeReport {
  std::string name;
  double ratio = 1;
  double top_speed = 0;    ///< by gearing [m/s]
  double power_grade = 0;  ///< steepest by torque in the lowest gear [rad]
};

/// What `dbd vehicle check` shows: the vehicle at rest on level, hard ground, and what follows
/// from its numbers.
struct VehicleReport {
  double mass = 0;
  double mass_center_height = 0;
  double settled_height_error = 0;       ///< reference point against the design pose [m]
  double settled_pitch = 0;              ///< nose down [rad]
  std::vector<double> wheel_loads;       ///< settled, like vehicle.wheels [N]
  std::vector<double> tire_deflections;  ///< [m]
  std::vector<double> spring_forces;     ///< settled, like vehicle.springs [N]
  std::vector<VibrationMode> modes;      ///< oscillating ones, slowest first
  std::vector<CriticalGroup> critical_groups;
  std::vector<RangeReport> ranges;    ///< of the transfer case; empty: one ratio
  double critical_translational = 0;  ///< least sqrt(m/k) of the stiff links [s]
  double critical_rotational = 0;     ///< least sqrt(I/(k r^2)) [s]
  double fastest_mode_limit = 0;      ///< largest stable step for the fastest mode [s]
  double top_speed = 0;               ///< by gearing [m/s]
  double traction_grade = 0;          ///< steepest by traction on firm soil [rad]
  double power_grade = 0;             ///< steepest by torque in the lowest gear [rad]
  double stability_angle = 0;         ///< static side slope [rad]
  double min_turning_radius = 0;      ///< [m]
};

VehicleReport CheckVehicle(const VehicleModel& vehicle);

}  // namespace dbd
