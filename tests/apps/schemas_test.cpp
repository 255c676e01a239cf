// The JSON Schema files that are shipped say what the program reads and writes.
#include <dbd/core/error.h>
#include <dbd/core/vehicle_database.h>
#include <dbd/terrain/material_map.h>

#include <functional>
#include <sstream>

#include "batch_request.h"
#include "support/program.h"
#include "support/schema.h"

namespace dbd {
namespace {

using nlohmann::json;

/// Calls `check` with every document that differs from `document` by one value: another type, a
/// number beyond all bounds, or nothing at all. Notes are free and left alone.
void ForEachDamage(const json& document,
                   const std::function<void(const json&, const std::string&)>& check) {
  const json wrong[] = {-1e300,  1e300,         "no such word", true,
                        nullptr, json::array(), json::object()};
  const json flat = document.flatten();
  for (const auto& [key, value] : flat.items()) {
    if (key.find("/notes") != std::string::npos) continue;
    const json::json_pointer at(key);
    for (const json& other : wrong) {
      if (other.type() == value.type() && !value.is_number()) continue;
      json damaged = document;
      damaged[at] = other;
      check(damaged, key + " = " + other.dump());
    }
    json damaged = document;
    if (damaged[at.parent_pointer()].is_object()) damaged[at.parent_pointer()].erase(at.back());
    check(damaged, "no " + key);
  }
}

bool Reads(const std::function<void()>& read) {
  try {
    read();
    return true;
  } catch (const InputError&) {
    return false;
  }
}

json FullRequest() {
  return {{"schema", "dbd.request/1"},
          {"id", "a"},
          {"priority", 3},
          {"dem", {"a.tif", "b.tif"}},
          {"band", 2},
          {"vehicle", "tomcar-tm27"},
          {"start", {1, 2}},
          {"goal", {3, 4, 90}},
          {"coords", "wgs84"},
          {"candidates", 8},
          {"rounds", 2},
          {"seed", 7},
          {"max_speed_kmh", 20},
          {"engine", "reference"},
          {"deadline_s", 2.5},
          {"draws", 4},
          {"min_success", 0.5},
          {"materials", "m.tif"},
          {"material_table", "uscs"},
          {"rasterise", true},
          {"dem_origin", {0, 0, 10}},
          {"unknown_space", "blocked"}};
}

TEST(RequestSchema, AcceptsWhatTheProgramReadsAndNothingElse) {
  const Schema schema("request");
  EXPECT_EQ(schema.Error(FullRequest()), "");
  int refused = 0;
  ForEachDamage(FullRequest(), [&](const json& request, const std::string& damage) {
    const bool read = Reads([&] { ParseBatchRequest(request.dump(), "line"); });
    EXPECT_EQ(schema.Accepts(request), read) << damage;
    refused += !read;
  });
  EXPECT_GT(refused, 100);
  for (const char* text : {R"({"dem": "a", "vehicle": "b", "start": [1, 2]})", "[]", "3",
                           R"({"dem": [], "vehicle": "b", "start": [1, 2], "goal": [3, 4]})",
                           R"({"dem": "a", "vehicle": "b", "start": [1], "goal": [3, 4]})",
                           R"({"dme": "a", "vehicle": "b", "start": [1, 2], "goal": [3, 4]})"}) {
    EXPECT_FALSE(schema.Accepts(json::parse(text))) << text;
  }
}

/// Every bound of the schema is one of the program's: just inside is read, just outside is not.
TEST(RequestSchema, HasTheBoundsOfTheProgram) {
  const Schema schema("request");
  const auto read = [](const std::string& key, double value) {
    json request = FullRequest();
    request[key] = value;
    return Reads([&] { ParseBatchRequest(request.dump(), "line"); });
  };
  int bounds = 0;
  for (const auto& [key, rule] : schema.json()["properties"].items()) {
    if (!rule.contains("minimum")) continue;
    const double least = rule["minimum"], most = rule["maximum"];
    const double step = rule["type"] == "integer" ? 1 : 1e-3 * (most - least);
    EXPECT_TRUE(read(key, least) && read(key, most)) << key;
    EXPECT_FALSE(read(key, least - step)) << key;
    EXPECT_FALSE(read(key, most + step)) << key;
    ++bounds;
  }
  EXPECT_GT(bounds, 15);
}

TEST(VehicleSchema, AcceptsTheVehiclesThatAreBuiltIn) {
  const Schema schema("vehicle");
  for (const std::string& name : BuiltInVehicleNames()) {
    EXPECT_EQ(schema.Error(json::parse(BuiltInVehicleText(name))), "") << name;
  }
}

TEST(VehicleSchema, RefusesOnlyWhatTheProgramRefuses) {
  const Schema schema("vehicle");
  int refused = 0;
  for (const char* name : {"tomcar-tm27", "truck-6x6"}) {
    const json vehicle = json::parse(BuiltInVehicleText(name));
    ForEachDamage(vehicle, [&](const json& damaged, const std::string& damage) {
      if (schema.Accepts(damaged)) return;
      ++refused;
      EXPECT_FALSE(Reads([&] { ParseVehicle(damaged.dump(), "file"); })) << name << damage;
    });
  }
  EXPECT_GT(refused, 2000);
}

TEST(VehicleSchema, RefusesMisspeltKeysAtEveryLevel) {
  const Schema schema("vehicle");
  const json vehicle = json::parse(BuiltInVehicleText("tomcar-tm27"));
  for (const char* level :
       {"", "/chassis", "/outline", "/limits", "/axles/0", "/axles/0/wheel", "/axles/0/tire",
        "/axles/0/suspension", "/axles/0/suspension/spring", "/powertrain"}) {
    json damaged = vehicle;
    damaged[json::json_pointer(level)]["colour"] = 1;
    EXPECT_FALSE(schema.Accepts(damaged)) << level;
  }
}

TEST(MaterialsSchema, AcceptsWhatTheProgramReadsAndNothingElse) {
  const Schema schema("materials");
  const TemporaryDirectory directory;
  const auto reads = [&](const json& table) {
    const std::string file = directory.Write("table.json", table.dump());
    return Reads([&] { MaterialTable::Load(file); });
  };
  const json table = json::parse(R"({"schema": "dbd.materials/1", "name": "a", "materials": [
      {"code": 1, "name": "b", "cone_index_kpa": 900, "friction_limit": 0.8, "passable": true,
       "cone_index_spread": 0.2, "traction_model": "wismer_luth", "source": "d"},
      {"code": 2, "name": "c", "traction_model": "bekker", "plate": {"n": 1, "kc_kn": 1,
       "kphi_kn": 100, "cohesion_kpa": 1, "friction_angle_deg": 30, "shear_deformation": 0.02}}]})");
  EXPECT_EQ(schema.Error(table), "");
  EXPECT_TRUE(reads(table));
  int refused = 0;
  ForEachDamage(table, [&](const json& damaged, const std::string& damage) {
    EXPECT_EQ(schema.Accepts(damaged), reads(damaged)) << damage;
    refused += !schema.Accepts(damaged);
  });
  EXPECT_GT(refused, 50);
}

