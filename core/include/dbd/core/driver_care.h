#pragma once

#include <dbd/core/vehicle_limits.h>

namespace dbd {

// Automatic slow-down where trafficability is poor (paper section 5.1), from what a driver sees
// and feels: slip, sinkage, slope and ride. The gains are assumed, chosen so that none of the
// measures acts on firm, smooth ground and that all act before a limit of the vehicle is met.

/// What the going is like. What nobody observes stays 0 and slows nothing.
struct GoingView {
  double slip = 0;                   ///< largest of the driven wheels, signed
  double sinkage = 0;                ///< of the deepest wheel [m]
  double ground_slope = 0;           ///< under the vehicle, steepest direction [rad]
  double climb = 0;                  ///< grade along the heading, uphill positive [rad]
  double vertical_acceleration = 0;  ///< of the chassis, without gravity [m/s^2]
};

/// Share of the speed that one measure leaves: 1 up to `begin`, `least` from `full` on, linear in
/// between.
struct CareRule {
  double begin = 0;
  double full = 1;
  double least = 1;
};

struct CareOptions {
  CareRule slip = {0.2, 0.7, 0.5};
  CareRule sinkage = {0.5, 1.0, 0.4};  ///< of the vehicle's limit
  CareRule slope = {0.7, 1.0, 0.6};    ///< of the vehicle's limit
  /// Root mean square of the vertical acceleration [m/s^2]: from the value that gives 6 W of
  /// absorbed power at the most sensitive frequency (1.69 at 4-5 Hz) to twice that.
  CareRule ride = {1.5, 3.0, 0.4};
  /// Uphill momentum is worth more than care: what the rules take off is given back between these
  /// grades [rad].
  double climb_begin = 0.09;
  double climb_full = 0.21;
  double smoothing_time = 1.0;  ///< of slip and ride [s], so that single bumps count little
  double deceleration = 1.5;    ///< the target falls no faster than this [m/s^2]
  /// And it rises this slowly, in shares of the speed per second: the hysteresis that keeps the
  /// driver from hunting at the edge of a rule.
  double recovery_rate = 0.1;
  double climb_recovery_rate = 0.5;  ///< the same from `climb_full` on
  /// Care never asks for less than this [m/s]. It lowers the target speed, never the torque that
  /// holding it takes, so that a climb goes on.
  double least_speed = 1.5;
};

/// The driver's memory of the going.
struct CareState {
  double slip = 0;         ///< smoothed magnitude
  double mean_square = 0;  ///< of the vertical acceleration [m^2/s^4]
  double share = 1;        ///< of the speed that would be driven otherwise
};

double CareShare(const CareRule& rule, double value);

/// Called once per control step of length `dt`; returns the speed to aim for where path and
/// options allow `speed_limit`.
double CarefulSpeed(const CareOptions& options, const VehicleLimits& limits, const GoingView& going,
                    double speed_limit, double dt, CareState& state);

}  // namespace dbd
