#include <dbd/planner/candidate_sampler.h>

#include <dbd/core/error.h>
#include <dbd/planner/candidate_curve.h>
#include <dbd/planner/ompl_planners.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include "candidate_search.h"
#include "work_arena.h"

namespace dbd {
namespace {

std::string Coordinates(const Eigen::Vector2d& place) {
  char text[80];
  std::snprintf(text, sizeof text, "%.2f,%.2f", place.x(), place.y());
  return text;
}

// Ends are named in map coordinates, as users give them.
void CheckEnd(const Terrain& terrain, const char* name, const Eigen::Vector2d& place) {
  const std::string given =
      std::string(name) + " " + Coordinates(terrain.frame().ToMap(place)) + " (map coordinates): ";
  const Eigen::Vector2d min = terrain.heights().min_corner();
  const Eigen::Vector2d max = terrain.heights().max_corner();
  const bool inside =
      place.x() >= min.x() && place.y() >= min.y() && place.x() <= max.x() && place.y() <= max.y();
  if (!inside) {
    throw InputError(given + "must lie inside the terrain, which spans " +
                     Coordinates(terrain.frame().ToMap(min)) + " to " +
                     Coordinates(terrain.frame().ToMap(max)));
  }
  if (!terrain.IsKnown(place.x(), place.y())) {
    throw InputError(given + "must lie on known ground, but the terrain has no data there");
  }
}

void CheckRequest(const Terrain& terrain, const PlanRequest& request) {
  CheckEnd(terrain, "start", request.start);
  CheckEnd(terrain, "goal", request.goal);
  if ((request.goal - request.start).norm() < kPoseStep) {
    throw InputError("goal " + Coordinates(terrain.frame().ToMap(request.goal)) +
                     " (map coordinates): must be at least 1 m from the start");
  }
}

Candidate ToCandidate(const RouteDraft& draft, const PlanRequest& request) {
  return {draft.origin, PathAlong(draft.poses, request.start, request.goal), draft.cost};
}

}  // namespace

CandidateSet SampleCandidates(const Terrain& terrain, const VehicleModel& vehicle,
                              const TrafficabilityLayer& layer, const PlanRequest& request,
                              const PlanOptions& options, const ProgressCallback& progress,
                              const std::stop_token& stop, const std::vector<Candidate>& known) {
  CheckRequest(terrain, request);
  const OmplSilence silence;
  CandidatePool pool(options.sampling.min_separation, stop);
  pool.AddKnown(known);
  CandidateSet set;
  WorkArena arena(options.threads);
  arena.Execute([&] {
    set.diagnosis = CandidateSearch(vehicle, layer, request, options, stop).Run(&pool, progress);
  });
  for (const RouteDraft& draft : pool.TakeSorted()) {
    set.candidates.push_back(ToCandidate(draft, request));
  }
  return set;
}

}  // namespace dbd