class SchemasOfOutput : public Program {
 protected:
  ~SchemasOfOutput() override { std::filesystem::remove_all(Scratch("out")); }

  /// What removes a key or adds one must be seen.
  static void ExpectDescribed(const Schema& schema, const json& document) {
    EXPECT_EQ(schema.Error(document), "");
    for (const auto& [key, value] : document.items()) {
      json damaged = document;
      damaged[key] = json::array({json::object()});
      EXPECT_FALSE(schema.Accepts(damaged)) << key;
    }
    json damaged = document;
    damaged["colour"] = "red";
    EXPECT_FALSE(schema.Accepts(damaged));
    damaged = document;
    damaged.erase("status");
    damaged.erase("pairs");
    EXPECT_FALSE(schema.Accepts(damaged));
  }
};

TEST_F(SchemasOfOutput, PlanWithRouteAndPlanWithout) {
  const Schema schema("plan");
  const std::string plan = PlanCommand(Land("dem.tif"), kVehicle);
  const json route =
      json::parse(RunDbd(plan + kEnds + "--draws 3 --materials " + Land("materials.tif") +
                         " --material-table " + Land("materials.json") + " --json")
                      .output);
  EXPECT_EQ(route["status"], "route");
  ExpectDescribed(schema, route);

  RunDbd("terrain generate --seed 5 --size 120 --walled-goal --out " + Scratch("given_wall"));
  const json no_go = json::parse(
      RunDbd("plan --candidates 4 --json --dem " + Scratch("given_wall/dem.tif") + " " + kVehicle +
             "--start 500015,5200015 --goal 500060,5200060 --out " + Scratch("out"))
          .output);
  EXPECT_EQ(no_go["status"], "no_go");
  ExpectDescribed(schema, no_go);
}

TEST_F(SchemasOfOutput, BatchResultsAndMatrix) {
  const json request = {{"dem", Land("dem.tif")},
                        {"vehicle", "tomcar-tm27"},
                        {"start", {500030, 5200030}},
                        {"goal", {500060, 5200030}},
                        {"candidates", 4}};
  std::ofstream(Scratch("given.jsonl")) << request << "\nno JSON\n";
  RunDbd("batch " + Scratch("given.jsonl") + " --out " + Scratch("given_results.jsonl"));
  const Schema schema("result");
  std::istringstream lines(ReadWhole(Scratch("given_results.jsonl")));
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    ExpectDescribed(schema, json::parse(line));
  }
  EXPECT_EQ(count, 2);

  const Ending matrix =
      RunDbd("matrix --dem " + Land("dem.tif") + " " + kVehicle + kEnds +
             "--goal 1,2 --candidates 4 --draws 2 --json --out " + Scratch("out"));
  ExpectDescribed(Schema("matrix"), json::parse(matrix.output));
}

}  // namespace
}  // namespace dbd
