#pragma once

#include <dbd/planner/trafficability.h>
#include <ompl/base/MotionValidator.h>
#include <ompl/base/OptimizationObjective.h>

#include <vector>

#include "dubins_space.h"

namespace dbd {

/// The layer's cost of a Dubins motion, for OMPL's optimising planners. The curve is solved once
/// per motion (OMPL's own integral objective solves it again at every sample). Costs to go are the
/// straight distance at the layer's best rate, which no drive can beat.
class RouteObjective final : public ompl::base::OptimizationObjective {
 public:
  /// `si` must be of a DubinsSpace. Keeps a reference to the layer.
  RouteObjective(const ompl::base::SpaceInformationPtr& si, const TrafficabilityLayer& layer,
                 std::vector<Eigen::Vector2d> goals);

  ompl::base::Cost stateCost(const ompl::base::State* state) const override;
  ompl::base::Cost motionCost(const ompl::base::State* from,
                              const ompl::base::State* to) const override;
  ompl::base::Cost motionCostHeuristic(const ompl::base::State* from,
                                       const ompl::base::State* to) const override;
  bool isSymmetric() const override { return false; }

 private:
  ompl::base::Cost CostToGo(const ompl::base::State* state) const;

  const DubinsSpace& space_;
  const TrafficabilityLayer& layer_;
  std::vector<Eigen::Vector2d> goals_;
};

/// A motion is valid when each of its steps of at most kPoseStep ends on go.
class RouteMotionValidator final : public ompl::base::MotionValidator {
 public:
  RouteMotionValidator(const ompl::base::SpaceInformationPtr& si, const TrafficabilityLayer& layer);

  bool checkMotion(const ompl::base::State* from, const ompl::base::State* to) const override;
  bool checkMotion(const ompl::base::State* from, const ompl::base::State* to,
                   std::pair<ompl::base::State*, double>& last_valid) const override;

 private:
  // Share of the motion that is valid, and whether that is all of it.
  std::pair<double, bool> ValidShare(const ompl::base::State* from,
                                     const ompl::base::State* to) const;

  const DubinsSpace& space_;
  const TrafficabilityLayer& layer_;
};

}  // namespace dbd
