#include "route_objective.h"

#include <dbd/planner/candidate_curve.h>
#include <ompl/base/SpaceInformation.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "ompl_pose.h"

namespace dbd {

namespace ob = ompl::base;

RouteObjective::RouteObjective(const ob::SpaceInformationPtr& si, const TrafficabilityLayer& layer,
                               std::vector<Eigen::Vector2d> goals)
    : ob::OptimizationObjective(si),
      space_(*si->getStateSpace()->as<DubinsSpace>()),
      layer_(layer),
      goals_(std::move(goals)) {
  description_ = "trafficability";
  setCostToGoHeuristic([this](const ob::State* state, const ob::Goal*) { return CostToGo(state); });
}

ob::Cost RouteObjective::stateCost(const ob::State*) const { return identityCost(); }

ob::Cost RouteObjective::motionCost(const ob::State* from, const ob::State* to) const {
  return ob::Cost(CurveCost(layer_, ToPose(from), space_.Curve(from, to)));
}

ob::Cost RouteObjective::motionCostHeuristic(const ob::State* from, const ob::State* to) const {
  const Eigen::Vector2d way = ToPose(to).position() - ToPose(from).position();
  return ob::Cost(way.norm() * layer_.min_seconds_per_metre());
}

ob::Cost RouteObjective::CostToGo(const ob::State* state) const {
  const Eigen::Vector2d place = ToPose(state).position();
  double nearest = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector2d& goal : goals_) nearest = std::min(nearest, (goal - place).norm());
  return ob::Cost(nearest * layer_.min_seconds_per_metre());
}

RouteMotionValidator::RouteMotionValidator(const ob::SpaceInformationPtr& si,
                                           const TrafficabilityLayer& layer)
    : ob::MotionValidator(si), space_(*si->getStateSpace()->as<DubinsSpace>()), layer_(layer) {}

std::pair<double, bool> RouteMotionValidator::ValidShare(const ob::State* from,
                                                         const ob::State* to) const {
  const DubinsSampler sampler(ToPose(from), space_.Curve(from, to));
  const int steps = std::max(1, static_cast<int>(std::ceil(sampler.length() / kPoseStep)));
  for (int i = 1; i <= steps; ++i) {
    if (!layer_.Evaluate(sampler.At(sampler.length() * i / steps)).go()) {
      return {static_cast<double>(i - 1) / steps, false};
    }
  }
  return {1.0, true};
}

bool RouteMotionValidator::checkMotion(const ob::State* from, const ob::State* to) const {
  return ValidShare(from, to).second;
}

bool RouteMotionValidator::checkMotion(const ob::State* from, const ob::State* to,
                                       std::pair<ob::State*, double>& last_valid) const {
  const auto [share, valid] = ValidShare(from, to);
  if (valid) return true;
  last_valid.second = share;
  if (last_valid.first != nullptr) space_.interpolate(from, to, share, last_valid.first);
  return false;
}

}  // namespace dbd
