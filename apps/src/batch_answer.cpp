#include "batch_answer.h"

#include <dbd/planner/scoring.h>

#include <map>
#include <nlohmann/json.hpp>

#include "json_parts.h"
#include "text.h"

namespace dbd {
namespace {

using nlohmann::ordered_json;

constexpr std::size_t kLongestReason = 500;  // a hostile request may quote itself

ordered_json OutcomesJson(const Plan& plan) {
  std::map<std::string, int> counts;
  for (const Rollout& rollout : plan.rollouts) ++counts[OutcomeName(rollout.outcome)];
  return ordered_json(counts);
}

/// The driven line, in the coordinates of the elevation file.
ordered_json LineJson(const Rollout& rollout, const LocalFrame& frame) {
  ordered_json line = ordered_json::array();
  for (const TraceSample& sample : rollout.trace) {
    const Eigen::Vector2d map = frame.ToMap({sample.x, sample.y});
    line.push_back({Rounded(map.x(), 2), Rounded(map.y(), 2), Rounded(sample.z, 2)});
  }
  return line;
}

void AddPlan(const JobResult& result, ordered_json& answer) {
  const Plan& plan = result.plan;
  const LocalFrame& frame = result.inputs.terrain->frame();
  answer["route"] = RouteJson(plan);
  if (plan.chosen) {
    const Rollout& chosen = plan.rollouts[static_cast<std::size_t>(*plan.chosen)];
    const LimitMargin* binding = TightestLimit(chosen);
    if (binding) answer["route"]["tightest"] = {binding->name, Rounded(binding->margin, 4)};
    answer["route"]["map_line"] = LineJson(chosen, frame);
  }
  answer["blocked_at"] =
      plan.blocked_at ? PlaceJson(frame, *plan.blocked_at) : ordered_json(nullptr);
  answer["outcomes"] = OutcomesJson(plan);
  answer["simulated_time"] = Rounded(plan.simulated_time, 3);
  answer["digest"] = HashText(plan.digest);
}

}  // namespace

std::string StatusOf(const JobResult& result) {
  if (result.state == JobState::kDone) return PlanStatusName(result.plan.status);
  return result.state == JobState::kCancelled ? "cancelled" : "error";
}

std::string ReasonOf(const JobResult& result) {
  const std::string& text = result.state == JobState::kDone ? result.plan.reason : result.error;
  return OneLine(text.size() > kLongestReason ? text.substr(0, kLongestReason) + "..." : text);
}

std::string BatchAnswer(std::size_t line, const std::string& id, const JobResult& result) {
  const bool done = result.state == JobState::kDone;
  ordered_json answer = {{"schema", "dbd.result/1"},
                         {"id", id},
                         {"line", line},
                         {"status", StatusOf(result)},
                         {"reason", ReasonOf(result)}};
  if (done) AddPlan(result, answer);
  return answer.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

}  // namespace dbd
