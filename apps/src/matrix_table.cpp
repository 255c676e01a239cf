#include "matrix_table.h"

#include <dbd/planner/scoring.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "geojson.h"
#include "json_parts.h"
#include "text.h"

namespace dbd {
namespace {

using nlohmann::ordered_json;

using Labels = std::vector<std::pair<std::string, std::string>>;

/// What names a pair, in the order of the columns.
Labels LabelsOf(const MatrixAxes& axes, std::size_t index) {
  const MatrixPair pair = axes.Pair(index);
  return {{"vehicle", axes.vehicles[pair.vehicle]},
          {"soil", axes.soils[pair.soil]},
          {"start", axes.starts[pair.start].name},
          {"goal", axes.goals[pair.goal].name}};
}

/// Quoted where it must be (RFC 4180).
std::string CsvField(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char letter : text) quoted += letter == '"' ? "\"\"" : std::string(1, letter);
  return quoted + "\"";
}

ordered_json RouteTotals(const Rollout& rollout) {
  ordered_json route = {{"time", Rounded(rollout.time, 3)},
                        {"length", Rounded(rollout.distance, 3)},
                        {"energy", Rounded(rollout.energy, 1)}};
  if (const LimitMargin* tightest = TightestLimit(rollout)) {
    route["tightest"] = {tightest->name, Rounded(tightest->margin, 4)};
  }
  return route;
}

ordered_json AnswerJson(const MatrixRecord& record, std::size_t index) {
  const MatrixAnswer& answer = record.answers[index];
  ordered_json json = ordered_json::object();
  for (const auto& [name, text] : LabelsOf(record.axes, index)) json[name] = text;
  json["status"] = answer.status;
  json["reason"] = answer.reason;
  json["route"] = answer.route ? RouteTotals(*answer.route) : ordered_json(nullptr);
  if (answer.success) json["success"] = SuccessJson(*answer.success, record.frame);
  if (answer.digest) json["digest"] = HashText(*answer.digest);
  return json;
}

ordered_json PlacesJson(const std::vector<MatrixPlace>& places) {
  ordered_json list = ordered_json::array();
  for (const MatrixPlace& place : places) {
    ordered_json json = {{"name", place.name},
                         {place.coordinates == Coordinates::kMap ? "map" : "lon_lat",
                          {place.place.xy.x(), place.place.xy.y()}}};
    if (place.place.heading_deg) json["heading_deg"] = *place.place.heading_deg;
    list.push_back(std::move(json));
  }
  return list;
}

}  // namespace

MatrixPair MatrixAxes::Pair(std::size_t index) const {
  MatrixPair pair;
  pair.goal = index % goals.size();
  index /= goals.size();
  pair.start = index % starts.size();
  index /= starts.size();
  pair.soil = index % soils.size();
  pair.vehicle = index / soils.size();
  return pair;
}

std::string MatrixCsv(const MatrixRecord& record) {
  std::string csv =
      "vehicle,soil,start,goal,status,time_s,length_m,energy_j,p_go,p_go_low,p_go_high,reason,"
      "digest\n";
  for (std::size_t i = 0; i < record.answers.size(); ++i) {
    const MatrixAnswer& answer = record.answers[i];
    for (const auto& [name, text] : LabelsOf(record.axes, i)) csv += CsvField(text) + ",";
    csv += answer.status + ",";
    csv += answer.route ? Format("%.3f,%.3f,%.1f,", answer.route->time, answer.route->distance,
                                 answer.route->energy)
                        : ",,,";
    csv += answer.success ? Format("%.4f,%.4f,%.4f,", answer.success->p_go(), answer.success->low,
                                   answer.success->high)
                          : ",,,";
    csv += CsvField(answer.reason) + "," + (answer.digest ? HashText(*answer.digest) : "") + "\n";
  }
  return csv;
}

std::string MatrixJson(const MatrixRecord& record) {
  const MatrixAxes& axes = record.axes;
  ordered_json document = {{"schema", "dbd.matrix/1"},
                           {"map_crs", record.frame.CrsName()},
                           {"vehicles", axes.vehicles},
                           {"soils", axes.soils},
                           {"starts", PlacesJson(axes.starts)},
                           {"goals", PlacesJson(axes.goals)},
                           {"candidates", record.arguments.candidates},
                           {"draws", record.arguments.draws},
                           {"seed", record.arguments.seed}};
  document["pairs"] = ordered_json::array();
  for (std::size_t i = 0; i < record.answers.size(); ++i) {
    document["pairs"].push_back(AnswerJson(record, i));
  }
  document["versions"] = VersionsJson();
  return JsonText(document);
}

std::string MatrixRoutes(const MatrixRecord& record) {
  std::vector<NamedRoute> routes;
  for (std::size_t i = 0; i < record.answers.size(); ++i) {
    const MatrixAnswer& answer = record.answers[i];
    if (!answer.route || answer.route->trace.empty()) continue;
    const Labels labels = LabelsOf(record.axes, i);
    routes.push_back({labels[2].second + " - " + labels[3].second, labels, &answer.route.value()});
  }
  return RoutesGeoJson(routes, "matrix", record.frame);
}

}  // namespace dbd
