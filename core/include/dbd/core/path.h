#pragma once

#include <Eigen/Core>
#include <vector>

namespace dbd {

/// A part of a path that is driven forward, or in reverse, throughout. The vehicle stands still
/// where one ends and the next begins.
struct PathStretch {
  double begin = 0;  ///< arc length [m]
  double end = 0;    ///< [m]
  bool reverse = false;
};

/// A planar curve in the world frame W: points [m] joined by straight segments, addressed by arc
/// length s [m] from its first point. Immutable.
class Path {
 public:
  Path() = default;

  /// `reverse`: of each point whether the vehicle comes to it in reverse, the first one's unused;
  /// empty when it always drives forward. Repeated points are dropped. Throws InputError when fewer
  /// than two distinct points remain or a coordinate is not finite.
  explicit Path(const std::vector<Eigen::Vector2d>& points, const std::vector<bool>& reverse = {});

  bool empty() const { return points_.empty(); }
  double length() const { return arc_lengths_.empty() ? 0.0 : arc_lengths_.back(); }
  const std::vector<Eigen::Vector2d>& points() const { return points_; }

  /// At least one unless the path is empty, each ending where the next begins.
  const std::vector<PathStretch>& stretches() const { return stretches_; }
  const PathStretch& StretchAt(double s) const;
  double reverse_length() const;  ///< of the stretches in reverse [m]

  /// Point at arc length s; beyond the ends the end segments are continued straight.
  Eigen::Vector2d Position(double s) const;

  /// The same, but beyond the end of a stretch that one is continued straight.
  Eigen::Vector2d PositionOn(const PathStretch& stretch, double s) const;

  /// Direction of travel at s [rad], 0 = east, counter-clockwise positive.
  double Heading(double s) const;

  /// Where the vehicle's front points at s [rad]: against the direction of travel in reverse.
  double VehicleHeading(double s) const;

  /// Signed curvature [1/m] over a window of +-`half_window` [m] around s, within its stretch; a
  /// turn to the left of the direction of travel is positive.
  double Curvature(double s, double half_window) const;

  /// Arc length of the point nearest to p, searched only in [s_from, s_to].
  double NearestArcLength(const Eigen::Vector2d& p, double s_from, double s_to) const;

 private:
  std::size_t SegmentAt(double s) const;
  void AddStretch(double begin, double end, bool reverse);

  std::vector<Eigen::Vector2d> points_;
  std::vector<double> arc_lengths_;  // of each point, from the first
  std::vector<PathStretch> stretches_;
};

}  // namespace dbd
