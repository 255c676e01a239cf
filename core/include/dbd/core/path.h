#pragma once

#include <Eigen/Core>
#include <vector>

namespace dbd {

/// A planar curve in the world frame W: points [m] joined by straight segments, addressed by arc
/// length s [m] from its first point. Immutable.
class Path {
 public:
  Path() = default;

  /// Repeated points are dropped. Throws InputError when fewer than two distinct points remain or
  /// a coordinate is not finite.
  explicit Path(const std::vector<Eigen::Vector2d>& points);

  bool empty() const { return points_.empty(); }
  double length() const { return arc_lengths_.empty() ? 0.0 : arc_lengths_.back(); }
  const std::vector<Eigen::Vector2d>& points() const { return points_; }

  /// Point at arc length s; beyond the ends the end segments are continued straight.
  Eigen::Vector2d Position(double s) const;

  /// Direction of travel at s [rad], 0 = east, counter-clockwise positive.
  double Heading(double s) const;

  /// Signed curvature [1/m] over a window of +-`half_window` [m] around s, left turn positive.
  double Curvature(double s, double half_window) const;

  /// Arc length of the point nearest to p, searched only in [s_from, s_to].
  double NearestArcLength(const Eigen::Vector2d& p, double s_from, double s_to) const;

 private:
  std::size_t SegmentAt(double s) const;

  std::vector<Eigen::Vector2d> points_;
  std::vector<double> arc_lengths_;  // of each point, from the first
};

}  // namespace dbd
