#include "plan_json.h"

#include <dbd/core/units.h>
#include <dbd/planner/polyline_separation.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "json_parts.h"
#include "text.h"

namespace dbd {
namespace {

using nlohmann::ordered_json;

ordered_json EndJson(const LocalFrame& frame, const Eigen::Vector2d& place,
                     const std::optional<double>& yaw) {
  ordered_json end = PlaceJson(frame, place);
  if (yaw) end["heading_deg"] = Rounded(CompassDegrees(*yaw), 3);
  return end;
}

ordered_json TerrainJson(const TerrainArguments& files) {
  ordered_json terrain = {{"dem", files.dem}};
  if (files.band > 0) terrain["band"] = files.band;
  if (!files.crs.empty()) terrain["crs"] = files.crs;
  if (files.unknown_ground != "forbid") {
    terrain["unknown_ground"] = files.unknown_ground;
    terrain["fill_distance_m"] = files.fill_distance_m;
  }
  if (!files.materials.empty()) {
    terrain["materials"] = files.materials;
    terrain["material_table"] = files.material_table;
    if (!files.material_field.empty()) terrain["material_field"] = files.material_field;
    if (!files.unknown_material.empty()) terrain["unknown_material"] = files.unknown_material;
  }
  if (!files.moisture.empty()) terrain["moisture"] = files.moisture;
  if (!files.obstacles.empty()) terrain["obstacles"] = files.obstacles;
  if (!files.obstacles_origin.empty()) terrain["obstacles_origin"] = files.obstacles_origin;
  if (!files.dem_origin.empty()) terrain["dem_origin"] = files.dem_origin;
  if (files.surface_cell_m > 0) terrain["surface_cell_m"] = files.surface_cell_m;
  if (files.rasterise) terrain["rasterise"] = true;
  if (files.unknown_space != "free") terrain["unknown_space"] = files.unknown_space;
  if (!files.surface_model.empty()) {
    terrain["surface_model"] = files.surface_model;
    terrain["surface_threshold_m"] = files.surface_threshold_m;
  }
  return terrain;
}

ordered_json UncertaintyJson(const UncertaintyOptions& uncertainty) {
  return {{"draws", uncertainty.draws},
          {"min_success", uncertainty.min_success},
          {"soil_spread", uncertainty.spread.soil},
          {"elevation_error_m", uncertainty.spread.elevation_error},
          {"elevation_correlation_m", uncertainty.spread.elevation_correlation}};
}

ordered_json RequestJson(const PlanRecord& record) {
  const LocalFrame& frame = record.terrain.frame();
  const PlanRequest& request = record.request;
  return {{"terrain", TerrainJson(record.arguments.terrain)},
          {"map_crs", frame.CrsName()},
          {"vehicle", record.vehicle.name},
          {"start", EndJson(frame, request.start, request.start_heading)},
          {"goal", EndJson(frame, request.goal, request.goal_heading)},
          {"candidates", record.options.sampling.candidates},
          {"deadline_s", record.arguments.deadline_s > 0 ? ordered_json(record.arguments.deadline_s)
                                                         : ordered_json(nullptr)},
          {"rounds", record.options.learning.rounds},
          {"reversing", record.options.sampling.reversing},
          {"uncertainty", UncertaintyJson(record.options.uncertainty)},
          {"max_speed_kmh", Rounded(record.options.max_speed * 3.6, 6)}};
}

ordered_json ScoreJson(const Score& score) {
  ordered_json terms = ordered_json::object();
  for (const auto& [name, seconds] : score.terms) terms[name] = Rounded(seconds, 3);
  return {{"feasible", score.feasible},
          {"total", score.feasible ? ordered_json(Rounded(score.total, 3)) : ordered_json(nullptr)},
          {"terms", std::move(terms)}};
}

ordered_json SpeedCapsJson(const Candidate& candidate) {
  ordered_json caps = ordered_json::array();
  for (const SpeedCap& cap : candidate.speed_caps) {
    caps.push_back({{"from", Rounded(cap.from, 2)},
                    {"to", Rounded(cap.to, 2)},
                    {"speed", Rounded(cap.speed, 3)}});
  }
  return caps;
}

/// How far each candidate is from the one nearest to it.
std::vector<double> SeparationsOf(const std::vector<Candidate>& candidates) {
  constexpr double kPoints = 60;  // of each: every pair is compared point by point
  std::vector<std::vector<Eigen::Vector2d>> lines;
  for (const Candidate& candidate : candidates) {
    lines.push_back(Thin(candidate.path.points(), candidate.path.length() / kPoints));
  }
  return NearestSeparations(lines);
}

ordered_json CandidatesJson(const PlanRecord& record) {
  const Plan& plan = record.plan;
  const std::vector<double> separations = SeparationsOf(plan.candidates);
  ordered_json candidates = ordered_json::array();
  for (std::size_t i = 0; i < plan.rollouts.size(); ++i) {
    ordered_json candidate = {
        {"id", i},
        {"origin", plan.candidates[i].origin},
        {"path_length", Rounded(plan.candidates[i].path.length(), 3)},
        {"reverse_length", Rounded(plan.candidates[i].path.reverse_length(), 3)},
        {"separation", separations.size() > 1 ? ordered_json(Rounded(separations[i], 2))
                                              : ordered_json(nullptr)}};
    if (!plan.candidates[i].speed_caps.empty()) {
      candidate["speed_caps"] = SpeedCapsJson(plan.candidates[i]);
    }
    candidate.update(RolloutJson(plan.rollouts[i], record.terrain.frame()));
    candidate["score"] = ScoreJson(plan.scores[i]);
    if (!plan.success.empty() && plan.success[i]) {
      candidate["success"] = SuccessJson(*plan.success[i], record.terrain.frame());
    }
    candidates.push_back(std::move(candidate));
  }
  return candidates;
}

ordered_json RoundsJson(const Plan& plan) {
  ordered_json rounds = ordered_json::array();
  for (const PlanRound& round : plan.rounds) {
    rounds.push_back(
        {{"name", round.name},
         {"candidates", round.candidates},
         {"reached", round.reached},
         {"best_score", std::isfinite(round.best_score) ? ordered_json(Rounded(round.best_score, 3))
                                                        : ordered_json(nullptr)}});
  }
  return rounds;
}

ordered_json RestsOnJson(const PlanRecord& record) {
  ordered_json items = ordered_json::array();
  for (const BasisItem& item : record.basis) {
    ordered_json json = {{"what", item.what}, {"name", item.name}};
    if (!item.sha256.empty()) json["sha256"] = item.sha256;
    items.push_back(std::move(json));
  }
  return items;
}

ordered_json TimingJson(const Plan& plan) {
  ordered_json timing = ordered_json::object();
  for (const auto& [stage, seconds] : plan.timing) timing[stage] = Rounded(seconds, 4);
  return timing;
}

}  // namespace

std::string PlanJson(const PlanRecord& record) {
  const Plan& plan = record.plan;
  const LocalFrame& frame = record.terrain.frame();
  const Rollout* chosen = record.chosen();
  ordered_json document = {{"schema", "dbd.plan/1"},
                           {"status", PlanStatusName(plan.status)},
                           {"reason", plan.reason},
                           {"request", RequestJson(record)},
                           {"route", RouteJson(plan)}};
  document["blocked_at"] =
      plan.blocked_at ? PlaceJson(frame, *plan.blocked_at) : ordered_json(nullptr);
  document["certificate"] = chosen ? CertificateJson(*chosen, frame) : ordered_json(nullptr);
  document["rounds"] = RoundsJson(plan);
  document["candidates"] = CandidatesJson(record);
  document["first_route_s"] = plan.first_route_time
                                  ? ordered_json(Rounded(*plan.first_route_time, 4))
                                  : ordered_json(nullptr);
  document["simulated_time"] = Rounded(plan.simulated_time, 3);
  document["seed"] = record.options.seed;
  document["engine"] = record.options.engine == RolloutEngine::kReference ? "reference" : "lanes";
  document["digest"] = HashText(plan.digest);
  document["timing_s"] = TimingJson(plan);
  document["rests_on"] = RestsOnJson(record);
  document["versions"] = VersionsJson();
  return JsonText(document);
}

}  // namespace dbd
