#pragma once

#include <dbd/core/vehicle_model.h>
#include <dbd/planner/plan_types.h>
#include <dbd/terrain/terrain.h>

#include <memory>
#include <stop_token>

namespace dbd {

class LayerCache;

/// Which way can this vehicle really drive from here to there, how safely and how fast?
///
/// request -> candidates -> rollouts -> scores -> route. "No safe route" is an answer (kNoGo, with
/// reason and place), not an error. Throws InputError for options or a request that break a rule,
/// such as a start outside the map. Bit-identical for any number of threads, unless it is stopped:
/// within some milliseconds of `options.deadline` or of `stop` it returns kDeadline or kCancelled
/// with the best route so far, if there is one. `progress` is called one call at a time. `layers`,
/// where given, has the trafficability layer or keeps it for the next plan; it changes no answer.
Plan PlanRoute(std::shared_ptr<const Terrain> terrain, std::shared_ptr<const VehicleModel> vehicle,
               const PlanRequest& request, const PlanOptions& options,
               const ProgressCallback& progress = {}, std::stop_token stop = {},
               LayerCache* layers = nullptr);

}  // namespace dbd
