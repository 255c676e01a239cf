// Decision quality: is the chosen route as good as the best that can be found, and does it hold?
// See docs/benchmarks.md for what the columns mean.
#include <dbd/core/error.h>
#include <dbd/core/vehicle_database.h>
#include <dbd/core/vehicle_variant.h>
#include <dbd/planner/batch_evaluation.h>
#include <dbd/planner/candidate_flood.h>
#include <dbd/planner/candidate_sampler.h>
#include <dbd/planner/drive.h>
#include <dbd/planner/plan_route.h>
#include <dbd/planner/scoring.h>
#include <dbd/planner/terrain_draw.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <optional>
#include <random>
#include <sstream>
#include <string>

#include "decision_results.h"
#include "decision_sites.h"
#include "decision_table.h"

namespace dbd {
namespace {

struct Arguments {
  std::string data;
  std::string vehicle = "tomcar-tm27";
  int generated = 2;
  int queries = 20;
  double seconds = 1e9;  // no query is begun later
  int pool = 96;
  int candidates = PlanOptions{}.sampling.candidates;
  int draws = 1;  // of the plan: 1 = it trusts the terrain as it is given
  std::uint64_t seed = 1;
  double shortest = 100;  // [m]
  double longest = 250;
  std::string site;     // all
  std::string results;  // none
};

using Clock = std::chrono::steady_clock;
double SecondsSince(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// Ends lie where the layer expects at least a fifth of full speed: nobody starts from mud.
constexpr double kSlowestEnd = 5;

/// Two places at a distance within the bounds, on ground that the layer holds for drivable and for
/// connected.
std::optional<PlanRequest> DrawRequest(const Terrain& terrain, const TrafficabilityLayer& layer,
                                       const Arguments& arguments, std::mt19937_64& random) {
  const auto uniform = [&random](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1.0p-53;
  };
  const Eigen::Vector2d min = layer.min_corner(), max = layer.max_corner();
  for (int i = 0; i < 2000; ++i) {
    PlanRequest request;
    request.start = {uniform(min.x(), max.x()), uniform(min.y(), max.y())};
    const double heading = uniform(0, 6.283185307179586);
    const double distance = uniform(arguments.shortest, arguments.longest);
    request.goal = request.start + distance * Eigen::Vector2d(std::cos(heading), std::sin(heading));
    const auto stands = [&](const Eigen::Vector2d& p) {
      return terrain.IsKnown(p.x(), p.y()) &&
             layer.SecondsPerMetre(p.x(), p.y(), heading) < kSlowestEnd / PlanOptions{}.max_speed;
    };
    if (!stands(request.start) || !stands(request.goal)) continue;
    if (CellFlood(layer, request.start, FloodDirection::kFrom).Reaches(request.goal)) {
      return request;
    }
  }
  return std::nullopt;
}

/// Everything that was driven for one query.
struct Driven {
  std::vector<Candidate> candidates;
  std::vector<Rollout> rollouts;
  std::vector<Score> scores;

  void Add(const std::vector<Candidate>& more, const std::vector<Rollout>& their_rollouts,
           const std::vector<Score>& their_scores) {
    candidates.insert(candidates.end(), more.begin(), more.end());
    rollouts.insert(rollouts.end(), their_rollouts.begin(), their_rollouts.end());
    scores.insert(scores.end(), their_scores.begin(), their_scores.end());
  }
};

/// In portions with seeds of their own: the effort of sampling grows faster than the number of
/// routes that it must tell apart.
Driven DrivePool(const Terrain& terrain, const VehicleModel& vehicle,
                 const TrafficabilityLayer& layer, const PlanRequest& request, PlanOptions options,
                 int count) {
  constexpr int kPortion = 64;
  Driven pool;
  for (int begun = 0; begun < count; begun += kPortion) {
    ++options.seed;
    options.sampling.candidates = std::min(kPortion, count - begun);
    const auto sampled = SampleCandidates(terrain, vehicle, layer, request, options, {});
    const auto rollouts = EvaluateRollouts(terrain, vehicle, sampled.candidates, options, {}, {});
    pool.Add(sampled.candidates, rollouts, ScoreRollouts(rollouts, options.scoring));
  }
  return pool;
}

bool IsBetter(const Score& a, const Score& b) {
  return std::pair(!a.feasible, a.total) < std::pair(!b.feasible, b.total);
}

template <typename Less>
Judged PickBy(const Driven& driven, const Less& less) {
  Judged judged;
  for (std::size_t i = 0; i < driven.candidates.size(); ++i) {
    if (!judged.index || less(i, *judged.index)) judged.index = i;
  }
  return judged;
}

class Judge {
 public:
  Judge(const Terrain& terrain, const VehicleModel& vehicle, const PlanOptions& options, int query)
      : drawn_(DrawTerrain(terrain, {}, options.seed + 1000003, query)),
        exact_(WithSteps(vehicle, 0.5)),
        options_(options) {}

  void Complete(const Driven& driven, Judged& judged) const {
    if (!judged.index) return;
    const Candidate& candidate = driven.candidates[*judged.index];
    const Rollout& rollout = driven.rollouts[*judged.index];
    judged.score = driven.scores[*judged.index].total;
    judged.time = rollout.time;
    judged.reached = rollout.outcome == Outcome::kReached;
    const Rollout again =
        DrivePath(drawn_, exact_, candidate.path, candidate.path.Position(0),
                  candidate.path.VehicleHeading(0), DriveOptionsFor(candidate, options_));
    judged.holds = again.outcome == Outcome::kReached;
  }

 private:
  Terrain drawn_;
  VehicleModel exact_;
  PlanOptions options_;
};

/// What the same choice takes without a drive [s]: the layer, as many candidates, the cheapest.
double KinematicTime(const Site& site, const VehicleModel& vehicle, const PlanRequest& request,
                     const PlanOptions& options) {
  const auto begin = Clock::now();
  const TrafficabilityLayer layer(*site.terrain, vehicle, options.max_speed);
  SampleCandidates(*site.terrain, vehicle, layer, request, options, {});  // cheapest first
  return SecondsSince(begin);
}

QueryResult Ask(const Site& site, const std::shared_ptr<const VehicleModel>& vehicle,
                const TrafficabilityLayer& layer, const PlanRequest& request,
                const Arguments& arguments, int query) {
  PlanOptions options;
  options.sampling.candidates = arguments.candidates;
  options.seed = arguments.seed;
  options.uncertainty.draws = arguments.draws;
  QueryResult result;
  result.site = site.name;
  result.distance = (request.goal - request.start).norm();
  result.start = site.terrain->frame().ToMap(request.start);
  result.goal = site.terrain->frame().ToMap(request.goal);
  const auto begin = Clock::now();
  const Plan plan = PlanRoute(site.terrain, vehicle, request, options);
  result.plan_time = SecondsSince(begin);
  result.first_route_time = plan.first_route_time;
  result.kinematic_time = KinematicTime(site, *vehicle, request, options);
  Driven driven = DrivePool(*site.terrain, *vehicle, layer, request, options, arguments.pool);
  const std::size_t pooled = driven.candidates.size();
  result.shortest = PickBy(driven, [&](std::size_t a, std::size_t b) {
    return driven.candidates[a].path.length() < driven.candidates[b].path.length();
  });
  result.cheapest = PickBy(driven, [&](std::size_t a, std::size_t b) {
    return driven.candidates[a].layer_cost < driven.candidates[b].layer_cost;
  });
  result.best = PickBy(driven, [&](std::size_t a, std::size_t b) {
    return driven.scores[a].total < driven.scores[b].total;
  });
  driven.Add(plan.candidates, plan.rollouts, plan.scores);
  if (plan.chosen) result.chosen.index = pooled + static_cast<std::size_t>(*plan.chosen);
  const auto trusted = std::min_element(plan.scores.begin(), plan.scores.end(), IsBetter);
  if (trusted != plan.scores.end()) {
    result.trusting.index = pooled + static_cast<std::size_t>(trusted - plan.scores.begin());
  }
  const Judge judge(*site.terrain, *vehicle, options, query);
  for (Judged* judged :
       {&result.chosen, &result.trusting, &result.shortest, &result.cheapest, &result.best}) {
    judge.Complete(driven, *judged);
  }
  return result;
}

/// All on which the answer to a query of a number depends.
std::string SettingsOf(const Arguments& a) {
  std::ostringstream text;
  text << "seed " << a.seed << ", " << a.vehicle << ", generated " << a.generated << ", data "
       << (a.data.empty() ? "none" : "given") << ", site " << (a.site.empty() ? "all" : a.site)
       << ", " << a.shortest << " to " << a.longest << " m, pool " << a.pool << ", candidates "
       << a.candidates << ", draws " << a.draws;
  return text.str();
}

void Run(const Arguments& arguments) {
  std::vector<Site> sites = GenerateSites(arguments.generated);
  if (!arguments.data.empty()) {
    for (Site& site : LoadSites(arguments.data)) sites.push_back(std::move(site));
  }
  if (!arguments.site.empty()) {
    std::erase_if(sites, [&](const Site& site) { return site.name != arguments.site; });
    if (sites.empty()) throw InputError("--site: there is no site '" + arguments.site + "'");
  }
  const auto vehicle = LoadVehicle(arguments.vehicle);
  std::vector<TrafficabilityLayer> layers;
  for (const Site& site : sites)
    layers.emplace_back(*site.terrain, *vehicle, PlanOptions{}.max_speed);
  std::mt19937_64 random(arguments.seed);
  DecisionResults results(arguments.results, SettingsOf(arguments));
  const auto begin = Clock::now();
  for (int i = 0; i < arguments.queries && SecondsSince(begin) < arguments.seconds; ++i) {
    const std::size_t at = static_cast<std::size_t>(i) % sites.size();
    const auto request = DrawRequest(*sites[at].terrain, layers[at], arguments, random);
    if (!request || results.Has(i)) continue;
    const QueryResult result = Ask(sites[at], vehicle, layers[at], *request, arguments, i);
    PrintQuery(i, result);
    results.Add(i, result);
  }
  PrintSummary(results.All());
}

}  // namespace
}  // namespace dbd

int main(int argc, char** argv) {
  dbd::Arguments arguments;
  CLI::App app("How good the chosen routes are, over seeded queries");
  app.add_option("--data", arguments.data, "Directory with real data sets");
  app.add_option("--vehicle", arguments.vehicle);
  app.add_option("--generated", arguments.generated, "Generated landscapes");
  app.add_option("--queries", arguments.queries);
  app.add_option("--seconds", arguments.seconds, "No query is begun later");
  app.add_option("--pool", arguments.pool, "Candidates of the exhaustive pool");
  app.add_option("--candidates", arguments.candidates, "Of the plan");
  app.add_option("--draws", arguments.draws, "Of the terrain, on which the plan's best are driven");
  app.add_option("--shortest", arguments.shortest, "Least distance of a query [m]");
  app.add_option("--longest", arguments.longest, "Largest [m]");
  app.add_option("--site", arguments.site, "Only this one, as named in the table");
  app.add_option("--seed", arguments.seed);
  app.add_option("--results", arguments.results,
                 "File that keeps what each query came to: run again, only the rest is asked");
  CLI11_PARSE(app, argc, argv);
  try {
    dbd::Run(arguments);
  } catch (const dbd::InputError& error) {
    std::fprintf(stderr, "decision_benchmark: %s\n", error.what());
    return 2;
  }
}
