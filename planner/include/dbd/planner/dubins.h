#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>

namespace dbd {

/// A place [m] and where the vehicle's front points [rad, 0 = east, counter-clockwise] in the frame
/// W.
struct Pose2 {
  double x = 0;
  double y = 0;
  double heading = 0;
  bool reverse = false;  ///< on a route: the vehicle comes here in reverse

  Eigen::Vector2d position() const { return {x, y}; }
};

/// A pose with the cosine and sine of its heading, for those who need them more than once.
struct DirectedPose : Pose2 {
  DirectedPose() = default;
  explicit DirectedPose(const Pose2& pose)
      : Pose2(pose), cos_h(std::cos(pose.heading)), sin_h(std::sin(pose.heading)) {}

  double cos_h = 1;
  double sin_h = 0;
};

/// The same angle in (-pi, pi].
double WrapAngle(double angle);

enum class Turn : signed char { kRight = -1, kStraight = 0, kLeft = 1 };

/// Three pieces of circle or straight line, driven forward throughout or in reverse throughout.
struct DubinsCurve {
  std::array<Turn, 3> turns{Turn::kLeft, Turn::kStraight, Turn::kLeft};
  std::array<double, 3> lengths{};  ///< [m], none negative
  double radius = 1;                ///< of the turns [m]
  bool reverse = false;             ///< then the turns are as seen when looking backwards

  double length() const { return lengths[0] + lengths[1] + lengths[2]; }
};

/// The shortest curve of bounded curvature between two poses (L. E. Dubins 1957; the six words as
/// written by Shkel and Lumelsky 2001). `radius` [m] must be positive. When `to` is come to in
/// reverse, it is that of the vehicle turned round.
///
/// The end pose is met within 1e-7 radii. Within that tolerance a turn that rounding has made a
/// full circle is left out, so that two poses of one curve are joined by that curve.
DubinsCurve ShortestDubinsCurve(const Pose2& from, const Pose2& to, double radius);
DubinsCurve ShortestDubinsCurve(const DirectedPose& from, const DirectedPose& to, double radius);

/// Poses along one curve that starts at `from`.
class DubinsSampler {
 public:
  DubinsSampler(const Pose2& from, const DubinsCurve& curve);

  /// Pose at arc length s [m]; s is held within [0, length].
  DirectedPose At(double s) const;

  double length() const { return length_; }

 private:
  std::array<DirectedPose, 3> starts_;  // of the pieces
  DubinsCurve curve_;
  double length_;
};

}  // namespace dbd
