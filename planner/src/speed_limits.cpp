#include "speed_limits.h"

#include <dbd/core/driver.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace dbd {
namespace {

constexpr double kVerticalAcceleration = 2.5;  // [m/s^2] a quarter of gravity
constexpr double kLeastSpeed = 1.0;            // [m/s] nothing is crossed slower
constexpr double kHalfSpan = 1.0;              // [m] over which curvature is felt

/// Heights along the left and the right wheel track.
struct TrackHeights {
  std::vector<double> left, right;
};

TrackHeights HeightsOfTracks(const Terrain& terrain, const Path& path, double track,
                             std::size_t count) {
  TrackHeights heights{std::vector<double>(count), std::vector<double>(count)};
  for (std::size_t i = 0; i < count; ++i) {
    const double s = static_cast<double>(i) * kSpeedLimitSpacing;
    const double heading = path.Heading(s);
    const Eigen::Vector2d middle = path.Position(s);
    const Eigen::Vector2d aside =
        0.5 * track * Eigen::Vector2d(-std::sin(heading), std::cos(heading));
    const Eigen::Vector2d left = middle + aside, right = middle - aside;
    heights.left[i] = terrain.Height(left.x(), left.y());
    heights.right[i] = terrain.Height(right.x(), right.y());
  }
  return heights;
}

void LimitByCurvature(const std::vector<double>& heights, std::vector<double>& limits) {
  const auto reach = static_cast<std::size_t>(kHalfSpan / kSpeedLimitSpacing);
  const double span = static_cast<double>(reach) * kSpeedLimitSpacing;
  for (std::size_t i = reach; i + reach < heights.size(); ++i) {
    const double bend = heights[i + reach] - 2 * heights[i] + heights[i - reach];
    const double curvature = std::abs(bend) / (span * span);
    const double speed = std::sqrt(kVerticalAcceleration / std::max(curvature, 1e-6));
    limits[i] = std::min(limits[i], std::max(kLeastSpeed, speed));
  }
}

/// The path is the rear axle's: a place is felt from when the front wheels reach it.
std::vector<double> SpreadOverVehicle(const std::vector<double>& limits, double wheelbase) {
  const auto ahead = static_cast<std::size_t>(std::ceil(wheelbase / kSpeedLimitSpacing));
  std::vector<double> spread = limits;
  for (std::size_t i = 0; i < limits.size(); ++i) {
    const std::size_t last = std::min(limits.size(), i + ahead + 1);
    for (std::size_t j = i; j < last; ++j) spread[i] = std::min(spread[i], limits[j]);
  }
  return spread;
}

/// How fast people drive with how little room.
struct Passing {
  double room;   // [m] on all sides of the vehicle
  double speed;  // [m/s] with less
};
constexpr Passing kPassings[] = {{0.35, 1.2}, {0.8, 2.2}};

/// Infinite where there is room.
double SpeedBesideObstacles(const Terrain& terrain, const VehicleModel& vehicle, const Path& path,
                            double s) {
  const VehicleOutline& outline = vehicle.outline;
  const double body_ahead = vehicle.bodies.empty() ? 0 : vehicle.bodies[0].p_RB.x();
  const double ahead = body_ahead + 0.5 * (outline.front - outline.rear) - vehicle.path_point_x();
  const double heading = path.VehicleHeading(s);
  const Eigen::Vector2d center =
      path.Position(s) + ahead * Eigen::Vector2d(std::cos(heading), std::sin(heading));
  const Eigen::Vector2d half(0.5 * (outline.front + outline.rear), outline.half_width);
  for (const Passing& passing : kPassings) {
    const Eigen::Vector2d extents = half + Eigen::Vector2d::Constant(passing.room);
    if (terrain.obstacles().BlocksBox(center, heading, extents, outline.height)) {
      return passing.speed;
    }
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace

std::vector<SpeedCap> CapsBesideObstacles(const Terrain& terrain, const VehicleModel& vehicle,
                                          const Path& path) {
  std::vector<SpeedCap> caps;
  if (terrain.obstacles().empty()) return caps;
  for (double s = 0; s <= path.length(); s += kSpeedLimitSpacing) {
    const double speed = SpeedBesideObstacles(terrain, vehicle, path, s);
    if (!std::isfinite(speed)) continue;
    if (caps.empty() || caps.back().speed != speed || caps.back().to < s) {
      caps.push_back({s, s, speed});
    }
    caps.back().to = s + kSpeedLimitSpacing;
  }
  return caps;
}

void ApplySpeedCaps(const std::vector<SpeedCap>& caps, std::vector<double>& limits) {
  for (std::size_t i = 0; i < limits.size(); ++i) {
    const double s = static_cast<double>(i) * kSpeedLimitSpacing;
    for (const SpeedCap& cap : caps) {
      if (s >= cap.from && s <= cap.to) limits[i] = std::min(limits[i], cap.speed);
    }
  }
}

std::vector<double> GroundSpeedLimits(const Terrain& terrain, const VehicleModel& vehicle,
                                      const Path& path) {
  if (path.empty()) return {};
  const auto count = static_cast<std::size_t>(std::ceil(path.length() / kSpeedLimitSpacing)) + 1;
  std::vector<double> limits(count, vehicle.limits.max_speed);
  const TrackHeights heights = HeightsOfTracks(terrain, path, vehicle.mean_track(), count);
  LimitByCurvature(heights.left, limits);
  LimitByCurvature(heights.right, limits);
  return SpreadOverVehicle(limits, vehicle.wheelbase());
}

}  // namespace dbd
