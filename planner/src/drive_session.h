#pragma once

#include <dbd/core/driver.h>
#include <dbd/core/ride.h>
#include <dbd/core/simulation.h>
#include <dbd/planner/drive.h>

#include <array>
#include <optional>

#include "judge.h"
#include "observation.h"

namespace dbd {

/// Everything about one drive but the vehicle's physics: driver, ride meter, judge and record. Who
/// steps the physics - one vehicle alone or a lane of many - shows it the vehicle, first at the
/// start, holds the command that it then asks for over `steps_to_look()` control steps (40 ms, less
/// at more than 5 m/s), lets it feel each of them, and shows it the vehicle again.
class DriveSession {
 public:
  /// All references must outlive the session. `control_step` [s].
  DriveSession(const Terrain& terrain, const VehicleModel& vehicle, const Path& path,
               const Eigen::Vector2d& start, double heading, const DriveOptions& options,
               double control_step);

  /// The vertical acceleration of the chassis over one control step [m/s^2].
  void Feel(double vertical_acceleration);

  /// Judges the vehicle as it is; returns whether the drive is over. `sane`: the simulation's own
  /// verdict; `energy`: spent so far [J].
  bool Look(const VehicleSnapshot& snapshot, bool sane, double energy);

  /// What the driver does about what `Look` saw, until the next look.
  DriverCommand Decide(const VehicleSnapshot& snapshot);

  /// Ends the drive with kCancelled.
  void Cancel();

  /// Control steps from the last decision to the next look.
  int steps_to_look() const { return steps_to_look_; }
  /// After the end.
  Rollout TakeRollout() { return std::move(rollout_); }

 private:
  std::optional<Verdict> Judge(const VehicleSnapshot& snapshot, bool sane);
  std::optional<Verdict> LookAtEnd(const VehicleSnapshot& snapshot) const;
  int StepsToLook(double speed) const;
  void ReadFelt();
  bool RowIsDue(const TraceSample& sample) const;
  void Record(const TraceSample& sample);
  void Finish(const Verdict& verdict, double time, double energy);

  const Path& path_;
  DriveOptions options_;
  Rollout rollout_;
  Driver driver_;
  DriverState driver_state_;
  RideMeter ride_;
  Observer observer_;
  dbd::Judge judge_;
  double control_step_;
  int steps_to_look_ = 1;
  std::array<double, 8> unread_accelerations_{};  // the last that were felt [m/s^2]
  std::size_t unread_ = 0;
  double felt_squares_ = 0;  // of vertical accelerations since the last decision [m^2/s^4]
  int felt_ = 0;
  double next_row_ = 0;  // of the trace: time or distance
  std::optional<Eigen::Vector3d> last_place_;
  TraceSample last_sample_;
  double energy_ = 0;
};

}  // namespace dbd
