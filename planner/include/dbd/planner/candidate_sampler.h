#pragma once

#include <dbd/planner/plan_types.h>
#include <dbd/planner/stop.h>
#include <dbd/planner/trafficability.h>

#include <optional>
#include <string>
#include <vector>

namespace dbd {

/// Why no candidate exists, as far as the trafficability layer can tell.
struct NoRouteDiagnosis {
  NoGoReason reason =
      NoGoReason::kNone;  ///< kNone: cells connect, but no curve of the vehicle does
  std::string why;        ///< one sentence
  Eigen::Vector2d where = Eigen::Vector2d::Zero();  ///< the place that says most, in W
};

/// Candidates in the order of their layer cost (ties: in the order of generation), or none and
/// the diagnosis.
struct CandidateSet {
  std::vector<Candidate> candidates;
  std::optional<NoRouteDiagnosis> diagnosis;
};

/// Samples geometrically different routes that the layer holds for drivable: about 60 % by
/// penalised searches of a directed roadmap, 25 % by RRTConnect with different seeds, the rest by
/// ABIT*; what one cannot give, another tops up. Paths have a point about every metre, start
/// exactly at `request.start` and end exactly at `request.goal`, and turn no tighter than
/// `vehicle.min_turning_radius()`. Headings at the ends are free unless the request gives them.
/// Routes nearer to each other than `min_separation` are replaced while others can be found; when
/// fewer different ones exist, nearer variants fill up.
///
/// `known` are routes that were sampled before: new ones differ from them as from each other.
/// Bit-identical for any `options.threads`. `progress` is called from the calling thread only.
/// Throws InputError when an end lies outside the map or on unknown ground, or both coincide, and
/// StopRequested soon after `stop` was asked to.
CandidateSet SampleCandidates(const Terrain& terrain, const VehicleModel& vehicle,
                              const TrafficabilityLayer& layer, const PlanRequest& request,
                              const PlanOptions& options, const ProgressCallback& progress,
                              const std::stop_token& stop = {},
                              const std::vector<Candidate>& known = {});

}  // namespace dbd
