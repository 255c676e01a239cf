#pragma once

#include <dbd/planner/dubins.h>
#include <dbd/planner/trafficability.h>
#include <ompl/base/MotionValidator.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>

#include <utility>
#include <vector>

namespace dbd {

/// Poses in a rectangle [m, W], as far apart as the shortest curve of bounded curvature that may
/// change between forward and reverse (J. A. Reeds, L. A. Shepp 1990; OMPL's solver).
class ReedsSheppSpace final : public ompl::base::ReedsSheppStateSpace {
 public:
  ReedsSheppSpace(double turning_radius, const Eigen::Vector2d& min_corner,
                  const Eigen::Vector2d& max_corner);

  /// The ends of the curve's pieces, `to` last: each one arc or straight line from the one before,
  /// so that Dubins curves join them.
  std::vector<Pose2> Waypoints(const Pose2& from, const Pose2& to) const;
  std::vector<Pose2> Waypoints(const ompl::base::State* from, const ompl::base::State* to) const;

  double turning_radius() const { return rho_; }
};

/// A motion is valid when each of its steps of at most kPoseStep ends on go.
class ReedsSheppMotionValidator final : public ompl::base::MotionValidator {
 public:
  /// `si` must be of a ReedsSheppSpace. Keeps a reference to the layer.
  ReedsSheppMotionValidator(const ompl::base::SpaceInformationPtr& si,
                            const TrafficabilityLayer& layer);

  bool checkMotion(const ompl::base::State* from, const ompl::base::State* to) const override;
  /// Of a motion that is not valid only its beginning counts.
  bool checkMotion(const ompl::base::State* from, const ompl::base::State* to,
                   std::pair<ompl::base::State*, double>& last_valid) const override;

 private:
  const ReedsSheppSpace& space_;
  const TrafficabilityLayer& layer_;
};

}  // namespace dbd
