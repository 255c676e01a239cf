#include <dbd/core/error.h>
#include <dbd/planner/plan_types.h>

#include <sstream>

namespace dbd {
namespace {

void Require(bool holds, const char* field, double value, const char* rule) {
  if (holds) return;
  std::ostringstream text;
  text << field << " is " << value << ", must be " << rule;
  throw InputError(text.str());
}

}  // namespace

void PlanOptions::Validate() const {
  Require(sampling.candidates >= 1 && sampling.candidates <= 100000, "candidates",
          sampling.candidates, "between 1 and 100000");
  Require(sampling.roadmap_nodes >= 10 && sampling.roadmap_nodes <= 1000000, "roadmap_nodes",
          sampling.roadmap_nodes, "between 10 and 1000000");
  Require(sampling.planner_iterations >= 1, "planner_iterations", sampling.planner_iterations,
          "at least 1");
  Require(sampling.min_separation >= 0, "min_separation", sampling.min_separation, "at least 0");
  Require(scoring.energy_weight >= 0, "energy_weight", scoring.energy_weight, "at least 0");
  Require(scoring.risk_weight >= 0, "risk_weight", scoring.risk_weight, "at least 0");
  Require(max_speed > 0.1 && max_speed < 100, "max_speed", max_speed, "between 0.1 and 100 m/s");
  Require(threads >= kCallersArena && threads <= 1024, "threads", threads,
          "between 0 and 1024, or kCallersArena");
  Require(learning.rounds >= 1 && learning.rounds <= 100, "rounds", learning.rounds,
          "between 1 and 100");
  Require(learning.first_share > 0 && learning.first_share <= 1, "first_share",
          learning.first_share, "between 0 (exclusive) and 1");
  Require(learning.polish_share >= 0 && learning.polish_share < 1, "polish_share",
          learning.polish_share, "between 0 and 1 (exclusive)");
  Require(uncertainty.draws >= 1 && uncertainty.draws <= 10000, "draws", uncertainty.draws,
          "between 1 and 10000");
  Require(uncertainty.min_success >= 0 && uncertainty.min_success <= 1, "min_success",
          uncertainty.min_success, "between 0 and 1");
  Require(uncertainty.survivors >= 1, "survivors", uncertainty.survivors, "at least 1");
  uncertainty.spread.Validate();
  Require(deadline >= 0, "deadline", deadline, "at least 0");
  Require(goal_tolerance > 0, "goal_tolerance", goal_tolerance, "greater than 0");
}

const char* OutcomeName(Outcome outcome) {
  switch (outcome) {
    case Outcome::kReached:
      return "reached";
    case Outcome::kImmobilized:
      return "immobilized";
    case Outcome::kRolledOver:
      return "rolled_over";
    case Outcome::kCollided:
      return "collided";
    case Outcome::kLeftMap:
      return "left_map";
    case Outcome::kLimitExceeded:
      return "limit_exceeded";
    case Outcome::kTimedOut:
      return "timed_out";
    case Outcome::kDiverged:
      return "diverged";
    case Outcome::kCancelled:
      return "cancelled";
  }
  return "unknown";
}

const char* PlanStatusName(PlanStatus status) {
  switch (status) {
    case PlanStatus::kRoute:
      return "route";
    case PlanStatus::kNoGo:
      return "no_go";
    case PlanStatus::kDeadline:
      return "deadline";
    case PlanStatus::kCancelled:
      return "cancelled";
  }
  return "unknown";
}

}  // namespace dbd
