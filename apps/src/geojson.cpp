#include "geojson.h"

#include <nlohmann/json.hpp>

#include "json_parts.h"

namespace dbd {
namespace {

using nlohmann::ordered_json;

ordered_json Feature(ordered_json geometry, ordered_json properties) {
  return {{"type", "Feature"},
          {"geometry", std::move(geometry)},
          {"properties", std::move(properties)}};
}

ordered_json Collection(const std::string& name, ordered_json features) {
  return {{"type", "FeatureCollection"}, {"name", name}, {"features", std::move(features)}};
}

ordered_json PointGeometry(const LocalFrame& frame, const Eigen::Vector3d& local) {
  ordered_json position = LonLatJson(frame, local.head<2>());
  position.push_back(Rounded(local.z(), 3));
  return {{"type", "Point"}, {"coordinates", std::move(position)}};
}

/// A line needs two positions; a drive that never moved is a point.
ordered_json TraceGeometry(const LocalFrame& frame, const Rollout& rollout) {
  if (rollout.trace.size() < 2) return PointGeometry(frame, rollout.place);
  ordered_json positions = ordered_json::array();
  for (const TraceSample& sample : rollout.trace) {
    ordered_json position = LonLatJson(frame, {sample.x, sample.y});
    position.push_back(Rounded(sample.ground_z, 3));
    positions.push_back(std::move(position));
  }
  return {{"type", "LineString"}, {"coordinates", std::move(positions)}};
}

ordered_json PathGeometry(const LocalFrame& frame, const Path& path) {
  ordered_json positions = ordered_json::array();
  for (const Eigen::Vector2d& point : path.points()) positions.push_back(LonLatJson(frame, point));
  return {{"type", "LineString"}, {"coordinates", std::move(positions)}};
}

ordered_json RouteProperties(const NamedRoute& route) {
  const Rollout& rollout = *route.rollout;
  ordered_json properties = {{"name", route.name}};
  for (const auto& [label, text] : route.labels) properties[label] = text;
  properties.update({{"outcome", OutcomeName(rollout.outcome)},
                     {"length_m", Rounded(rollout.distance, 2)},
                     {"time_s", Rounded(rollout.time, 2)},
                     {"energy_j", Rounded(rollout.energy, 0)}});
  properties["times_s"] = ordered_json::array();
  for (const TraceSample& sample : rollout.trace) {
    properties["times_s"].push_back(Rounded(sample.t, 3));
  }
  for (const LimitMargin& margin : rollout.margins) {
    properties[margin.name + "_margin"] = Rounded(margin.margin, 4);
  }
  return properties;
}

ordered_json CandidateProperties(const Plan& plan, std::size_t i) {
  const Rollout& rollout = plan.rollouts[i];
  const Score& score = plan.scores[i];
  return {{"id", i},
          {"origin", plan.candidates[i].origin},
          {"outcome", OutcomeName(rollout.outcome)},
          {"reason", rollout.reason},
          {"chosen", plan.chosen && static_cast<std::size_t>(*plan.chosen) == i},
          {"score", score.feasible ? ordered_json(Rounded(score.total, 3)) : ordered_json(nullptr)},
          {"length_m", Rounded(plan.candidates[i].path.length(), 2)},
          {"reverse_m", Rounded(plan.candidates[i].path.reverse_length(), 2)},
          {"driven_m", Rounded(rollout.distance, 2)},
          {"time_s", Rounded(rollout.time, 2)}};
}

}  // namespace

std::string RoutesGeoJson(const std::vector<NamedRoute>& routes, const std::string& name,
                          const LocalFrame& frame) {
  ordered_json features = ordered_json::array();
  for (const NamedRoute& route : routes) {
    features.push_back(Feature(TraceGeometry(frame, *route.rollout), RouteProperties(route)));
  }
  return JsonText(Collection(name, std::move(features)));
}

std::string RouteGeoJson(const Rollout& rollout, const std::string& name, const LocalFrame& frame) {
  return RoutesGeoJson({{name, {}, &rollout}}, name, frame);
}

std::string CandidatesGeoJson(const Plan& plan, const LocalFrame& frame) {
  ordered_json features = ordered_json::array();
  for (std::size_t i = 0; i < plan.rollouts.size(); ++i) {
    features.push_back(
        Feature(PathGeometry(frame, plan.candidates[i].path), CandidateProperties(plan, i)));
    if (plan.rollouts[i].outcome != Outcome::kReached) {
      features.push_back(
          Feature(PointGeometry(frame, plan.rollouts[i].place), CandidateProperties(plan, i)));
    }
  }
  return JsonText(Collection("candidates", std::move(features)));
}

}  // namespace dbd
