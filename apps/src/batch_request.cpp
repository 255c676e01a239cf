#include "batch_request.h"

#include <dbd/core/error.h>
#include <dbd/core/internal/json_object.h>
#include <dbd/core/units.h>

#include <algorithm>

#include "text.h"

namespace dbd {
namespace {

using internal::JsonObject;

constexpr char kSchema[] = "dbd.request/1";
constexpr double kFar = 1e9;  // no map has coordinates beyond

/// One of `words`.
std::string Choice(const JsonObject& line, const std::string& key, const std::string& otherwise,
                   const std::vector<std::string>& words) {
  const std::string word = line.Text(key, otherwise);
  if (std::find(words.begin(), words.end(), word) != words.end()) return word;
  std::string all;
  for (const std::string& known : words) all += (all.empty() ? "" : ", ") + known;
  line.Fail(key, "is \"" + word + "\", must be one of " + all);
}

/// Numbers as the flags take them: "x,y" or "x,y,turn".
std::string Placement(const JsonObject& line, const std::string& key) {
  if (!line.Has(key)) return "";
  const std::vector<double> numbers = line.Numbers(key);
  if (numbers.size() < 2 || numbers.size() > 3) line.Fail(key, "must be [x, y] or [x, y, yaw_deg]");
  std::string text = Format("%.17g,%.17g", numbers[0], numbers[1]);
  if (numbers.size() == 3) text += Format(",%.17g", numbers[2]);
  return text;
}

TypedPlace Place(const JsonObject& line, const std::string& key) {
  const std::vector<double> numbers = line.Numbers(key);
  if (numbers.size() < 2 || numbers.size() > 3) {
    line.Fail(key, "must be [x, y] or [x, y, heading_deg]");
  }
  TypedPlace place{{numbers[0], numbers[1]}, std::nullopt};
  if (place.xy.cwiseAbs().maxCoeff() > kFar) line.Fail(key, "is on no map");
  if (numbers.size() == 3) place.heading_deg = numbers[2];
  return place;
}

TerrainArguments ReadTerrain(const JsonObject& line) {
  TerrainArguments terrain;
  terrain.dem = line.TextOrTexts("dem");
  if (terrain.dem.empty()) line.Fail("dem", "must name a file");
  if (line.Has("band")) terrain.band = line.Integer("band", 1, 65535);
  terrain.crs = line.Text("crs", "");
  terrain.unknown_ground = Choice(line, "unknown_ground", "forbid", {"forbid", "fill"});
  terrain.fill_distance_m = line.Number("fill_distance_m", 0.01, 1e5, terrain.fill_distance_m);
  terrain.memory_gb = line.Number("memory_gb", 0.01, 1e4, terrain.memory_gb);
  terrain.dem_origin = Placement(line, "dem_origin");
  terrain.surface_cell_m = line.Number("surface_cell_m", 0, 1000, 0);
  terrain.rasterise = line.Flag("rasterise", false);
  terrain.materials = line.Text("materials", "");
  if (line.Has("materials_band")) terrain.materials_band = line.Integer("materials_band", 1, 65535);
  terrain.material_field = line.Text("material_field", "");
  terrain.unknown_material = line.Text("unknown_material", "");
  terrain.material_table = line.Text("material_table", "");
  if (line.Has("moisture")) {
    terrain.moisture = Choice(line, "moisture", "moist", {"dry", "moist", "wet"});
  }
  terrain.obstacles = line.Text("obstacles", "");
  terrain.obstacles_origin = Placement(line, "obstacles_origin");
  terrain.unknown_space = Choice(line, "unknown_space", "free", {"free", "blocked"});
  terrain.surface_model = line.Text("surface_model", "");
  terrain.surface_threshold_m =
      line.Number("surface_threshold_m", 0.01, 100, terrain.surface_threshold_m);
  return terrain;
}

void ReadUncertainty(const JsonObject& line, PlanArguments& plan) {
  if (line.Has("draws")) plan.draws = line.Integer("draws", 1, 10000);
  plan.min_success = line.Number("min_success", 0, 1, plan.min_success);
  plan.soil_spread = line.Number("soil_spread", 0, 10, plan.soil_spread);
  plan.elevation_error_m = line.Number("elevation_error_m", 0, 100, plan.elevation_error_m);
  plan.elevation_correlation_m =
      line.Number("elevation_correlation_m", 0.1, 1e5, plan.elevation_correlation_m);
}

PlanArguments ReadPlan(const JsonObject& line) {
  constexpr double kLargestSeed = 9007199254740992.0;  // that a JSON number holds exactly
  PlanArguments plan;
  plan.terrain = ReadTerrain(line);
  plan.vehicle = line.Text("vehicle");
  const std::string coordinates = Choice(line, "coords", "map", {"map", "wgs84"});
  plan.coordinates = coordinates == "wgs84" ? Coordinates::kWgs84 : Coordinates::kMap;
  if (line.Has("candidates")) plan.candidates = line.Integer("candidates", 1, 100000);
  plan.reversing = line.Flag("reversing", false);
  if (line.Has("rounds")) plan.rounds = line.Integer("rounds", 1, 100);
  plan.seed = static_cast<std::uint64_t>(line.Number("seed", 0, kLargestSeed, 1));
  plan.max_speed_kmh = line.Number("max_speed_kmh", 0.1, 500, plan.max_speed_kmh);
  plan.engine = Choice(line, "engine", "lanes", {"lanes", "reference"});
  if (line.Has("deadline_s")) plan.deadline_s = line.Number("deadline_s", 1e-3, 1e9);
  ReadUncertainty(line, plan);
  return plan;
}

}  // namespace

BatchRequest ParseBatchRequest(const std::string& line, const std::string& origin) {
  if (line.size() > kLongestRequest) {
    throw InputError(
        origin + Format(": has %zu bytes, must have at most %zu", line.size(), kLongestRequest));
  }
  const JsonObject object = JsonObject::ParseOptionalSchema(line, origin, kSchema);
  BatchRequest request;
  request.id = object.Text("id", "");
  request.plan = ReadPlan(object);
  request.start = Place(object, "start");
  request.goal = Place(object, "goal");
  if (object.Has("priority")) request.priority = object.Integer("priority", -1000, 1000);
  object.RefuseUnknownKeys();
  return request;
}

std::string FindRequestId(const std::string& line) {
  if (line.size() > kLongestRequest) return "";
  try {
    return JsonObject::ParseOptionalSchema(line, "", kSchema).Text("id", "");
  } catch (const InputError&) {
    return "";
  }
}

}  // namespace dbd
