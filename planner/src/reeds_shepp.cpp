#include "reeds_shepp.h"

#include <dbd/planner/candidate_curve.h>
#include <ompl/base/SpaceInformation.h>

#include <cmath>
#include <memory>

#include "ompl_pose.h"

namespace dbd {
namespace {

namespace ob = ompl::base;

constexpr double kShortestPiece = 1e-6;  // [radii]

/// Where one piece of a curve leads from a pose; `length` is negative in reverse.
Pose2 AfterPiece(const Pose2& from, ob::ReedsSheppStateSpace::ReedsSheppPathSegmentType type,
                 double length, double radius) {
  DubinsCurve piece;
  piece.radius = radius;
  piece.reverse = length < 0;
  piece.lengths[0] = std::abs(length) * radius;
  // A turn to the vehicle's left is one to the right when looking backwards.
  const bool left = (type == ob::ReedsSheppStateSpace::RS_LEFT) != piece.reverse;
  piece.turns[0] = type == ob::ReedsSheppStateSpace::RS_STRAIGHT ? Turn::kStraight
                   : left                                        ? Turn::kLeft
                                                                 : Turn::kRight;
  return DubinsSampler(from, piece).At(piece.length());
}

}  // namespace

ReedsSheppSpace::ReedsSheppSpace(double turning_radius, const Eigen::Vector2d& min_corner,
                                 const Eigen::Vector2d& max_corner)
    : ob::ReedsSheppStateSpace(turning_radius) {
  setBounds(Rectangle(min_corner, max_corner));
}

std::vector<Pose2> ReedsSheppSpace::Waypoints(const ob::State* from, const ob::State* to) const {
  const ReedsSheppPath curve = reedsShepp(from, to);
  std::vector<Pose2> waypoints;
  Pose2 pose = ToPose(from);
  for (int i = 0; i < 5 && curve.type_[i] != RS_NOP; ++i) {
    if (std::abs(curve.length_[i]) < kShortestPiece) continue;
    pose = AfterPiece(pose, curve.type_[i], curve.length_[i], rho_);
    waypoints.push_back(pose);
  }
  const bool reverse = !waypoints.empty() && waypoints.back().reverse;
  if (waypoints.empty()) waypoints.emplace_back();
  waypoints.back() = ToPose(to);
  waypoints.back().reverse = reverse;
  return waypoints;
}

std::vector<Pose2> ReedsSheppSpace::Waypoints(const Pose2& from, const Pose2& to) const {
  const auto free_state = [this](ob::State* state) { freeState(state); };
  const std::unique_ptr<ob::State, decltype(free_state)> one(allocState(), free_state);
  const std::unique_ptr<ob::State, decltype(free_state)> other(allocState(), free_state);
  SetPose(from, one.get());
  SetPose(to, other.get());
  return Waypoints(one.get(), other.get());
}

ReedsSheppMotionValidator::ReedsSheppMotionValidator(const ob::SpaceInformationPtr& si,
                                                     const TrafficabilityLayer& layer)
    : ob::MotionValidator(si), space_(*si->getStateSpace()->as<ReedsSheppSpace>()), layer_(layer) {}

bool ReedsSheppMotionValidator::checkMotion(const ob::State* from, const ob::State* to) const {
  const std::vector<Pose2> waypoints = space_.Waypoints(from, to);
  return std::isfinite(WaypointsCost(layer_, ToPose(from), waypoints, space_.turning_radius()));
}

bool ReedsSheppMotionValidator::checkMotion(const ob::State* from, const ob::State* to,
                                            std::pair<ob::State*, double>& last_valid) const {
  if (checkMotion(from, to)) return true;
  last_valid.second = 0;
  if (last_valid.first != nullptr) space_.copyState(last_valid.first, from);
  return false;
}

}  // namespace dbd
