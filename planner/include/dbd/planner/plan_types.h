#pragma once

#include <dbd/core/path.h>
#include <dbd/planner/terrain_spread.h>

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace dbd {

/// How candidates are sampled. Every budget is an amount of work, never a time, so that the
/// same request gives the same candidates.
struct SamplingOptions {
  int candidates = 96;           ///< routes to drive
  int roadmap_nodes = 3000;      ///< of the penalised-search roadmap
  int planner_iterations = 700;  ///< of each OPTIMISING planner run
  double min_separation = 5.0;   ///< routes nearer to each other than this are the same [m]
  bool narrow_ways = false;      ///< search a lattice even where random samples find routes
  bool reversing = false;        ///< routes may change between forward and reverse
};

/// How the budget of driven candidates is spent: some are driven first, what they met guides the
/// search for more, and the best are varied beside these.
struct LearningOptions {
  int rounds = 3;              ///< of sampling and driving, at most; 1 = nothing is learnt
  double first_share = 0.5;    ///< of the candidates, in the first round
  double polish_share = 0.25;  ///< of the candidates, for variants of the best
};

/// What makes one route better than another: seconds that one unit is worth.
struct ScoringOptions {
  double energy_weight = 2e-4;  ///< [s/J]
  double risk_weight = 30.0;    ///< [s] at no margin left
};

/// What is asked of a route although the ground is not known exactly.
struct UncertaintyOptions {
  int draws = 1;           ///< of the terrain, driven by the best candidates; 1 = as it is given
  double min_success = 0;  ///< share of the draws on which a route must reach the goal
  int survivors = 6;       ///< most candidates that are driven on the draws
  TerrainSpread spread;
};

/// What drives the candidates.
enum class RolloutEngine {
  kLanes,      ///< many vehicles at once in single precision (`SimulationLanes`)
  kReference,  ///< one vehicle at a time in double precision (`Simulation`)
};

/// As a number of threads: those of the TBB arena that the plan is asked for in, so that a host
/// program hands in its own with `arena.execute([&] { PlanRoute(...); })`.
inline constexpr int kCallersArena = -1;

struct PlanOptions {
  SamplingOptions sampling;
  LearningOptions learning;
  UncertaintyOptions uncertainty;
  ScoringOptions scoring;
  std::uint64_t seed = 1;
  double max_speed = 8.0;  ///< target speed on open ground [m/s]
  int threads = 0;         ///< 0 = all; or kCallersArena
  RolloutEngine engine = RolloutEngine::kLanes;
  double goal_tolerance = 2.0;  ///< [m]
  /// Wall time for the answer [s]; then the best so far is given. Infinite: as long as it takes.
  double deadline = std::numeric_limits<double>::infinity();

  /// Throws InputError that names the field, its value and the rule.
  void Validate() const;
};

/// Where from and where to, in W.
struct PlanRequest {
  Eigen::Vector2d start = Eigen::Vector2d::Zero();
  std::optional<double> start_heading;  ///< [rad], 0 = east, counter-clockwise
  Eigen::Vector2d goal = Eigen::Vector2d::Zero();
  std::optional<double> goal_heading;
};

/// A part of a route that is driven no faster than this.
struct SpeedCap {
  double from = 0;   ///< arc length [m]
  double to = 0;     ///< [m]
  double speed = 0;  ///< [m/s]
};

/// A route that was sampled and not yet driven. Its index is its name in every list and file.
struct Candidate {
  std::string origin;  ///< the planner that found it
  Path path;
  double layer_cost = 0;  ///< cost by the trafficability layer [s]
  /// Besides what ground and driver ask for.
  std::vector<SpeedCap> speed_caps = {};
  /// Where the drive should go along, when `path` is not that but what a driver makes it of.
  Path meant = {};
};

/// How a drive ended.
enum class Outcome {
  kReached,
  kImmobilized,
  kRolledOver,
  kCollided,
  kLeftMap,
  kLimitExceeded,
  kTimedOut,
  kDiverged,
  kCancelled,
};
const char* OutcomeName(Outcome outcome);

/// One row of the trace: the vehicle every so many metres. SI, angles [rad].
struct TraceSample {
  double t = 0;
  double s = 0;  ///< driven distance
  double x = 0;  ///< chassis centre of mass in W
  double y = 0;
  double z = 0;
  double ground_z = 0;  ///< below the centre of mass
  double yaw = 0;
  double pitch = 0;  ///< positive nose down
  double roll = 0;   ///< positive left side up
  double speed = 0;  ///< negative in reverse, as is the next
  double target_speed = 0;
  double slip = 0;                  ///< of the driven wheel that slips most, signed
  double sinkage = 0;               ///< deepest wheel
  double net_traction_reserve = 0;  ///< (available - used) net traction / weight
  double clearance = 0;             ///< least, belly to ground
  double load_transfer_ratio = 0;   ///< 0 even, 1 a side lifts
  double ground_slope = 0;          ///< steepest direction, under the vehicle
  double power = 0;                 ///< at the driven wheels [W]
  double absorbed_power = 0;        ///< vertical, mean over the last 10 s [W]
  /// Largest vertical acceleration below 30 Hz since the judge last looked [m/s^2].
  double vertical_acceleration = 0;
};

/// One limit of the certificate: the worst value met and where.
struct LimitMargin {
  std::string name;  ///< "roll", "pitch", "slope", "sinkage", "clearance", "load_transfer",
                     ///< "absorbed_power", "shock"
  double limit = 0;
  double worst = 0;
  double margin = 1;  ///< share of the limit that is left; negative = exceeded
  double s = 0;       ///< driven distance where it was met [m]
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
};

/// What happened when one candidate was driven in full dynamics.
struct Rollout {
  Outcome outcome = Outcome::kDiverged;
  std::string reason;                               ///< one sentence, empty when reached
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< where it ended, in W
  double time = 0;                                  ///< [s]
  double distance = 0;                              ///< driven [m]
  double energy = 0;                                ///< work at the driven wheels [J]
  double progress = 0;                              ///< share of the candidate's path [0, 1]
  std::vector<LimitMargin> margins;
  std::vector<TraceSample> trace;
};

/// Lower is better. Terms are in seconds and add up to `total`.
struct Score {
  bool feasible = false;
  double total = std::numeric_limits<double>::infinity();
  std::vector<std::pair<std::string, double>> terms;
};

/// kDeadline and kCancelled: stopped before the end; with the best route so far, if there is one.
enum class PlanStatus { kRoute, kNoGo, kDeadline, kCancelled };
const char* PlanStatusName(PlanStatus status);

/// How a candidate did on drawn terrains.
struct SuccessEstimate {
  int draws = 0;  ///< that it was driven on
  int reached = 0;
  double low = 0;  ///< 95 % interval of the probability to reach the goal (Wilson 1927)
  double high = 1;
  double mean_time = 0;   ///< of the drives that reached it [s]
  double cvar_time = 0;   ///< mean of their slowest tenth [s]
  double mean_score = 0;  ///< of the drives that reached it [s]
  std::string failure;    ///< why it failed on the first draw on which it did; empty: on none
  Eigen::Vector3d failed_at = Eigen::Vector3d::Zero();  ///< where, in W

  /// Of the draws: what `UncertaintyOptions::min_success` is compared with.
  double share() const { return draws > 0 ? static_cast<double>(reached) / draws : 0; }

  /// P(go): the probability to reach the goal on a fresh draw: the mean of the posterior from
  /// Jeffreys' prior (H. Jeffreys 1946), which holds probabilities near 0 and 1 for likelier than
  /// those between, as those of routes are. The share itself promises too much where few draws all
  /// succeeded, and a flat prior (Laplace's rule) too little. It lies between the share and the
  /// middle of Wilson's interval, so always in the interval.
  double p_go() const { return (reached + 0.5) / (draws + 1.0); }
};

/// What one round of sampling and driving gained.
struct PlanRound {
  std::string name;    ///< "sample", then "learn"
  int candidates = 0;  ///< driven in it; their indices follow those of the round before
  int reached = 0;
  double best_score = std::numeric_limits<double>::infinity();  ///< of all rounds so far [s]
};

/// The answer: the chosen route with its proof, and what became of every other candidate.
struct Plan {
  PlanStatus status = PlanStatus::kNoGo;
  std::string reason;
  std::optional<int> chosen;                  ///< index into the lists below
  std::optional<Eigen::Vector3d> blocked_at;  ///< for kNoGo: the place that says most, in W
  std::vector<Candidate> candidates;
  std::vector<Rollout> rollouts;
  std::vector<Score> scores;
  std::vector<PlanRound> rounds;
  /// By candidate; nothing for those that were not driven on draws.
  std::vector<std::optional<SuccessEstimate>> success;
  std::vector<std::pair<std::string, double>> timing;  ///< seconds per stage, in order
  double simulated_time = 0;                           ///< of all rollouts [s]
  /// Wall time until the first drive reached the goal [s]; nothing when none did.
  std::optional<double> first_route_time;
  std::uint64_t digest = 0;  ///< of everything that must be reproducible
};

/// Called now and then, from any thread but one call at a time: stage name, done, total.
using ProgressCallback = std::function<void(const std::string& stage, int done, int total)>;

}  // namespace dbd
