// Decision quality: is the chosen route as good as the best that can be found, and does it hold?
// See docs/benchmarks.md for what the columns mean.
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

#include "decision_sites.h"

namespace dbd {
namespace {

struct Arguments {
  std::string data;
  std::string vehicle = "tomcar-tm27";
  int generated = 2;
  int queries = 20;
  double seconds = 1e9;  // no query is begun later
  int pool = 96;
  int candidates = 32;
  std::uint64_t seed = 1;
  double shortest = 100;  // [m]
  double longest = 250;
};

using Clock = std::chrono::steady_clock;
double SecondsSince(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// A route with its drive as planned and again, more exactly and on ground drawn anew.
struct Judged {
  std::optional<std::size_t> index;  // into the pool and then the plan's candidates
  double score = std::numeric_limits<double>::infinity();
  double time = 0;
  bool reached = false;
  bool holds = false;
};

struct QueryResult {
  std::string site;
  double distance = 0;
  Eigen::Vector2d start, goal;              // map coordinates
  Judged chosen, shortest, cheapest, best;  // the last three of the pool
  double plan_time = 0;
  double sampling_time = 0;  // of the plan: what a kinematic planner would take
  double first_route_time = 0;
};

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
      return layer.Evaluate(p.x(), p.y(), heading).go() && terrain.IsKnown(p.x(), p.y());
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
};

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
                  candidate.path.Heading(0), DriveOptionsFor(candidate, options_));
    judged.holds = again.outcome == Outcome::kReached;
  }

 private:
  Terrain drawn_;
  VehicleModel exact_;
  PlanOptions options_;
};

QueryResult Ask(const Site& site, const std::shared_ptr<const VehicleModel>& vehicle,
                const TrafficabilityLayer& layer, const PlanRequest& request,
                const Arguments& arguments, int query) {
  PlanOptions options;
  options.sampling.candidates = arguments.candidates;
  options.seed = arguments.seed;
  QueryResult result;
  result.site = site.name;
  result.distance = (request.goal - request.start).norm();
  result.start = site.terrain->frame().ToMap(request.start);
  result.goal = site.terrain->frame().ToMap(request.goal);
  const auto begin = Clock::now();
  const Plan plan = PlanRoute(site.terrain, vehicle, request, options);
  result.plan_time = SecondsSince(begin);
  result.first_route_time = plan.first_route_time.value_or(result.plan_time);
  for (const auto& [stage, seconds] : plan.timing) {
    if (stage != "rollouts") result.sampling_time += seconds;
  }
  PlanOptions many = options;
  many.sampling.candidates = arguments.pool;
  many.seed = arguments.seed + 1;
  Driven driven{
      SampleCandidates(*site.terrain, *vehicle, layer, request, many, {}).candidates, {}, {}};
  driven.rollouts = EvaluateRollouts(*site.terrain, *vehicle, driven.candidates, many, {}, {});
  driven.scores = ScoreRollouts(driven.rollouts, many.scoring);
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
  driven.candidates.insert(driven.candidates.end(), plan.candidates.begin(), plan.candidates.end());
  driven.rollouts.insert(driven.rollouts.end(), plan.rollouts.begin(), plan.rollouts.end());
  driven.scores.insert(driven.scores.end(), plan.scores.begin(), plan.scores.end());
  if (plan.chosen) result.chosen.index = pooled + static_cast<std::size_t>(*plan.chosen);
  const Judge judge(*site.terrain, *vehicle, options, query);
  for (Judged* judged : {&result.chosen, &result.shortest, &result.cheapest, &result.best}) {
    judge.Complete(driven, *judged);
  }
  return result;
}

double Regret(const QueryResult& result) { return result.chosen.score / result.best.score - 1; }

const char* Verdict(const Judged& judged) {
  return !judged.index ? "none" : !judged.reached ? "fails" : judged.holds ? "holds" : "breaks";
}

void PrintRoute(const char* name, const Judged& judged) {
  std::printf("| %s %7.1f %-6s ", name, judged.score, Verdict(judged));
}

