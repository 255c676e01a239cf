#include "summary.h"

#include <dbd/planner/scoring.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "json_parts.h"
#include "limit_units.h"
#include "text.h"

namespace dbd {
namespace {

constexpr double kJoulesPerKilowattHour = 3.6e6;

std::string Words(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

std::string Capitalized(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z')
    text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

std::string Row(const char* label, const std::string& text) {
  return Format("  %-10s %s\n", label, text.c_str());
}

/// Wall time of the stages that `counts` says yes to [s].
template <typename Predicate>
double WallTime(const Plan& plan, Predicate counts) {
  double sum = 0;
  for (const auto& [stage, seconds] : plan.timing) sum += counts(stage) ? seconds : 0;
  return sum;
}

std::string SimulationSpeed(const Plan& plan) {
  const double driving =
      WallTime(plan, [](const std::string& s) { return s == "rollouts" || s == "draws"; });
  std::string text = Format("%.0f s of driving", plan.simulated_time);
  if (driving > 0) {
    text += Format(" in %.2f s (%.0f x real time)", driving, plan.simulated_time / driving);
  }
  return text + Format(", all in %.2f s", WallTime(plan, [](const std::string&) { return true; }));
}

}  // namespace

std::string DriveTotals(const Rollout& rollout) {
  const double kmh = rollout.time > 0 ? 3.6 * rollout.distance / rollout.time : 0;
  return Format("%s in %s, mean %.1f km/h, %.2f kWh at the wheels",
                FormatLength(rollout.distance).c_str(), FormatDuration(rollout.time).c_str(), kmh,
                rollout.energy / kJoulesPerKilowattHour);
}

std::string TightestLimit(const Rollout& rollout, const LocalFrame& frame) {
  const LimitMargin* binding = TightestLimit(rollout);
  if (!binding) return "";
  const LimitUnit unit = UnitOfLimit(binding->name);
  const double percent = 100 * binding->margin;
  const std::string left =
      percent >= 0 ? Format("%.0f %% left", percent) : Format("exceeded by %.0f %%", -percent);
  return Format("%s %.*f%s, limit %.*f%s (%s), after %.0f m at %s", Words(binding->name).c_str(),
                unit.decimals, binding->worst * unit.factor, unit.symbol, unit.decimals,
                binding->limit * unit.factor, unit.symbol, left.c_str(), binding->s,
                DescribePlace(frame, binding->place).c_str());
}

std::string OutcomeCounts(const std::vector<Rollout>& rollouts) {
  std::map<Outcome, int> counts;
  for (const Rollout& rollout : rollouts) ++counts[rollout.outcome];
  std::string text = std::to_string(rollouts.size()) + " candidates";
  const char* separator = ": ";
  for (const auto& [outcome, count] : counts) {
    text += separator + std::to_string(count) + " " + Words(OutcomeName(outcome));
    separator = ", ";
  }
  return text;
}

std::string SuccessOfRoute(const Plan& plan) {
  if (!plan.chosen || plan.success.empty()) return "";
  const std::optional<SuccessEstimate>& success =
      plan.success[static_cast<std::size_t>(*plan.chosen)];
  if (!success) return "";
  return Format(
      "on %d of %d draws of the terrain: P(go) %.0f %% (95 %% interval %.0f to %.0f %%), "
      "mean %s, slowest tenth %s",
      success->reached, success->draws, 100 * success->p_go(), 100 * success->low,
      100 * success->high, FormatDuration(success->mean_time).c_str(),
      FormatDuration(success->cvar_time).c_str());
}

std::string RoundGains(const std::vector<PlanRound>& rounds) {
  std::string text;
  for (const PlanRound& round : rounds) {
    text += Format("%s%s %d: ", text.empty() ? "" : ", ", round.name.c_str(), round.candidates);
    text += std::isfinite(round.best_score) ? Format("best %.1f s", round.best_score) : "none";
  }
  return text;
}

std::string PlanHeadline(const PlanRecord& record) {
  const Rollout* chosen = record.chosen();
  const std::string& vehicle = record.vehicle.name;
  if (!chosen) return "No safe route for " + vehicle;
  return Format("%s route for %s: %s", FormatLength(chosen->distance).c_str(), vehicle.c_str(),
                FormatDuration(chosen->time).c_str());
}

std::string PlanSubtitle(const PlanRecord& record) {
  const Rollout* chosen = record.chosen();
  const LocalFrame& frame = record.terrain.frame();
  const std::string driven = OutcomeCounts(record.plan.rollouts);
  if (!chosen) return Capitalized(Words(record.plan.reason));
  const std::string limit = TightestLimit(*chosen, frame);
  return limit.empty() ? driven : driven + ". Tightest limit: " + limit;
}

std::string PlanSummary(const PlanRecord& record, const OutputDirectory& output) {
  const Plan& plan = record.plan;
  const LocalFrame& frame = record.terrain.frame();
  std::string text;
  if (const Rollout* chosen = record.chosen()) {
    const std::string& origin = plan.candidates[static_cast<std::size_t>(*plan.chosen)].origin;
    text = Format("Route found: candidate %d (%s)\n", *plan.chosen, origin.c_str());
    if (plan.status != PlanStatus::kRoute) text += Row("stopped", plan.reason);
    text += Row("drive", DriveTotals(*chosen));
    if (const std::string limit = TightestLimit(*chosen, frame); !limit.empty()) {
      text += Row("tightest", limit);
    }
    if (const std::string success = SuccessOfRoute(plan); !success.empty()) {
      text += Row("reached", success);
    }
  } else {
    text = "No safe route: " + Words(plan.reason) + "\n";
    if (plan.blocked_at)
      text += Row("blocked", "at " + DescribePlace(frame, plan.blocked_at->head<2>()));
  }
  if (!plan.rollouts.empty()) {
    text += Row("driven", OutcomeCounts(plan.rollouts));
    text += Row("rounds", RoundGains(plan.rounds));
    text += Row("simulated", SimulationSpeed(plan));
  }
  return text + Row("files", FilesWritten(output));
}

std::string FilesWritten(const OutputDirectory& output) {
  std::string text = output.name() + ":";
  for (const std::string& name : output.staged()) text += " " + name;
  return text;
}

}  // namespace dbd
