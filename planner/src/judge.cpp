#include "judge.h"

#include <dbd/core/units.h>

#include <array>
#include <cmath>
#include <cstdio>

namespace dbd {
namespace {

constexpr double kRolledOverUp = 0.26;     // cosine of 75 deg
constexpr double kLoadTransferTime = 0.3;  // [s] shorter lifts are bumps, not tipping
constexpr double kStuckTime = 6.0;         // [s] without kStuckDistance of progress
constexpr double kStuckDistance = 0.5;     // [m]

/// How people read a value.
struct Unit {
  double factor;
  const char* symbol;
};
constexpr Unit kRatio{1, ""}, kMetre{1, " m"}, kDegree{ToDegrees(1.0), " deg"}, kWatt{1, " W"},
    kGravities{1 / kGravity, " g"};

/// Name, limit and value of a limit, in SI and as people read it.
struct LimitValue {
  const char* name;
  double limit;
  double value;
  Unit unit;
  bool is_least = false;  // the value must stay above the limit
  double full = 0;        // for least limits: the value that counts as full margin
};

bool IsWorse(const LimitValue& v, double worst) {
  return v.is_least ? v.value < worst : v.value > worst;
}

double MarginOf(const LimitValue& v) {
  if (v.is_least) return (v.value - v.limit) / (v.full - v.limit);
  return (v.limit - v.value) / v.limit;
}

std::string DescribeViolation(const LimitValue& v) {
  char text[160];
  std::snprintf(text, sizeof(text), "%s %.3g%s, limit %.3g%s", v.name, v.value * v.unit.factor,
                v.unit.symbol, v.limit * v.unit.factor, v.unit.symbol);
  return text;
}

std::array<LimitValue, 8> LimitValues(const VehicleModel& vehicle, const TraceSample& sample,
                                      double load_transfer) {
  const VehicleLimits& limits = vehicle.limits;
  return {{{"roll", limits.max_roll, std::abs(sample.roll), kDegree},
           {"pitch", limits.max_pitch, std::abs(sample.pitch), kDegree},
           {"slope", limits.max_slope, sample.ground_slope, kDegree},
           {"sinkage", limits.max_sinkage, sample.sinkage, kMetre},
           {"clearance", limits.min_clearance, sample.clearance, kMetre, true,
            vehicle.outline.belly_height},
           {"load_transfer", limits.max_load_transfer, load_transfer, kRatio},
           {"absorbed_power", limits.max_absorbed_power, sample.absorbed_power, kWatt},
           {"shock", limits.max_shock, sample.vertical_acceleration, kGravities}}};
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
    if (!IsWorse(values[i], margins_[i].worst)) continue;
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

bool Judge::MayFindStuck(double time) const { return time - progress_time_ >= kStuckTime; }

std::optional<Verdict> Judge::LookForProgress(const TraceSample& sample, double progress,
                                              double wanted_speed) {
  if (progress > progress_mark_ + kStuckDistance || wanted_speed <= 0) {
    progress_mark_ = progress;
    progress_time_ = sample.t;
  }
  if (!MayFindStuck(sample.t)) return std::nullopt;
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
