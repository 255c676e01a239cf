#include "judge.h"

#include <dbd/core/units.h>

#include <array>
#include <cmath>
#include <cstdio>

namespace dbd {
namespace {

constexpr double kRolledOverUp = 0.26;      // cosine of 75 deg
constexpr double kLoadTransferLimit = 0.9;  // terramechanics 10: no-go; 1 = a side lifts
constexpr double kLoadTransferTime = 0.3;   // [s] shorter lifts are bumps, not tipping
constexpr double kStuckTime = 6.0;          // [s] without kStuckDistance of progress
constexpr double kStuckDistance = 0.5;      // [m]

/// Name, limit and value of a limit, in SI and as people read it.
struct LimitValue {
  const char* name;
  double limit;
  double value;
  bool is_angle;
  bool is_least;  // the value must stay above the limit
  double full;    // for least limits: the value that counts as full margin
};

double MarginOf(const LimitValue& v) {
  if (v.is_least) return (v.value - v.limit) / (v.full - v.limit);
  return (v.limit - v.value) / v.limit;
}

std::string DescribeViolation(const LimitValue& v) {
  const double scale = v.is_angle ? ToDegrees(1.0) : 1.0;
  const char* unit = v.is_angle ? " deg" : v.limit == kLoadTransferLimit ? "" : " m";
  char text[160];
  std::snprintf(text, sizeof(text), "%s %.3g%s, limit %.3g%s", v.name, v.value * scale, unit,
                v.limit * scale, unit);
  return text;
}

std::array<LimitValue, 6> LimitValues(const VehicleModel& vehicle, const TraceSample& sample,
                                      double load_transfer) {
  const VehicleLimits& limits = vehicle.limits;
  return {{{"roll", limits.max_roll, std::abs(sample.roll), true, false, 0},
           {"pitch", limits.max_pitch, std::abs(sample.pitch), true, false, 0},
           {"slope", limits.max_slope, sample.ground_slope, true, false, 0},
           {"sinkage", limits.max_sinkage, sample.sinkage, false, false, 0},
           {"clearance", limits.min_clearance, sample.clearance, false, true,
            vehicle.outline.belly_height},
           {"load_transfer", kLoadTransferLimit, load_transfer, false, false, 0}}};
}

}  // namespace

Judge::Judge(const VehicleModel& vehicle, bool stop_at_violation)
    : vehicle_(vehicle), stop_at_violation_(stop_at_violation) {
  for (const LimitValue& v : LimitValues(vehicle, TraceSample{}, 0)) {
    LimitMargin margin;
    margin.name = v.name;
    margin.limit = v.limit;
    margin.worst = v.is_least ? v.full : 0;
    margins_.push_back(margin);
  }
}

std::optional<Verdict> Judge::LookAtLimits(const TraceSample& sample) {
  const double blend = std::min(1.0, (sample.t - last_time_) / kLoadTransferTime);
  last_time_ = sample.t;
  steady_load_transfer_ += blend * (sample.load_transfer_ratio - steady_load_transfer_);
  std::optional<Verdict> verdict;
  const auto values = LimitValues(vehicle_, sample, steady_load_transfer_);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double margin = MarginOf(values[i]);
    if (margin < margins_[i].margin) {
      margins_[i].margin = margin;
      margins_[i].worst = values[i].value;
      margins_[i].s = sample.s;
      margins_[i].place = {sample.x, sample.y};
    }
    if (margin < 0 && stop_at_violation_ && !verdict) {
      verdict = Verdict{Outcome::kLimitExceeded, DescribeViolation(values[i])};
    }
  }
  return verdict;
}

std::optional<Verdict> Judge::LookForProgress(const TraceSample& sample, double progress,
                                              double wanted_speed) {
  if (progress > progress_mark_ + kStuckDistance || wanted_speed <= 0) {
    progress_mark_ = progress;
    progress_time_ = sample.t;
  }
  if (sample.t - progress_time_ < kStuckTime) return std::nullopt;
  char text[160];
  std::snprintf(
      text, sizeof(text),
      "no progress for %.0f s: slip %.2f, net traction reserve %.2f, ground slope %.1f deg",
      kStuckTime, sample.slip, sample.net_traction_reserve, ToDegrees(sample.ground_slope));
  return Verdict{Outcome::kImmobilized, text};
}

std::optional<Verdict> Judge::Look(const Observation& observation, double progress,
                                   double wanted_speed) {
  const TraceSample& sample = observation.sample;
  if (observation.up < kRolledOverUp) {
    return Verdict{Outcome::kRolledOver, "the chassis tilted by more than 75 deg"};
  }
  if (!observation.on_known_ground) {
    return Verdict{Outcome::kLeftMap, "a wheel came on ground that the map does not know"};
  }
  if (observation.hits_obstacle) {
    return Verdict{Outcome::kCollided, "the vehicle's box touched an obstacle"};
  }
  if (observation.impassable != nullptr) {
    return Verdict{Outcome::kLimitExceeded,
                   "a wheel came on impassable ground: " + observation.impassable->name};
  }
  if (auto verdict = LookAtLimits(sample)) return verdict;
  return LookForProgress(sample, progress, wanted_speed);
}

}  // namespace dbd
