#include "json_parts.h"

#include <dbd/planner/scoring.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "limit_units.h"
#include "trace_table.h"
#include "versions.h"

namespace dbd {
namespace {

using nlohmann::ordered_json;

ordered_json MarginJson(const LimitMargin& margin, const LocalFrame& frame) {
  const LimitUnit unit = UnitOfLimit(margin.name);
  return {{"name", margin.name},
          {"limit", Rounded(margin.limit * unit.factor, 4)},
          {"worst", Rounded(margin.worst * unit.factor, 4)},
          {"unit", unit.name},
          {"margin", Rounded(margin.margin, 4)},
          {"distance", Rounded(margin.s, 2)},
          {"place", PlaceJson(frame, margin.place)}};
}

ordered_json TableJson(const std::vector<TraceSample>& rows, const LocalFrame& frame) {
  ordered_json table = ordered_json::object();
  for (const TraceColumn& column : TraceColumns(frame)) {
    ordered_json values = ordered_json::array();
    for (const TraceSample& row : rows)
      values.push_back(Rounded(column.value(row), column.decimals));
    table[column.name] = std::move(values);
  }
  return table;
}

}  // namespace

std::string JsonText(const ordered_json& document) {
  return document.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

double Rounded(double value, int decimals) {
  const double scale = std::pow(10.0, decimals);
  return std::round(value * scale) / scale;
}

ordered_json LonLatJson(const LocalFrame& frame, const Eigen::Vector2d& local) {
  const Eigen::Vector2d lon_lat = frame.ToWgs84(local);
  return ordered_json::array({Rounded(lon_lat.x(), 8), Rounded(lon_lat.y(), 8)});
}

ordered_json PlaceJson(const LocalFrame& frame, const Eigen::Vector2d& local) {
  const Eigen::Vector2d map = frame.ToMap(local);
  ordered_json place = {{"map", ordered_json::array({Rounded(map.x(), 3), Rounded(map.y(), 3)})}};
  if (frame.has_crs()) place["lon_lat"] = LonLatJson(frame, local);
  return place;
}

ordered_json PlaceJson(const LocalFrame& frame, const Eigen::Vector3d& local) {
  ordered_json place = PlaceJson(frame, Eigen::Vector2d(local.head<2>()));
  place["height"] = Rounded(local.z(), 3);
  return place;
}

ordered_json RolloutJson(const Rollout& rollout, const LocalFrame& frame) {
  return {{"outcome", OutcomeName(rollout.outcome)},  {"reason", rollout.reason},
          {"place", PlaceJson(frame, rollout.place)}, {"length", Rounded(rollout.distance, 3)},
          {"time", Rounded(rollout.time, 3)},         {"energy", Rounded(rollout.energy, 1)},
          {"progress", Rounded(rollout.progress, 4)}};
}

ordered_json RouteJson(const Plan& plan) {
  if (!plan.chosen) return nullptr;
  const auto index = static_cast<std::size_t>(*plan.chosen);
  const Rollout& chosen = plan.rollouts[index];
  return {{"candidate", index},
          {"origin", plan.candidates[index].origin},
          {"length", Rounded(chosen.distance, 3)},
          {"time", Rounded(chosen.time, 3)},
          {"mean_speed", Rounded(chosen.time > 0 ? chosen.distance / chosen.time : 0, 3)},
          {"energy", Rounded(chosen.energy, 1)},
          {"score", Rounded(plan.scores[index].total, 3)}};
}

ordered_json CertificateJson(const Rollout& rollout, const LocalFrame& frame) {
  ordered_json margins = ordered_json::array();
  for (const LimitMargin& margin : rollout.margins) margins.push_back(MarginJson(margin, frame));
  ordered_json certificate = {{"margins", std::move(margins)}};
  const LimitMargin* binding = TightestLimit(rollout);
  certificate["binding"] = binding ? ordered_json(binding->name) : ordered_json(nullptr);
  certificate["per_meter"] = TableJson(WorstPerMeter(rollout.trace), frame);
  return certificate;
}

ordered_json SuccessJson(const SuccessEstimate& estimate, const LocalFrame& frame) {
  ordered_json success = {{"draws", estimate.draws},
                          {"reached", estimate.reached},
                          {"share", Rounded(estimate.share(), 4)},
                          {"p_go", Rounded(estimate.p_go(), 4)},
                          {"interval_95", {Rounded(estimate.low, 4), Rounded(estimate.high, 4)}},
                          {"mean_time", Rounded(estimate.mean_time, 3)},
                          {"cvar_10_time", Rounded(estimate.cvar_time, 3)},
                          {"mean_score", Rounded(estimate.mean_score, 3)}};
  if (!estimate.failure.empty()) {
    success["failure"] = estimate.failure;
    success["failed_at"] = PlaceJson(frame, estimate.failed_at);
  }
  return success;
}

ordered_json VersionsJson() {
  ordered_json versions = ordered_json::object();
  for (const auto& [name, version] : Versions()) versions[name] = version;
  return versions;
}

}  // namespace dbd
