#include "candidate_search.h"

#include <dbd/planner/candidate_curve.h>
#include <dbd/planner/candidate_flood.h>
#include <dbd/planner/candidate_smoother.h>
#include <dbd/planner/ompl_planners.h>
#include <dbd/planner/polyline_separation.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <numbers>
#include <string>
#include <utility>

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include "candidate_guides.h"
#include "candidate_random.h"
#include "lattice_search.h"
#include "taut_routes.h"

namespace dbd {
namespace {

constexpr const char* kRoadmapName = "roadmap";
constexpr const char* kLatticeName = "lattice";
constexpr const char* kReversingName = "reversing";
constexpr int kReversingDrafts = 4;
constexpr int kReversingDraftsAlone = 12;  // where nothing else connects start and goal
constexpr int kReversingShare = 4;         // one of so many candidates
constexpr int kTautRoutes = 2;
constexpr double kTautSeparation = 0.2;  // as a share of the usual
constexpr int kFreeHeadings = 8;
constexpr int kRoadmapRounds = 3;  // each with twice the nodes of the one before
constexpr int kWaves = 4;
constexpr double kLeastYield = 0.25;  // of what a further wave is asked for, to try another
constexpr int kRrtConnectIterations = 4000;
constexpr int kProbes = 4;  // of RRTConnect, where the roadmap found nothing
// Attempts: first solutions of samplers have most to gain.
constexpr int kRoadmapSmoothing = 100;
constexpr int kSamplerSmoothing = 250;
constexpr double kRoadmapShare = 0.6;
constexpr double kRrtConnectShare = 0.25;
// More are made at once than are wanted, because some turn out to be near others.
constexpr double kSurplus = 1.4;

// A search that follows another is kept off it over this share of the way, within these bounds
// [m], at this price per search.
constexpr double kPenaltyShare = 0.04;
constexpr double kLargestPenaltyWidth = 60.0;
constexpr double kPenaltyStrength = 0.5;

// Ways round something between start and goal are looked for this far out, as a share of the
// distance, plus some turning radii.
constexpr double kMarginShare = 0.5;
constexpr double kMarginInRadii = 10.0;
constexpr double kNarrowMargin = 4.0;  // times that, where narrow ways are looked for

int Share(double share, int count) { return static_cast<int>(std::ceil(share * count)); }

}  // namespace

CandidateSearch::CandidateSearch(const VehicleModel& vehicle, const TrafficabilityLayer& layer,
                                 const PlanRequest& request, const PlanOptions& options,
                                 std::stop_token stop)
    : layer_(layer),
      request_(request),
      options_(options),
      stop_(std::move(stop)),
      turning_radius_(vehicle.min_turning_radius()) {
  const Eigen::Vector2d way = request.goal - request.start;
  const double towards = std::atan2(way.y(), way.x());
  query_.starts = EndPoses(request.start, request.start_heading, towards);
  query_.goals = EndPoses(request.goal, request.goal_heading, towards);
}

std::vector<Pose2> CandidateSearch::EndPoses(const Eigen::Vector2d& place,
                                             const std::optional<double>& heading,
                                             double towards) const {
  std::vector<Pose2> poses;
  const int count = heading ? 1 : kFreeHeadings;
  for (int i = 0; i < count; ++i) {
    const double turned = towards + 2.0 * std::numbers::pi * i / count;
    const Pose2 pose{place.x(), place.y(), WrapAngle(heading.value_or(turned))};
    if (layer_.Evaluate(pose.x, pose.y, pose.heading).go()) poses.push_back(pose);
  }
  return poses;
}

std::optional<NoRouteDiagnosis> CandidateSearch::Run(CandidatePool* pool,
                                                     const ProgressCallback& progress) {
  if (auto diagnosis = DiagnoseEnds()) return diagnosis;
  if (!ConnectRoadmap()) roadmap_ = nullptr;
  std::vector<RouteDraft> reversing;
  if (options_.sampling.reversing) reversing = ReversingDrafts();
  if (roadmap_ == nullptr && query_.guides.empty()) {
    for (RouteDraft& draft : reversing) pool->Offer(std::move(draft), kTautSeparation);
    pool->FillUp(options_.sampling.candidates);
    return pool->size() > 0 ? std::nullopt : std::optional(DiagnoseBetween());
  }
  const int wanted = options_.sampling.candidates;
  for (int wave = 0; wave < kWaves && pool->size() < wanted; ++wave) {
    const int before = pool->size();
    std::vector<RouteDraft> drafts = Generate(NextWave(wave, wanted - pool->size()));
    if (wave == 0 && !narrow_way_.empty()) drafts.insert(drafts.begin(), NarrowDraft());
    std::vector<RouteDraft> extra = std::exchange(reversing, {});
    if (wave == 0) {
      std::vector<RouteDraft> taut =
          TautRoutes(layer_, turning_radius_, request_, drafts, std::min(kTautRoutes, wanted / 8),
                     DeriveSeed(options_.seed, streams_used_++));
      ThrowIfStopped(stop_);
      std::move(taut.begin(), taut.end(), std::back_inserter(extra));
    }
    OfferAll(std::move(drafts), pool, static_cast<int>(extra.size()));
    for (RouteDraft& draft : extra) pool->Offer(std::move(draft), kTautSeparation);
    if (progress) progress("sample", pool->size(), wanted);
    if (roadmap_ == nullptr && pool->size() == 0) return DiagnoseBetween();
    if (wave > 0 && pool->size() - before < kLeastYield * (wanted - before)) break;
  }
  pool->FillUp(wanted);
  if (progress) progress("sample", wanted, wanted);
  return std::nullopt;
}

void CandidateSearch::OfferAll(std::vector<RouteDraft> drafts, CandidatePool* pool,
                               int places_to_keep) const {
  const int wanted = options_.sampling.candidates - places_to_keep;
  const std::map<std::string, int> quotas{
      {kRoadmapName, Share(kRoadmapShare, wanted)},
      {OmplPlannerName(OmplPlanner::kRrtConnect), Share(kRrtConnectShare, wanted)}};
  std::map<std::string, int> taken;
  std::vector<RouteDraft> surplus;
  for (RouteDraft& draft : drafts) {
    if (!std::isfinite(draft.cost)) continue;
    ReserveUnsmoothed(&draft, pool);
    const auto quota = quotas.find(draft.origin);
    if (quota != quotas.end() && taken[draft.origin] >= quota->second) {
      surplus.push_back(std::move(draft));
    } else if (pool->size() < wanted) {
      const std::string origin = draft.origin;
      if (pool->Offer(std::move(draft))) ++taken[origin];
    }
  }
  for (RouteDraft& draft : surplus) {
    if (pool->size() < wanted) pool->Offer(std::move(draft));
  }
}

void CandidateSearch::ReserveUnsmoothed(RouteDraft* draft, CandidatePool* pool) const {
  RouteDraft variant{draft->origin, std::move(draft->unsmoothed), draft->unsmoothed_cost, {}};
  draft->unsmoothed.clear();
  if (std::isfinite(variant.cost)) pool->Reserve(std::move(variant));
}

void CandidateSearch::SpanRegion(double margin, const std::vector<Eigen::Vector2d>& places) {
  query_.min_corner = request_.start.cwiseMin(request_.goal);
  query_.max_corner = request_.start.cwiseMax(request_.goal);
  for (const Eigen::Vector2d& place : places) {
    query_.min_corner = query_.min_corner.cwiseMin(place);
    query_.max_corner = query_.max_corner.cwiseMax(place);
  }
  query_.min_corner = (query_.min_corner.array() - margin).matrix().cwiseMax(layer_.min_corner());
  query_.max_corner = (query_.max_corner.array() + margin).matrix().cwiseMin(layer_.max_corner());
}

bool CandidateSearch::ConnectRoadmap() {
  const double distance = (request_.goal - request_.start).norm();
  double margin = kMarginShare * distance + kMarginInRadii * turning_radius_;
  std::vector<Eigen::Vector2d> way;
  if (options_.sampling.narrow_ways) SearchNarrowWays();
  for (int round = 0; round < kRoadmapRounds; ++round) {
    SpanRegion(margin, way);
    // More nodes than this crowd a small region: curves between them would all be loops.
    const double area = (query_.max_corner - query_.min_corner).prod();
    const double crowded = std::max(200.0, 4.0 * area / (turning_radius_ * turning_radius_));
    RoadmapOptions roadmap_options;
    roadmap_options.nodes =
        static_cast<int>(std::min<double>(options_.sampling.roadmap_nodes, crowded)) << round;
    roadmap_options.seed = DeriveSeed(options_.seed, streams_used_++);
    roadmap_ = std::make_unique<Roadmap>(layer_, turning_radius_, query_, roadmap_options, stop_);
    if (!roadmap_->FindRoute().empty()) return true;
    if (round == 0) {
      const CellFlood flood(layer_, request_.start, FloodDirection::kFrom, stop_);
      way = flood.WayTo(request_.goal);
      if (!way.empty()) {
        query_.guides = GuidePoses(layer_, way, turning_radius_);
        SearchNarrowWays();
      }
    } else if (way.empty()) {
      return false;  // nor do the cells connect: more nodes cannot help
    }
    margin *= 2.0;
  }
  return false;
}

void CandidateSearch::SearchNarrowWays() {
  const double distance = (request_.goal - request_.start).norm();
  SpanRegion(kNarrowMargin * (kMarginShare * distance + kMarginInRadii * turning_radius_), {});
  narrow_way_ = SearchLattice(layer_, turning_radius_, query_, {}, stop_);
  query_.guides.insert(query_.guides.end(), narrow_way_.begin(), narrow_way_.end());
}

OmplQuery CandidateSearch::QueryForOmpl(bool reversing) const {
  return {turning_radius_,   query_.starts,     query_.goals,
          query_.min_corner, query_.max_corner, reversing};
}

CandidateSearch::Wave CandidateSearch::NextWave(int wave, int missing) const {
  const int count = Share(kSurplus, missing);
  Wave next;
  next.rrt_connect = Share(kRrtConnectShare, count);
  if (roadmap_ == nullptr) {
    next.rrt_connect = wave == 0 ? kProbes : count;
  } else if (wave == 0) {
    next.roadmap = Share(kRoadmapShare, count);
    next.abit_star = Share(1.0 - kRoadmapShare - kRrtConnectShare, missing);
  } else {
    next.roadmap = 2 * Share(kRoadmapShare, count);
  }
  return next;
}

std::vector<RouteDraft> CandidateSearch::Generate(const Wave& wave) {
  const int sampled = wave.rrt_connect + wave.abit_star;
  std::vector<RouteDraft> drafts(wave.roadmap + sampled);
  const OmplQuery ompl_query = QueryForOmpl(false);
  const std::uint64_t first_stream = streams_used_;
  streams_used_ += drafts.size();
  const auto search_roadmap = [&] {
    const auto routes = PenalizedRoutes(wave.roadmap);
    for (std::size_t i = 0; i < routes.size(); ++i) {
      drafts[i] = {kRoadmapName, routes[i], 0, {}};
    }
  };
  const auto sample = [&] {
    // The long runs first, each a task of its own.
    const auto run = [&](int i) {
      const bool optimize = i < wave.abit_star;
      const OmplPlanner planner = optimize ? OmplPlanner::kAbitStar : OmplPlanner::kRrtConnect;
      const int iterations =
          optimize ? options_.sampling.planner_iterations : kRrtConnectIterations;
      const std::uint64_t seed = DeriveSeed(options_.seed, first_stream + wave.roadmap + i);
      drafts[wave.roadmap + i] = {
          OmplPlannerName(planner),
          SolveWithOmpl(planner, layer_, ompl_query, seed, iterations, stop_),
          0,
          {}};
    };
    tbb::parallel_for(0, sampled, 1, run, tbb::simple_partitioner());
  };
  tbb::parallel_invoke(search_roadmap, sample);
  tbb::parallel_for(std::size_t{0}, drafts.size(), [&](std::size_t i) {
    ThrowIfStopped(stop_);
    Finish(&drafts[i], DeriveSeed(options_.seed, first_stream + i));
  });
  return drafts;
}

RouteDraft CandidateSearch::NarrowDraft() {
  RouteDraft draft{kLatticeName, narrow_way_, 0, {}};
  Finish(&draft, DeriveSeed(options_.seed, streams_used_++));
  return draft;
}

std::vector<RouteDraft> CandidateSearch::ReversingDrafts() {
  LatticeOptions lattice;
  lattice.reversing = true;
  const OmplQuery ompl_query = QueryForOmpl(true);
  const std::uint64_t first_stream = streams_used_;
  const int count = roadmap_ == nullptr ? kReversingDraftsAlone : kReversingDrafts;
  streams_used_ += count;
  std::vector<RouteDraft> drafts(count);
  tbb::parallel_for(0, count, [&](int i) {
    const std::uint64_t seed = DeriveSeed(options_.seed, first_stream + i);
    RouteDraft& draft = drafts[i];
    draft.origin = kReversingName;
    draft.poses = i == 0 ? SearchLattice(layer_, turning_radius_, query_, lattice, stop_)
                         : SolveWithOmpl(OmplPlanner::kRrtConnect, layer_, ompl_query, seed,
                                         kRrtConnectIterations, stop_);
    Finish(&draft, seed);
  });
  // Those without a change of direction are found without the reverse gear too.
  std::erase_if(drafts, [](const RouteDraft& draft) {
    return !std::isfinite(draft.cost) || !Reverses(draft.poses);
  });
  std::stable_sort(drafts.begin(), drafts.end(),
                   [](const RouteDraft& a, const RouteDraft& b) { return a.cost < b.cost; });
  const auto places =
      static_cast<std::size_t>(std::max(1, options_.sampling.candidates / kReversingShare));
  if (roadmap_ != nullptr) drafts.resize(std::min(drafts.size(), places));
  return drafts;
}

std::vector<std::vector<Pose2>> CandidateSearch::PenalizedRoutes(int count) {
  const double distance = (request_.goal - request_.start).norm();
  const double width =
      std::clamp(kPenaltyShare * distance, 2.0 * options_.sampling.min_separation,
                 std::max(kLargestPenaltyWidth, 2.0 * options_.sampling.min_separation));
  std::vector<std::vector<Pose2>> routes;
  for (int i = 0; i < count; ++i) {
    routes.push_back(roadmap_->FindRoute());
    roadmap_->Penalize(Thin(Positions(DensePoses(routes.back(), turning_radius_)), 0.25 * width),
                       width, kPenaltyStrength);
  }
  return routes;
}

void CandidateSearch::Finish(RouteDraft* draft, std::uint64_t seed) const {
  draft->cost = std::numeric_limits<double>::infinity();
  if (draft->poses.empty()) return;
  SmoothingOptions smoothing;
  smoothing.attempts = draft->origin == kRoadmapName ? kRoadmapSmoothing : kSamplerSmoothing;
  smoothing.free_start = !request_.start_heading.has_value();
  smoothing.free_goal = !request_.goal_heading.has_value();
  draft->unsmoothed = DensePoses(draft->poses, turning_radius_);
  SmoothedRoute smooth = SmoothRoute(layer_, turning_radius_, draft->unsmoothed, smoothing, seed);
  draft->unsmoothed_cost = smooth.former_cost;
  draft->poses = std::move(smooth.poses);
  // A cost is finite where all poses after the first are go.
  const Pose2& first = draft->poses.front();
  const bool all_go =
      std::isfinite(smooth.cost) && layer_.Evaluate(first.x, first.y, first.heading).go();
  if (all_go) draft->cost = smooth.cost;
}

std::optional<NoRouteDiagnosis> CandidateSearch::DiagnoseEnds() const {
  const auto standing = [&](const char* name, const Eigen::Vector2d& place, double heading) {
    NoRouteDiagnosis diagnosis;
    diagnosis.reason = layer_.Evaluate(place.x(), place.y(), heading).reason;
    diagnosis.where = place;
    diagnosis.why =
        std::string("the ") + name + " is no place to stand: " + NoGoReasonText(diagnosis.reason);
    return diagnosis;
  };
  const Eigen::Vector2d way = request_.goal - request_.start;
  const double towards = std::atan2(way.y(), way.x());
  if (query_.starts.empty()) {
    return standing("start", request_.start, request_.start_heading.value_or(towards));
  }
  if (query_.goals.empty()) {
    return standing("goal", request_.goal, request_.goal_heading.value_or(towards));
  }
  return std::nullopt;
}

NoRouteDiagnosis CandidateSearch::DiagnoseBetween() const {
  const CellFlood from_start(layer_, request_.start, FloodDirection::kFrom, stop_);
  NoRouteDiagnosis diagnosis;
  if (from_start.Reaches(request_.goal)) {
    const std::vector<Eigen::Vector2d> way = from_start.WayTo(request_.goal);
    diagnosis.where = way[way.size() / 2];
    diagnosis.why =
        "ground connects start and goal, but no curve that the vehicle can steer was found on it";
    return diagnosis;
  }
  const CellFlood to_goal(layer_, request_.goal, FloodDirection::kTo, stop_);
  const bool start_enclosed = from_start.cell_count() < to_goal.cell_count();
  const CellFlood::Barrier barrier = start_enclosed ? from_start.BarrierTowards(request_.goal)
                                                    : to_goal.BarrierTowards(request_.start);
  diagnosis.reason = barrier.reason;
  diagnosis.where = barrier.where;
  diagnosis.why =
      std::string("the ") + (start_enclosed ? "start" : "goal") +
      " is enclosed by ground that cannot be crossed: " + NoGoReasonText(barrier.reason);
  return diagnosis;
}

}  // namespace dbd
