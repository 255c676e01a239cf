#pragma once

#include <dbd/core/driver.h>
#include <dbd/core/ride.h>
#include <dbd/core/simulation.h>
#include <dbd/planner/drive.h>

#include <optional>

#include "judge.h"

namespace dbd {

/// Everything about one drive but the vehicle's physics: driver, ride meter, judge and record. Who
/// steps the physics - one vehicle alone or a lane of many - asks it for commands at every control
/// step and shows it the vehicle every `look_every()` steps, first at the start.
class DriveSession {
 public:
  /// All references must outlive the session. `control_step` [s].
  DriveSession(const Terrain& terrain, const VehicleModel& vehicle, const Path& path,
               const Eigen::Vector2d& start, double heading, const DriveOptions& options,
               double control_step);

  /// `view`: the vehicle as the driver sees it; `vertical_acceleration` over the last step.
  DriverCommand Command(DriverView view, double vertical_acceleration);

  /// Judges the vehicle as it is; returns whether the drive is over. `sane`: the simulation's own
  /// verdict; `energy`: spent so far [J].
  bool Look(const VehicleSnapshot& snapshot, bool sane, double energy);

  /// Ends the drive with kCancelled.
  void Cancel();

  int look_every() const { return look_every_; }
  /// After the end.
  Rollout TakeRollout() { return std::move(rollout_); }

 private:
  std::optional<Verdict> Judge(const VehicleSnapshot& snapshot, bool sane);
  std::optional<Verdict> LookAtEnd(const VehicleSnapshot& snapshot) const;
  void Record(const TraceSample& sample);
  void Finish(const Verdict& verdict, double time, double energy);

  const Terrain& terrain_;
  const VehicleModel& vehicle_;
  const Path& path_;
  DriveOptions options_;
  Rollout rollout_;
  Driver driver_;
  DriverState driver_state_;
  RideMeter ride_;
  dbd::Judge judge_;
  double control_step_;
  int look_every_;
  double next_row_ = 0;  // of the trace: time or distance
  std::optional<Eigen::Vector3d> last_place_;
  TraceSample last_sample_;
  double energy_ = 0;
};

}  // namespace dbd
