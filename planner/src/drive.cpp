#include <dbd/core/driver.h>
#include <dbd/core/ride.h>
#include <dbd/core/simulation.h>
#include <dbd/planner/drive.h>

#include <algorithm>
#include <cmath>

#include "judge.h"
#include "observation.h"
#include "speed_limits.h"

namespace dbd {
namespace {

constexpr double kJudgeInterval = 0.02;  // [s]
constexpr double kSettleTime = 1.0;      // [s]
constexpr double kPollInterval = 1.0;    // [s] between looks at the stop token

/// Keeps the rows that the trace asks for.
class Recorder {
 public:
  Recorder(const DriveOptions& options, Rollout& rollout) : options_(options), rollout_(rollout) {}

  void Add(const TraceSample& sample) {
    const bool due = options_.trace_interval > 0 ? sample.t >= next_ : sample.s >= next_;
    if (!due) return;
    next_ += options_.trace_interval > 0 ? options_.trace_interval : options_.trace_distance;
    rollout_.trace.push_back(sample);
  }

  /// The last row is always kept: it shows where and how the drive ended.
  void Finish(const TraceSample& sample) {
    if (rollout_.trace.empty() || rollout_.trace.back().t < sample.t) {
      rollout_.trace.push_back(sample);
    }
  }

 private:
  const DriveOptions& options_;
  Rollout& rollout_;
  double next_ = 0;
};

/// One drive: vehicle, driver and judge.
class Drive {
 public:
  Drive(const Terrain& terrain, const VehicleModel& vehicle, const Path& path,
        const Eigen::Vector2d& start, double heading, const DriveOptions& options)
      : terrain_(terrain),
        vehicle_(vehicle),
        path_(path),
        options_(options),
        simulation_(vehicle, terrain),
        driver_(vehicle, path,
                {.target_speed = options.target_speed,
                 .speed_limits = GroundSpeedLimits(terrain, vehicle, path)}),
        ride_(simulation_.control_step()),
        judge_(vehicle, options.stop_at_violation),
        recorder_(options, rollout_) {
    simulation_.Place(start, heading, kSettleTime);
    driver_.SetStart(start, heading);
    judge_every_ = std::max(1, static_cast<int>(kJudgeInterval / simulation_.control_step() + 0.5));
    last_place_ = simulation_.Chassis().p_WB;
  }

  Rollout Run(std::stop_token stop) {
    std::optional<Verdict> verdict = LookAround();
    double next_poll = kPollInterval;
    while (!verdict) {
      for (int i = 0; i < judge_every_; ++i) Advance();
      verdict = LookAround();
      if (simulation_.time() >= next_poll) {
        next_poll += kPollInterval;
        if (!verdict && stop.stop_requested()) verdict = Verdict{Outcome::kCancelled, "cancelled"};
      }
    }
    Finish(*verdict);
    return std::move(rollout_);
  }

 private:
  void Advance() {
    DriverView view = simulation_.ViewForDriver();
    view.going.slip = last_sample_.slip;
    view.going.sinkage = last_sample_.sinkage;
    view.going.ground_slope = last_sample_.ground_slope;
    view.going.climb = -last_sample_.pitch;
    view.going.vertical_acceleration = ride_.Update(simulation_.VerticalAcceleration());
    simulation_.Advance(driver_.Update(view, simulation_.control_step(), driver_state_));
  }

  std::optional<Verdict> LookAround() {
    if (!simulation_.IsSane()) {
      return Verdict{Outcome::kDiverged, "the simulation of this vehicle became unstable"};
    }
    Observation observation = Observe(simulation_, terrain_, vehicle_, options_.sinkage);
    const Eigen::Vector3d place = simulation_.Chassis().p_WB;
    rollout_.distance += (place - last_place_).head<2>().norm();
    last_place_ = place;
    observation.sample.s = rollout_.distance;
    observation.sample.target_speed = driver_state_.target_speed;
    observation.sample.absorbed_power = ride_.absorbed_power();
    observation.sample.vertical_acceleration = ride_.TakePeak();
    last_sample_ = observation.sample;
    recorder_.Add(last_sample_);
    if (auto verdict =
            judge_.Look(observation, driver_state_.arc_length, driver_state_.target_speed)) {
      return verdict;
    }
    return LookAtEnd();
  }

  std::optional<Verdict> LookAtEnd() const {
    if (!path_.empty() && driver_state_.arrived) {
      const double off = (simulation_.ViewForDriver().position - path_.points().back()).norm();
      if (off <= options_.goal_tolerance) return Verdict{Outcome::kReached, ""};
      return Verdict{Outcome::kImmobilized, "stopped beside the end of the path"};
    }
    if (simulation_.time() < options_.duration) return std::nullopt;
    return Verdict{Outcome::kTimedOut, "not there within the longest time"};
  }

  void Finish(const Verdict& verdict) {
    recorder_.Finish(last_sample_);
    rollout_.outcome = verdict.outcome;
    rollout_.reason = verdict.reason;
    rollout_.place = last_place_;
    rollout_.time = simulation_.time();
    rollout_.energy = simulation_.drive_energy();
    rollout_.progress =
        path_.empty() ? 0 : std::clamp(driver_state_.arc_length / path_.length(), 0.0, 1.0);
    rollout_.margins = judge_.Margins();
  }

  const Terrain& terrain_;
  const VehicleModel& vehicle_;
  const Path& path_;
  const DriveOptions& options_;
  Rollout rollout_;
  Simulation simulation_;
  Driver driver_;
  DriverState driver_state_;
  RideMeter ride_;
  Judge judge_;
  Recorder recorder_;
  int judge_every_ = 1;
  Eigen::Vector3d last_place_ = Eigen::Vector3d::Zero();
  TraceSample last_sample_;
};

}  // namespace

Rollout DrivePath(const Terrain& terrain, const VehicleModel& vehicle, const Path& path,
                  const Eigen::Vector2d& start, double heading, const DriveOptions& options,
                  std::stop_token stop) {
  return Drive(terrain, vehicle, path, start, heading, options).Run(stop);
}

}  // namespace dbd
