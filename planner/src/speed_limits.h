#pragma once

#include <dbd/core/path.h>
#include <dbd/core/vehicle_model.h>
#include <dbd/planner/plan_types.h>
#include <dbd/terrain/terrain.h>

#include <vector>

namespace dbd {

/// How fast the ground lets a careful driver go, every `kSpeedLimitSpacing` along the path [m/s].
///
/// Along the two wheel tracks the profile's curvature k asks for the vertical acceleration v^2 k:
/// the speed is limited so that this stays below a comfortable share of gravity, over the length
/// of the vehicle around each place.
std::vector<double> GroundSpeedLimits(const Terrain& terrain, const VehicleModel& vehicle,
                                      const Path& path);

/// How fast a driver goes who wants to touch nothing: a driver cuts corners, the more the faster,
/// and drifts on side slopes. Stretches of the path where an obstacle is near the vehicle's box;
/// none where nothing is.
std::vector<SpeedCap> CapsBesideObstacles(const Terrain& terrain, const VehicleModel& vehicle,
                                          const Path& path);

/// Lowers limits every `kSpeedLimitSpacing` along a path to those of the caps.
void ApplySpeedCaps(const std::vector<SpeedCap>& caps, std::vector<double>& limits);

}  // namespace dbd