void PrintQuery(int number, const QueryResult& r) {
  std::printf("%3d %-9s %4.0f m ", number, r.site.c_str(), r.distance);
  PrintRoute("chosen", r.chosen);
  PrintRoute("shortest", r.shortest);
  PrintRoute("cheapest", r.cheapest);
  PrintRoute("best", r.best);
  if (r.best.reached && r.chosen.reached) std::printf("| regret %5.1f %% ", 100 * Regret(r));
  std::printf("| %.2f s | %.1f,%.1f %.1f,%.1f\n", r.plan_time, r.start.x(), r.start.y(), r.goal.x(),
              r.goal.y());
  std::fflush(stdout);
}

double Quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
}

void PrintShare(const char* what, long part, long whole) {
  std::printf("%-58s %3ld of %3ld", what, part, whole);
  if (whole > 0)
    std::printf("  (%.1f %%)", 100.0 * static_cast<double>(part) / static_cast<double>(whole));
  std::printf("\n");
}

/// One route's worth against the chosen one's.
void PrintAgainst(const char* name, const std::vector<QueryResult>& results,
                  const Judged QueryResult::*other) {
  std::vector<double> ratios;
  long reached = 0, holds = 0, better = 0, solved = 0;
  for (const QueryResult& r : results) {
    if (!r.best.reached) continue;
    ++solved;
    const Judged& judged = r.*other;
    reached += judged.reached, holds += judged.holds;
    better += r.chosen.score < judged.score;
    if (judged.reached && r.chosen.reached) ratios.push_back(r.chosen.time / judged.time);
  }
  std::printf(
      "%-16s reached %ld, holds %ld of %ld; chosen scores better in %ld; chosen's time / its: "
      "median %.3f\n",
      name, reached, holds, solved, better, Quantile(ratios, 0.5));
}

void PrintSummary(const std::vector<QueryResult>& results) {
  std::vector<double> regrets, plan, first, sampling;
  long solved = 0, answered = 0, holdable = 0, holds = 0;
  for (const QueryResult& r : results) {
    plan.push_back(r.plan_time), first.push_back(r.first_route_time);
    sampling.push_back(r.sampling_time);
    if (!r.best.reached) continue;
    ++solved;
    answered += r.chosen.reached;
    if (r.chosen.reached) regrets.push_back(100 * Regret(r));
    holdable += r.best.holds || r.chosen.holds || r.shortest.holds || r.cheapest.holds;
    holds += r.chosen.holds;
  }
  std::printf("\n%zu queries, %ld with a route in the pool\n", results.size(), solved);
  PrintShare("answered with a route where there is one", answered, solved);
  PrintShare("chosen route holds, where one of those driven again does", holds, holdable);
  std::printf("regret: median %.1f %%, p95 %.1f %%, max %.1f %%\n", Quantile(regrets, 0.5),
              Quantile(regrets, 0.95), Quantile(regrets, 1));
  PrintAgainst("shortest", results, &QueryResult::shortest);
  PrintAgainst("cheapest", results, &QueryResult::cheapest);
  PrintAgainst("best of all", results, &QueryResult::best);
  std::printf(
      "time: plan median %.2f s, first driven route %.2f s, layer and sampling alone %.2f s\n",
      Quantile(plan, 0.5), Quantile(first, 0.5), Quantile(sampling, 0.5));
}

void Run(const Arguments& arguments) {
  std::vector<Site> sites = GenerateSites(arguments.generated);
  if (!arguments.data.empty()) {
    for (Site& site : LoadSites(arguments.data)) sites.push_back(std::move(site));
  }
  const auto vehicle = LoadVehicle(arguments.vehicle);
  std::vector<TrafficabilityLayer> layers;
  for (const Site& site : sites)
    layers.emplace_back(*site.terrain, *vehicle, PlanOptions{}.max_speed);
  std::mt19937_64 random(arguments.seed);
  std::vector<QueryResult> results;
  const auto begin = Clock::now();
  for (int i = 0; i < arguments.queries && SecondsSince(begin) < arguments.seconds; ++i) {
    const std::size_t at = static_cast<std::size_t>(i) % sites.size();
    const auto request = DrawRequest(*sites[at].terrain, layers[at], arguments, random);
    if (!request) continue;
    results.push_back(Ask(sites[at], vehicle, layers[at], *request, arguments, i));
    PrintQuery(i, results.back());
  }
  PrintSummary(results);
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
  app.add_option("--seed", arguments.seed);
  CLI11_PARSE(app, argc, argv);
  dbd::Run(arguments);
}
