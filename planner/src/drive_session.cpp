#include "drive_session.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "speed_limits.h"

namespace dbd {
namespace {

// Between two looks of the judge and two decisions of the driver, whichever comes first: 25 Hz, as
// fast as people's and machines' steering answers. On the candidates of the 1.05 km slovenia route
// that differs from looks every 5 ms no more than looks every 10 ms do (drives within 0.2 % of the
// time in the middle); at 60 ms more drives end otherwise.
constexpr double kLookInterval = 0.04;  // [s]
constexpr double kLookDistance = 0.2;   // [m]

std::vector<double> SpeedLimits(const Terrain& terrain, const VehicleModel& vehicle,
                                const Path& path, const DriveOptions& options) {
  std::vector<double> limits = GroundSpeedLimits(terrain, vehicle, path);
  ApplySpeedCaps(options.speed_caps, limits);
  return limits;
}

}  // namespace

DriveSession::DriveSession(const Terrain& terrain, const VehicleModel& vehicle, const Path& path,
                           const Eigen::Vector2d& start, double heading,
                           const DriveOptions& options, double control_step)
    : path_(path),
      options_(options),
      driver_(vehicle, path,
              {.target_speed = options.target_speed,
               .speed_limits = SpeedLimits(terrain, vehicle, path, options)}),
      ride_(control_step),
      observer_(terrain, vehicle, options.sinkage),
      judge_(vehicle, options.stop_at_violation),
      control_step_(control_step) {
  driver_.SetStart(start, heading);
}

void DriveSession::Feel(double vertical_acceleration) {
  if (unread_ == unread_accelerations_.size()) ReadFelt();
  unread_accelerations_[unread_++] = vertical_acceleration;
}

/// The ride meter's filters are wanted at the looks only.
void DriveSession::ReadFelt() {
  felt_squares_ += ride_.Update(std::span(unread_accelerations_).first(unread_));
  felt_ += static_cast<int>(unread_);
  unread_ = 0;
}

DriverCommand DriveSession::Decide(const VehicleSnapshot& snapshot) {
  DriverView view{snapshot.path_point, snapshot.chassis.yaw, snapshot.chassis.forward_speed};
  view.going.slip = last_sample_.slip;
  view.going.sinkage = last_sample_.sinkage;
  view.going.ground_slope = last_sample_.ground_slope;
  view.going.climb = -last_sample_.pitch;
  view.going.vertical_acceleration = std::sqrt(felt_squares_ / std::max(felt_, 1));
  felt_squares_ = 0;
  felt_ = 0;
  steps_to_look_ = StepsToLook(snapshot.chassis.forward_speed);
  return driver_.Update(view, steps_to_look_ * control_step_, driver_state_);
}

int DriveSession::StepsToLook(double speed) const {
  const double interval = std::min(kLookInterval, kLookDistance / std::abs(speed));
  return std::max(1, static_cast<int>(interval / control_step_ + 0.5));
}

bool DriveSession::Look(const VehicleSnapshot& snapshot, bool sane, double energy) {
  energy_ = energy;
  ReadFelt();
  const std::optional<Verdict> verdict = Judge(snapshot, sane);
  if (verdict) Finish(*verdict, snapshot.time, energy);
  return verdict.has_value();
}

void DriveSession::Cancel() { Finish({Outcome::kCancelled, "cancelled"}, last_sample_.t, energy_); }

std::optional<Verdict> DriveSession::Judge(const VehicleSnapshot& snapshot, bool sane) {
  const Eigen::Vector3d place = snapshot.chassis.p_WB;
  if (!sane) {
    return Verdict{Outcome::kDiverged, "the simulation of this vehicle became unstable"};
  }
  Observation observation = observer_.Observe(snapshot);
  rollout_.distance += (place - last_place_.value_or(place)).head<2>().norm();
  last_place_ = place;
  observation.sample.s = rollout_.distance;
  const bool reverse = !path_.empty() && path_.stretches()[driver_state_.stretch].reverse;
  observation.sample.target_speed = (reverse ? -1 : 1) * driver_state_.target_speed;
  observation.sample.absorbed_power = ride_.absorbed_power();
  observation.sample.vertical_acceleration = ride_.TakePeak();
  const bool shown = RowIsDue(observation.sample) || judge_.MayFindStuck(snapshot.time);
  if (shown) {
    observer_.AddSinkageAndSlope(snapshot.wheels, observation.sample);
  } else {
    observer_.AddSinkageAndSlopeIfWorse(snapshot.wheels, observation.sample);
  }
  last_sample_ = observation.sample;
  Record(last_sample_);
  auto verdict = judge_.Look(observation, driver_state_.arc_length, driver_state_.target_speed);
  if (!verdict) verdict = LookAtEnd(snapshot);
  const bool last_row = verdict && !shown;
  if (last_row) observer_.AddSinkageAndSlope(snapshot.wheels, last_sample_);
  return verdict;
}

std::optional<Verdict> DriveSession::LookAtEnd(const VehicleSnapshot& snapshot) const {
  if (!path_.empty() && driver_state_.arrived) {
    const double off = (snapshot.path_point - path_.points().back()).norm();
    if (off <= options_.goal_tolerance) return Verdict{Outcome::kReached, ""};
    return Verdict{Outcome::kImmobilized, "stopped beside the end of the path"};
  }
  if (snapshot.time < options_.duration) return std::nullopt;
  return Verdict{Outcome::kTimedOut, "not there within the longest time"};
}

bool DriveSession::RowIsDue(const TraceSample& sample) const {
  return (options_.trace_interval > 0 ? sample.t : sample.s) >= next_row_;
}

/// Keeps the rows that the trace asks for.
void DriveSession::Record(const TraceSample& sample) {
  if (!RowIsDue(sample)) return;
  next_row_ += options_.trace_interval > 0 ? options_.trace_interval : options_.trace_distance;
  rollout_.trace.push_back(sample);
}

/// The last row is always kept: it shows where and how the drive ended.
void DriveSession::Finish(const Verdict& verdict, double time, double energy) {
  if (rollout_.trace.empty() || rollout_.trace.back().t < last_sample_.t) {
    rollout_.trace.push_back(last_sample_);
  }
  rollout_.outcome = verdict.outcome;
  rollout_.reason = verdict.reason;
  rollout_.place = last_place_.value_or(Eigen::Vector3d::Zero());
  rollout_.time = time;
  rollout_.energy = energy;
  rollout_.progress =
      path_.empty() ? 0 : std::clamp(driver_state_.arc_length / path_.length(), 0.0, 1.0);
  rollout_.margins = judge_.Margins();
}

}  // namespace dbd
