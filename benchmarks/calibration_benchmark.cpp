// Is P(go) what happens? Candidates on generated landscapes are driven on some draws of the
// terrain, which predict, and on as many fresh ones, which tell: `calibration_benchmark --help`.

#include <dbd/core/vehicle_database.h>
#include <dbd/planner/batch_evaluation.h>
#include <dbd/planner/candidate_sampler.h>
#include <dbd/planner/scoring.h>
#include <dbd/planner/success.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

#include "decision_sites.h"

namespace dbd {
namespace {

struct Arguments {
  int sites = 6;
  int queries = 4;  // on each
  int candidates = 12;
  int draws = 16;
  double distance = 90;  // [m]
};

/// What was predicted and what came of it, for predictions within one bin.
struct Bin {
  struct Drives {
    int draws = 0;
    int reached = 0;
  };

  int candidates = 0;
  double predicted = 0;        // sum
  std::vector<Drives> drives;  // of each query
  int within = 0;              // candidates whose interval holds the fresh share
};
constexpr std::size_t kBins = 5;

void Count(const SuccessEstimate& predicted, const SuccessEstimate& fresh, std::size_t query,
           Bin& bin) {
  ++bin.candidates;
  bin.predicted += predicted.p_go();
  bin.drives.resize(std::max(bin.drives.size(), query + 1));
  bin.drives[query].draws += fresh.draws;
  bin.drives[query].reached += fresh.reached;
  bin.within += fresh.share() >= predicted.low && fresh.share() <= predicted.high;
}

void Ask(const Site& site, const VehicleModel& vehicle, const TrafficabilityLayer& layer,
         const PlanRequest& request, const PlanOptions& options, std::size_t query,
         std::array<Bin, kBins>& bins) {
  const auto candidates =
      SampleCandidates(*site.terrain, vehicle, layer, request, options, {}).candidates;
  const auto rollouts = EvaluateRollouts(*site.terrain, vehicle, candidates, options, {}, {});
  const auto scores = ScoreRollouts(rollouts, options.scoring);
  PlanOptions fresh = options;
  fresh.seed += 1000;
  const auto predicted =
      EstimateSuccess(*site.terrain, vehicle, candidates, scores, options, {}, {});
  const auto told = EstimateSuccess(*site.terrain, vehicle, candidates, scores, fresh, {}, {});
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (!predicted[i] || !told[i]) continue;
    const auto at = static_cast<std::size_t>(predicted[i]->p_go() * kBins);
    Count(*predicted[i], *told[i], query, bins[std::min(at, kBins - 1)]);
  }
}

/// Share of all drives that reached the goal, and its standard error. Drives of one query meet the
/// same draws of the terrain and often the same places: queries are independent, drives are not
/// (ratio estimator over clusters, W. Cochran, "Sampling Techniques", 1977, section 9A).
struct Realised {
  double share = 0, error = 0;
};

Realised RealisedIn(const Bin& bin) {
  double draws = 0, reached = 0, squares = 0, queries = 0;
  for (const Bin::Drives& d : bin.drives) draws += d.draws, reached += d.reached;
  const double share = reached / draws;
  for (const Bin::Drives& d : bin.drives) {
    squares += std::pow(d.reached - share * d.draws, 2);
    queries += d.draws > 0;
  }
  return {share, std::sqrt(squares * queries / std::max(queries - 1, 1.0)) / draws};
}

void Print(const std::array<Bin, kBins>& bins) {
  std::printf(
      "predicted  candidates  mean predicted  realised (95 %% interval)  within own interval\n");
  for (std::size_t i = 0; i < kBins; ++i) {
    const Bin& bin = bins[i];
    if (bin.candidates == 0) continue;
    const Realised realised = RealisedIn(bin);
    constexpr double kNormal95 = 1.96;
    const double low = std::max(0.0, realised.share - kNormal95 * realised.error);
    const double high = std::min(1.0, realised.share + kNormal95 * realised.error);
    std::printf("%3zu-%3zu %%  %10d  %12.1f %%  %8.1f %% (%.1f to %.1f)  %14d\n", 100 * i / kBins,
                100 * (i + 1) / kBins, bin.candidates, 100 * bin.predicted / bin.candidates,
                100 * realised.share, 100 * low, 100 * high, bin.within);
  }
}

void Run(const Arguments& arguments) {
  const auto vehicle = LoadVehicle("tomcar-tm27");
  PlanOptions options;
  options.sampling.candidates = arguments.candidates;
  options.uncertainty.draws = arguments.draws;
  options.uncertainty.survivors = arguments.candidates;
  options.uncertainty.min_success = 0.5;
  std::mt19937_64 random(1);
  const auto uniform = [&random] { return static_cast<double>(random() >> 11) * 0x1.0p-53; };
  std::array<Bin, kBins> bins;
  std::size_t query = 0;
  for (const Site& site : GenerateSites(arguments.sites)) {
    const TrafficabilityLayer layer(*site.terrain, *vehicle, options.max_speed);
    const Eigen::Vector2d extent = layer.max_corner() - layer.min_corner();
    for (int i = 0; i < arguments.queries; ++i) {
      options.seed += 10'000;  // draws of its own: the same luck in all queries would tell nothing
      PlanRequest request;
      request.start = layer.min_corner() + (0.3 + 0.4 * uniform()) * extent;
      const double heading = 6.283185307179586 * uniform();
      request.goal = request.start +
                     arguments.distance * Eigen::Vector2d(std::cos(heading), std::sin(heading));
      Ask(site, *vehicle, layer, request, options, query++, bins);
    }
  }
  Print(bins);
}

}  // namespace
}  // namespace dbd

int main(int argc, char** argv) {
  dbd::Arguments arguments;
  CLI::App app("Predicted against realised success");
  app.add_option("--sites", arguments.sites, "Generated landscapes, every other one soft");
  app.add_option("--queries", arguments.queries, "On each site");
  app.add_option("--candidates", arguments.candidates, "Of each query");
  app.add_option("--draws", arguments.draws, "For the prediction, and as many fresh ones");
  CLI11_PARSE(app, argc, argv);
  dbd::Run(arguments);
}
