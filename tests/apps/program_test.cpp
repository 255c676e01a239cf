// The built program as a process: what it prints, how it ends and what it leaves behind.
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "support/program.h"

namespace dbd {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

TEST_F(Program, RefusesAFileThatIsMissing) {
  ExpectRefusal(PlanCommand("/nonexistent.tif", std::string(kVehicle) + kEnds), "/nonexistent.tif");
}

TEST_F(Program, RefusesWgs84WithoutACoordinateSystem) {
  const std::string dem = Scratch("given.asc");
  std::ofstream(dem) << "ncols 3\nnrows 3\nxllcorner 0\nyllcorner 0\ncellsize 10\n"
                        "1 1 1\n1 1 1\n1 1 1\n";
  ExpectRefusal(
      PlanCommand(dem, std::string(kVehicle) + "--start 15,45 --goal 15,46 --coords wgs84"),
      "no coordinate system");
}

TEST_F(Program, RefusesAStartOutsideTheMap) {
  ExpectRefusal(
      PlanCommand(Land("dem.tif"), std::string(kVehicle) + "--start 1,2 --goal 500060,5200030"),
      "--start 1,2: outside the map, which covers x 500000");
}

TEST_F(Program, RefusesAStartOnUnknownGround) {
  const std::string dem = Scratch("given.asc");
  std::ofstream(dem) << "ncols 4\nnrows 3\nxllcorner 0\nyllcorner 0\ncellsize 10\n"
                        "NODATA_value -9999\n"
                        "-9999 -9999 1 1\n-9999 -9999 1 1\n1 1 1 1\n";
  ExpectRefusal(PlanCommand(dem, std::string(kVehicle) + "--start 10,20 --goal 30,20"),
                "--start 10,20: the ground there is unknown");
}

TEST_F(Program, RefusesAnUnknownVehicle) {
  ExpectRefusal(PlanCommand(Land("dem.tif"), std::string("--vehicle moped ") + kEnds), "moped");
}

TEST_F(Program, RefusesAVehicleFileWithAWrongKey) {
  const std::string file = ChangedVehicle([](auto& vehicle) { vehicle["colour"] = "red"; });
  ExpectRefusal(PlanCommand(Land("dem.tif"), "--vehicle " + file + " " + kEnds), "colour");
}

TEST_F(Program, RefusesANegativeMass) {
  const std::string file = ChangedVehicle([](auto& vehicle) {
    for (auto& [key, value] : vehicle.items()) {
      if (value.is_object() && value.contains("mass")) value["mass"] = -1;
    }
  });
  ExpectRefusal(PlanCommand(Land("dem.tif"), "--vehicle " + file + " " + kEnds), "mass");
}

TEST_F(Program, RefusesAnEmptyPath) {
  const std::string path = Scratch("given.geojson");
  std::ofstream(path) << R"({"type": "FeatureCollection", "features": []})";
  ExpectRefusal("simulate --dem " + Land("dem.tif") + " " + kVehicle + "--path " + path +
                    " --out " + Scratch("out"),
                "given.geojson");
}

TEST_F(Program, RefusesPlotsWithoutGnuplot) {
  const std::string path = std::getenv("PATH");
  setenv("PATH", "/nonexistent", 1);
  ExpectRefusal("scenario A --plots " + Scratch("plots") + " --out " + Scratch("out.csv"),
                "--plots: needs the program gnuplot");
  setenv("PATH", path.c_str(), 1);
}

TEST_F(Program, RefusesACorruptGeoTiff) {
  const std::string dem = Scratch("given.tif");
  std::ofstream(dem, std::ios::binary) << ReadWhole(Land("dem.tif")).substr(0, 300);
  ExpectRefusal(PlanCommand(dem, std::string(kVehicle) + kEnds), "given.tif");
}

TEST_F(Program, RefusesAnOutputThatCannotBeWritten) {
  std::ofstream(Scratch("given")) << "a file";
  ExpectRefusal(
      "plan --dem " + Land("dem.tif") + " " + kVehicle + kEnds + " --out " + Scratch("given/out"),
      "--out " + Scratch("given/out"));
}

TEST_F(Program, RefusesWrongUsage) {
  ExpectRefusal("", "subcommand");
  ExpectRefusal("plan --dem x.tif", "required");
  ExpectRefusal("fly", "see dbd --help");
  ExpectRefusal(PlanCommand(Land("dem.tif"), std::string(kVehicle) + kEnds + "--candidates 0"),
                "--candidates");
  ExpectRefusal(PlanCommand(Land("dem.tif"), std::string(kVehicle) + "--start 12,abc --goal 1,2"),
                "--start: '12,abc' is not X,Y or X,Y,HEADING_DEG");
}

TEST_F(Program, ShowsTheTrailerThatRoadTrainsUse) {
  EXPECT_EQ(nlohmann::json::parse(RunDbd("vehicle show farm-trailer").output)["schema"],
            "dbd.trailer/1");
}

TEST_F(Program, RefusesWrongUseOfScenes) {
  ExpectRefusal("scenario", "A, B, C, D or a scene");
  ExpectRefusal("scenario convoy --vehicles 0", "--vehicles: Value 0 not in range 1 to 2000");
  ExpectRefusal("scenario convoy --compare x.csv", "--compare");
  ExpectRefusal("scenario A convoy", "name: has no meaning before a scene's name");
  ExpectRefusal("scenario road-train --trailer boat", "trailer \"boat\" is not known");
  ExpectRefusal("scenario convoy --terrain /nonexistent.csv", "/nonexistent.csv");
}

TEST_F(Program, SceneIsTheSameForAnyNumberOfThreads) {
  const auto drive = [](const std::string& threads) {
    const std::string file = Scratch("given" + threads + ".csv");
    const Ending run =
        RunDbd("scenario convoy --vehicles 4 --threads " + threads + " --out " + file);
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    EXPECT_THAT(run.output, HasSubstr("Scene convoy with 4 x tomcar-tm27"));
    return ReadWhole(file);
  };
  const std::string alone = drive("1");
  EXPECT_THAT(alone, testing::StartsWith("t,vehicle,x,y,z,yaw,"));
  EXPECT_GT(alone.size(), 10000u);
  EXPECT_EQ(alone, drive("2"));
}

TEST_F(Program, HelpOfEverySubCommandEndsWithAnExample) {
  for (const char* command : {"plan", "batch", "matrix", "simulate", "scenario", "scenario convoy",
                              "scenario road-train", "terrain", "terrain generate", "terrain info",
                              "vehicle", "vehicle list", "vehicle show", "vehicle check"}) {
    const Ending run = RunDbd(std::string(command) + " --help");
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_THAT(run.output, HasSubstr("Example:\n  dbd ")) << command;
    EXPECT_EQ(run.errors, "");
  }
  EXPECT_THAT(RunDbd("--version").output, testing::MatchesRegex("dbd [0-9.]+\n"));
}

TEST_F(Program, PlansAndWritesTheAnswerInOneGo) {
  const std::string ends = "--start 500030,5200030,90 --goal 500060,5200030 ";
  const Ending run = RunDbd("plan --dem " + Land("dem.tif") + " " + kVehicle + ends +
                            "--candidates 4 --json --out " + Scratch("given_plan"));
  ASSERT_TRUE(run.exit_code == 0 || run.exit_code == 3) << run.errors;
  EXPECT_EQ(run.errors, "");
  const nlohmann::json plan = nlohmann::json::parse(run.output);
  EXPECT_EQ(plan["schema"], "dbd.plan/1");
  EXPECT_EQ(plan["status"], run.exit_code == 0 ? "route" : "no_go");
  EXPECT_EQ(run.output, ReadWhole(Scratch("given_plan/plan.json")));
  EXPECT_EQ(fs::exists(Scratch("given_plan/route.gpx")), run.exit_code == 0);
}

TEST_F(Program, ADeadlineThatIsTooShortEndsWithCodeFourAndNoFiles) {
  const Ending run =
      RunDbd(PlanCommand(Land("dem.tif"), std::string(kVehicle) + kEnds) + "--deadline 0.001");
  EXPECT_EQ(run.exit_code, 4);
  EXPECT_EQ(run.errors, "dbd: the deadline passed before a candidate reached the goal\n");
  EXPECT_FALSE(fs::exists(Scratch("out")));
  ExpectRefusal(PlanCommand(Land("dem.tif"), kVehicle) + kEnds + "--deadline -1", "--deadline");
}

TEST_F(Program, DrivesStraightAheadAndAlongItsOwnRoute) {
  const std::string common = "simulate --dem " + Land("dem.tif") + " " + kVehicle;
  const Ending ahead =
      RunDbd(common + "--start 500030,5200030,90 --speed-kmh 10 --duration-s 3 --out " +
             Scratch("given_drive"));
  ASSERT_EQ(ahead.exit_code, 0) << ahead.errors << ahead.output;
  EXPECT_THAT(ahead.output, HasSubstr("Drove straight ahead"));
  const Ending again = RunDbd(common + "--path " + Scratch("given_drive/route.gpx") +
                              " --speed-kmh 10 --out " + Scratch("given_again"));
  EXPECT_TRUE(again.exit_code == 0 || again.exit_code == 3) << again.errors;
  EXPECT_EQ(nlohmann::json::parse(ReadWhole(Scratch("given_again/simulate.json")))["schema"],
            "dbd.simulation/1");
}

}  // namespace
}  // namespace dbd
