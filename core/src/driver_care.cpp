#include <dbd/core/driver_care.h>

#include <algorithm>
#include <cmath>

namespace dbd {
namespace {

double WantedShare(const CareOptions& options, const VehicleLimits& limits, const GoingView& going,
                   const CareState& state) {
  return std::min({CareShare(options.slip, state.slip),
                   CareShare(options.sinkage, going.sinkage / limits.max_sinkage),
                   CareShare(options.slope, going.ground_slope / limits.max_slope),
                   CareShare(options.ride, std::sqrt(state.mean_square))});
}

}  // namespace

double CareShare(const CareRule& rule, double value) {
  const double way = std::clamp((value - rule.begin) / (rule.full - rule.begin), 0.0, 1.0);
  return 1 - way * (1 - rule.least);
}

double CarefulSpeed(const CareOptions& options, const VehicleLimits& limits, const GoingView& going,
                    double speed_limit, double dt, CareState& state) {
  const double blend = std::min(1.0, dt / options.smoothing_time);
  const double a = going.vertical_acceleration;
  state.slip += blend * (std::abs(going.slip) - state.slip);
  state.mean_square += blend * (a * a - state.mean_square);
  const double climbing = std::clamp(
      (going.climb - options.climb_begin) / (options.climb_full - options.climb_begin), 0.0, 1.0);
  const double share = WantedShare(options, limits, going, state);
  const double wanted = share + climbing * (1 - share);
  const double fall = options.deceleration * dt / std::max(speed_limit, options.least_speed);
  const double recovery =
      options.recovery_rate + climbing * (options.climb_recovery_rate - options.recovery_rate);
  state.share = std::clamp(wanted, state.share - fall, state.share + recovery * dt);
  return std::min(speed_limit, std::max(options.least_speed, state.share * speed_limit));
}

}  // namespace dbd
