#include "taut_routes.h"

#include <dbd/planner/candidate_curve.h>
#include <dbd/planner/candidate_smoother.h>

#include <algorithm>
#include <cmath>

#include "candidate_random.h"

namespace dbd {
namespace {

constexpr int kAttempts = 300;

std::vector<const RouteDraft*> Shortest(const std::vector<RouteDraft>& drafts, int count) {
  std::vector<const RouteDraft*> shortest;
  for (const RouteDraft& draft : drafts) {
    if (std::isfinite(draft.cost)) shortest.push_back(&draft);
  }
  std::stable_sort(shortest.begin(), shortest.end(), [](const RouteDraft* a, const RouteDraft* b) {
    return a->poses.size() < b->poses.size();  // poses are equally far apart
  });
  shortest.resize(std::min(shortest.size(), static_cast<std::size_t>(count)));
  return shortest;
}

/// The rear axle itself, not only the vehicle's middle, stays off no-go ground.
bool CutsNoCorner(const TrafficabilityLayer& layer, const RouteDraft& draft) {
  return std::all_of(draft.poses.begin(), draft.poses.end(), [&](const Pose2& pose) {
    return layer.EvaluateAnyHeading(pose.x, pose.y).go();
  });
}

}  // namespace

std::vector<RouteDraft> TautRoutes(const TrafficabilityLayer& layer, double turning_radius,
                                   const PlanRequest& request,
                                   const std::vector<RouteDraft>& drafts, int count,
                                   std::uint64_t seed) {
  const TrafficabilityLayer flat = layer.WithFlatCost();
  SmoothingOptions smoothing;
  smoothing.attempts = kAttempts;
  smoothing.free_start = !request.start_heading.has_value();
  smoothing.free_goal = !request.goal_heading.has_value();
  std::vector<RouteDraft> taut;
  for (const RouteDraft* draft : Shortest(drafts, count)) {
    smoothing.longest = static_cast<double>(draft->poses.size()) * kPoseStep;
    RouteDraft pulled{
        "taut",
        SmoothRoute(flat, turning_radius, draft->poses, smoothing, DeriveSeed(seed, taut.size()))
            .poses,
        0,
        {}};
    pulled.cost = PosesCost(layer, pulled.poses);
    if (CutsNoCorner(layer, pulled)) taut.push_back(std::move(pulled));
  }
  return taut;
}

}  // namespace dbd
