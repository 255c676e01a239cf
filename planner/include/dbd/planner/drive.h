#pragma once

#include <dbd/core/path.h>
#include <dbd/core/sinkage.h>
#include <dbd/core/vehicle_model.h>
#include <dbd/planner/plan_types.h>
#include <dbd/terrain/terrain.h>

#include <stop_token>

namespace dbd {

struct DriveOptions {
  double target_speed = 5;       ///< on open ground [m/s]
  double duration = 60;          ///< longest simulated time [s]
  double trace_interval = 0.05;  ///< of the trace [s]; 0 = by distance
  double trace_distance = 1.0;   ///< of the trace [m], where trace_interval is 0
  double goal_tolerance = 2.0;   ///< of the path's end [m]
  std::vector<SpeedCap> speed_caps = {};
  bool stop_at_violation = false;  ///< end the drive where a limit of the vehicle is exceeded
  /// Multipass: axles are taken to follow the foremost one's ruts.
  SinkageOptions sinkage = {};
};

/// Drives one vehicle in full dynamics along `path` until an outcome: this is what "to drive a
/// candidate" means everywhere. The rear axle's middle starts over `start` with `heading` [rad]
/// and follows the path; an empty path means straight ahead, and then kTimedOut is the normal end.
/// The physics decides the outcome; nothing is thrown for what happens on the way. `stop` is
/// polled every simulated second and ends the drive with kCancelled.
Rollout DrivePath(const Terrain& terrain, const VehicleModel& vehicle, const Path& path,
                  const Eigen::Vector2d& start, double heading, const DriveOptions& options,
                  std::stop_token stop = {});

}  // namespace dbd
