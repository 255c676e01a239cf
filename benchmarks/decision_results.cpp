#include "decision_results.h"

#include <dbd/core/error.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace dbd {
namespace {

using nlohmann::json;

/// JSON has no infinity: a route without a score has none.
json ToJson(const Judged& judged) {
  json object{{"time", judged.time}, {"reached", judged.reached}, {"holds", judged.holds}};
  if (judged.index) object["index"] = *judged.index;
  if (judged.reached) object["score"] = judged.score;
  return object;
}

Judged JudgedFrom(const json& object) {
  Judged judged;
  judged.time = object.at("time");
  judged.reached = object.at("reached");
  judged.holds = object.at("holds");
  if (object.contains("index")) judged.index = object.at("index").get<std::size_t>();
  if (judged.reached) judged.score = object.at("score");
  return judged;
}

constexpr std::pair<const char*, Judged QueryResult::*> kRoutes[] = {
    {"chosen", &QueryResult::chosen},
    {"trusting", &QueryResult::trusting},
    {"shortest", &QueryResult::shortest},
    {"cheapest", &QueryResult::cheapest},
    {"best", &QueryResult::best}};

json ToJson(int number, const QueryResult& result) {
  json object{{"number", number},
              {"site", result.site},
              {"distance", result.distance},
              {"start", {result.start.x(), result.start.y()}},
              {"goal", {result.goal.x(), result.goal.y()}},
              {"plan_time", result.plan_time},
              {"kinematic_time", result.kinematic_time}};
  if (result.first_route_time) object["first_route_time"] = *result.first_route_time;
  for (const auto& [name, route] : kRoutes) object[name] = ToJson(result.*route);
  return object;
}

Eigen::Vector2d PlaceFrom(const json& pair) {
  return {pair.at(0).get<double>(), pair.at(1).get<double>()};
}

QueryResult ResultFrom(const json& object) {
  QueryResult result;
  result.site = object.at("site");
  result.distance = object.at("distance");
  result.start = PlaceFrom(object.at("start"));
  result.goal = PlaceFrom(object.at("goal"));
  result.plan_time = object.at("plan_time");
  result.kinematic_time = object.at("kinematic_time");
  if (object.contains("first_route_time"))
    result.first_route_time = object.at("first_route_time").get<double>();
  for (const auto& [name, route] : kRoutes) result.*route = JudgedFrom(object.at(name));
  return result;
}

}  // namespace

DecisionResults::DecisionResults(std::string file, std::string settings)
    : file_(std::move(file)), settings_(std::move(settings)) {
  std::ifstream stream(file_);
  std::string line;
  for (int i = 1; std::getline(stream, line); ++i) {
    try {
      const json object = json::parse(line);
      if (object.at("settings") != settings_) {
        throw InputError(file_ + ":" + std::to_string(i) +
                         ": asked with other settings: " + object.at("settings").dump());
      }
      results_[object.at("number")] = ResultFrom(object);
    } catch (const json::exception& error) {
      throw InputError(file_ + ":" + std::to_string(i) + ": no result of a query: " + error.what());
    }
  }
}

void DecisionResults::Add(int number, const QueryResult& result) {
  results_[number] = result;
  if (file_.empty()) return;
  std::ofstream stream(file_, std::ios::app);
  json object = ToJson(number, result);
  object["settings"] = settings_;
  stream << object.dump() << std::endl;
  if (!stream) throw InputError(file_ + ": cannot be written");
}

std::vector<QueryResult> DecisionResults::All() const {
  std::vector<QueryResult> all;
  for (const auto& [number, result] : results_) all.push_back(result);
  return all;
}

}  // namespace dbd
