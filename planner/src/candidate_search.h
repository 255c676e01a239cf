#pragma once

#include <dbd/planner/candidate_sampler.h>
#include <dbd/planner/ompl_planners.h>
#include <dbd/planner/plan_types.h>
#include <dbd/planner/roadmap.h>
#include <dbd/planner/trafficability.h>

#include <memory>
#include <vector>

#include "candidate_pool.h"

namespace dbd {

/// One request's search for routes. Runs in the caller's task arena.
class CandidateSearch {
 public:
  CandidateSearch(const VehicleModel& vehicle, const TrafficabilityLayer& layer,
                  const PlanRequest& request, const PlanOptions& options, std::stop_token stop);

  /// Fills the pool with up to `options.sampling.candidates` routes. Returns why there is none.
  /// Throws StopRequested soon after the stop was asked for.
  std::optional<NoRouteDiagnosis> Run(CandidatePool* pool, const ProgressCallback& progress);

 private:
  // How many routes each source is asked for.
  struct Wave {
    int roadmap = 0;
    int rrt_connect = 0;
    int abit_star = 0;
  };

  std::vector<Pose2> EndPoses(const Eigen::Vector2d& place, const std::optional<double>& heading,
                              double towards) const;
  void SpanRegion(double margin, const std::vector<Eigen::Vector2d>& places);
  bool ConnectRoadmap();
  // Poses along a way through narrow places become nodes of the next roadmap, and a route.
  void SearchNarrowWays();
  // Routes that change direction, from a lattice and from RRTConnect.
  std::vector<RouteDraft> ReversingDrafts();
  OmplQuery QueryForOmpl(bool reversing) const;
  Wave NextWave(int wave, int missing) const;
  // Offers each source's quota first, then what was made on top. Leaves so many places free.
  void OfferAll(std::vector<RouteDraft> drafts, CandidatePool* pool, int places_to_keep) const;
  // Where smoothing makes many routes one, the routes as they were found are variants of it.
  void ReserveUnsmoothed(RouteDraft* draft, CandidatePool* pool) const;
  std::vector<RouteDraft> Generate(const Wave& wave);
  RouteDraft NarrowDraft();
  std::vector<std::vector<Pose2>> PenalizedRoutes(int count);
  void Finish(RouteDraft* draft, std::uint64_t seed) const;
  std::optional<NoRouteDiagnosis> DiagnoseEnds() const;
  NoRouteDiagnosis DiagnoseBetween() const;

  const TrafficabilityLayer& layer_;
  const PlanRequest& request_;
  const PlanOptions& options_;
  std::stop_token stop_;
  double turning_radius_;
  RoadmapQuery query_;
  std::unique_ptr<Roadmap> roadmap_;
  std::vector<Pose2> narrow_way_;   // found on a lattice; empty: none or not looked for
  std::uint64_t streams_used_ = 0;  // seeds handed out so far
};

}  // namespace dbd
