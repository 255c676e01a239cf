#pragma once

#include <dbd/core/driver_care.h>
#include <dbd/core/path.h>
#include <dbd/core/vehicle_model.h>

#include <limits>
#include <vector>

namespace dbd {

// The driver (paper sections 4.7, 4.8, 5.1): pure pursuit of a path with Ackermann steering, and
// proportional speed control within the engine's limits, slower where the going is poor. Where a
// path goes on in reverse, the driver stops, changes the gear and pursues it with the rear leading:
// the point that follows the path, the middle of the fixed axles, moves by the same kinematics
// either way.

/// Most in reverse [m/s].
inline constexpr double kReverseSpeed = 2.0;

struct DriverOptions {
  double target_speed = 5.0;        ///< on open ground [m/s]
  double lookahead_time = 0.5;      ///< lookahead = least + time * speed [s]
  double least_lookahead = 2.5;     ///< [m]
  double deceleration = 1.5;        ///< used to plan stops and curve entries [m/s^2]
  double curve_acceleration = 2.0;  ///< lateral, in curves [m/s^2]
  double speed_gain = 4.76;         ///< acceleration per speed error, in the lowest gear [1/s]
  double integral_gain = 2.38;      ///< [1/s^2]
  double brake_gain = 0.4;          ///< share of full brake per m/s too fast, beyond 0.5 m/s
  bool stop_at_end = true;          ///< of the path
  /// Limits that the ground sets, every `kSpeedLimitSpacing` along the path [m/s]; may be empty.
  std::vector<double> speed_limits = {};
  CareOptions care = {};
};

/// Spacing of `DriverOptions::speed_limits` along the path [m].
inline constexpr double kSpeedLimitSpacing = 0.5;

/// What the driver sees of the vehicle.
struct DriverView {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< of the rear axle's middle, in W
  double heading = 0;
  double speed = 0;  ///< forward [m/s]
  GoingView going = {};
  /// What traffic ahead allows [m/s].
  double speed_limit = std::numeric_limits<double>::infinity();
};

struct DriverCommand {
  double steer = 0;          ///< of the mean front wheel, left positive [rad]
  double engine_torque = 0;  ///< asked of the engine, before its limits [N m]
  double brake = 0;          ///< share of full brake torque [0, 1]
  bool reverse = false;      ///< in the reverse gear, where torque drives backwards
};

/// Memory of the driver between control steps.
struct DriverState {
  double arc_length = 0;    ///< of the nearest point of the path
  std::size_t stretch = 0;  ///< of the path, being driven
  double integral = 0;      ///< of the speed error [N m]
  double target_speed = 0;  ///< in force now, of either direction
  double last_speed = 0;    ///< forward, at the last decision [m/s]
  bool arrived = false;     ///< standing at the end
  CareState care = {};
};

class Driver {
 public:
  /// An empty path means straight ahead along the initial heading.
  Driver(const VehicleModel& vehicle, const Path& path, const DriverOptions& options);

  /// Called once per control step of length `dt`. `start`, `heading`: where the drive began.
  DriverCommand Update(const DriverView& view, double dt, DriverState& state) const;

  /// The speed that path and options allow at arc length s, before any look ahead.
  double SpeedLimit(double s) const;

  void SetStart(const Eigen::Vector2d& position, double heading);

 private:
  const PathStretch& Stretch(const DriverState& state) const;
  bool OnLastStretch(const DriverState& state) const;
  double SpeedAlongPath(const DriverView& view, const DriverState& state) const;
  void ChangeDirection(DriverState& state) const;
  double Steer(const DriverView& view, DriverState& state) const;
  double TargetSpeed(const DriverView& view, double dt, DriverState& state) const;
  void BuildSpeedProfile();

  const VehicleModel& vehicle_;
  Path path_;
  DriverOptions options_;
  double wheelbase_;
  double max_steer_;
  double torque_per_acceleration_;     // of the engine, in the lowest gear [N m s^2/m]
  std::vector<double> speed_profile_;  // every kSpeedLimitSpacing along the path
};

/// Steer angle of each wheel for a mean steer angle, so that all wheels roll about one centre
/// (Ackermann). Indexed like `vehicle.wheels`.
std::vector<double> AckermannAngles(const VehicleModel& vehicle, double steer);

/// What of a vehicle its steer angles depend on beside the axles.
struct AckermannGeometry {
  explicit AckermannGeometry(const VehicleModel& vehicle);

  double path_point_x;
  double wheelbase;  ///< from the path point to the steered axle farthest from it, signed [m]
};

/// The same for hot loops: sines, written to `sines`.
void AckermannSines(const VehicleModel& vehicle, const AckermannGeometry& geometry, double steer,
                    double* sines);

}  // namespace dbd
