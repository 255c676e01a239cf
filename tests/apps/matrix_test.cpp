// dbd matrix as a process, and its table.
#include <nlohmann/json.hpp>

#include "matrix_table.h"
#include "support/program.h"

namespace dbd {
namespace {

using nlohmann::json;
using testing::HasSubstr;

TEST(MatrixAxes, PairsCountTheGoalsFirst) {
  const MatrixAxes axes{{"a", "b"}, {"dry"}, {{"s1", {}}, {"s2", {}}}, {{"g1", {}}, {"g2", {}}}};
  ASSERT_EQ(axes.size(), 8U);
  EXPECT_EQ(axes.Pair(1).goal, 1U);
  EXPECT_EQ(axes.Pair(1).start, 0U);
  EXPECT_EQ(axes.Pair(2).start, 1U);
  EXPECT_EQ(axes.Pair(6).vehicle, 1U);
  EXPECT_EQ(axes.Pair(6).start, 1U);
}

TEST(MatrixCsv, QuotesWhatNeedsIt) {
  const MatrixAxes axes{{"v"}, {""}, {{"a, \"b\"", {}}}, {{"g", {}}}};
  const std::vector<MatrixAnswer> answers(1);
  const LocalFrame frame("", Eigen::Vector2d::Zero());
  EXPECT_THAT(MatrixCsv({axes, answers, {}, frame}),
              HasSubstr("\nv,,\"a, \"\"b\"\"\",g,cancelled,,,,,,,stopped before"));
}

class MatrixProgram : public Program {
 protected:
  ~MatrixProgram() override { std::filesystem::remove_all(Scratch("out")); }

  static Ending RunMatrix(const std::string& rest) { return RunDbd(Command(rest)); }
  static std::string Command(const std::string& rest) {
    return "matrix --dem " + Land("dem.tif") + " --candidates 4 --out " + Scratch("out") + " " +
           rest;
  }
  static json Table() { return json::parse(ReadWhole(Scratch("out/matrix.json"))); }
  static void Write(const std::string& name, const std::string& text) {
    std::ofstream(Scratch(name)) << text;
  }
};

TEST_F(MatrixProgram, AnswersAsPlanDoesAndABadPairHarmsNobody) {
  Write("given.csv", "name,x,y\nhut,500060,5200030\nfar,1,2\n");
  const Ending run =
      RunMatrix("--vehicle tomcar-tm27 --start 500030,5200030 --start 500060,5200030 --goals " +
                Scratch("given.csv") + " --routes");
  EXPECT_EQ(run.exit_code, 2) << run.errors;
  EXPECT_THAT(run.output, HasSubstr("4 pairs answered, 2 error, 1 route, 1 same_place"));
  const json pairs = Table()["pairs"];
  ASSERT_EQ(pairs.size(), 4U);
  EXPECT_EQ(pairs[0]["start"], "start1");
  EXPECT_EQ(pairs[0]["goal"], "hut");
  EXPECT_EQ(pairs[1]["status"], "error");
  EXPECT_THAT(pairs[1]["reason"].get<std::string>(), HasSubstr("goal far 1,2: outside the map"));
  EXPECT_EQ(pairs[2]["status"], "same_place");
  EXPECT_EQ(pairs[2]["route"]["time"], 0);

  std::filesystem::remove_all(Scratch("out"));
  const json alone = json::parse(
      RunDbd(PlanCommand(Land("dem.tif"), std::string(kVehicle) + kEnds + "--json")).output);
  EXPECT_EQ(pairs[0]["digest"], alone["digest"]);
  EXPECT_EQ(pairs[0]["status"], "route");
  EXPECT_EQ(pairs[0]["route"]["time"], alone["route"]["time"]);
}

TEST_F(MatrixProgram, SpansVehiclesAndSoilsAndWritesRoutesOnRequest) {
  json table = json::parse(ReadWhole(Land("materials.json")));
  for (json& material : table["materials"]) {
    material["cone_index_kpa"] = 0.5 * material["cone_index_kpa"].get<double>();
  }
  Write("given_wet.json", table.dump());
  const std::string rest = "--materials " + Land("materials.tif") +
                           " --soil dry=" + Land("materials.json") +
                           " wet=" + Scratch("given_wet.json") +
                           " --vehicle tomcar-tm27 utility-4x4 --start 500030,5200030 --goal "
                           "500060,5200030 --draws 3 --routes --threads ";
  EXPECT_EQ(RunMatrix(rest + "1").exit_code, 0);
  const std::string csv = ReadWhole(Scratch("out/matrix.csv"));
  const json pairs = Table()["pairs"];
  ASSERT_EQ(pairs.size(), 4U);
  EXPECT_EQ(pairs[1]["soil"], "wet");
  EXPECT_EQ(pairs[2]["vehicle"], "utility-4x4");
  EXPECT_NE(pairs[0]["digest"], pairs[1]["digest"]);
  EXPECT_THAT(csv, testing::StartsWith("vehicle,soil,start,goal,status,time_s,"));
  EXPECT_THAT(csv, HasSubstr("tomcar-tm27,dry,start1,goal1,route,"));
  EXPECT_EQ(pairs[0]["success"]["draws"], 3);
  const json routes = json::parse(ReadWhole(Scratch("out/routes.geojson")));
  EXPECT_EQ(
      routes["features"].size(),
      static_cast<std::size_t>(std::count_if(
          pairs.begin(), pairs.end(), [](const json& pair) { return !pair["route"].is_null(); })));
  EXPECT_EQ(routes["features"][0]["properties"]["soil"], "dry");

  EXPECT_EQ(RunMatrix(rest + "3").exit_code, 0);
  EXPECT_EQ(ReadWhole(Scratch("out/matrix.csv")), csv);
}

TEST_F(MatrixProgram, SoilsCanBeStatesOfOneTable) {
  const std::string ends = " --vehicle tomcar-tm27 --start 500030,5200030 --goal 500060,5200030";
  EXPECT_EQ(RunMatrix("--soil dry wet" + ends).exit_code, 0);
  const json pairs = Table()["pairs"];
  ASSERT_EQ(pairs.size(), 2U);
  EXPECT_EQ(pairs[0]["soil"], "dry");
  EXPECT_NE(pairs[0]["digest"], pairs[1]["digest"]);
  EXPECT_EQ(RunMatrix("--moisture wet" + ends).exit_code, 0);
  EXPECT_EQ(Table()["pairs"][0]["digest"], pairs[1]["digest"]);
}

TEST_F(MatrixProgram, RefusesWrongInput) {
  const std::string ends = "--start 500030,5200030 --goal 500060,5200030 ";
  const std::string good = std::string(kVehicle) + ends;
  ExpectRefusal(Command(kVehicle), "--starts or --start is required");
  ExpectRefusal(Command(std::string(kVehicle) + "--start 1,2"), "--goals or --goal is required");
  ExpectRefusal(Command(std::string(kVehicle) + "--start 1,abc --goal 1,2"),
                "--start: '1,abc' is not X,Y");
  ExpectRefusal(Command(ends), "--vehicle is required");
  ExpectRefusal(Command("--vehicle moped " + ends), "moped");
  ExpectRefusal(Command("--vehicle tomcar-tm27 tomcar-tm27 " + ends), "there twice");
  ExpectRefusal(Command(good + "--goals /nonexistent.csv"), "/nonexistent.csv: no such file");
  ExpectRefusal(Command(good + "--soil dry=uscs"), "--soil dry=uscs needs --materials");
  const std::string materials = "--materials " + Land("materials.tif") + " ";
  ExpectRefusal(Command(good + materials + "--soil uscs"),
                "'uscs' is neither dry, moist, wet nor NAME=TABLE");
  ExpectRefusal(Command(good + materials + "--soil a=uscs --material-table uscs"), "excludes");
  ExpectRefusal(Command(good + materials + "--soil a=basic a=basic"), "there twice");
  ExpectRefusal(Command(good + "--soil dry wet --moisture wet"), "excludes");
  Write("given.csv", "name,x,y\na,500060,5200030\na,500050,5200030\n");
  ExpectRefusal(Command(good + "--goals " + Scratch("given.csv")), "'a' is there twice");
  Write("given.asc",
        "ncols 3\nnrows 3\nxllcorner 0\nyllcorner 0\ncellsize 10\n1 1 1\n1 1 1\n1 1 1\n");
  ExpectRefusal("matrix --dem " + Scratch("given.asc") + " --out " + Scratch("out") +
                    " --vehicle tomcar-tm27 --start 5,5 --goal 25,25 --routes",
                "no coordinate system");
  Write("given.csv", "lon,lat\n15,46\n");
  ExpectRefusal("matrix --dem " + Scratch("given.asc") + " --out " + Scratch("out") +
                    " --vehicle tomcar-tm27 --start 5,5 --goals " + Scratch("given.csv"),
                "no coordinate system");
}

TEST_F(MatrixProgram, ADeadlineCountsForEachPair) {
  const Ending run = RunMatrix(std::string(kVehicle) + kEnds + "--deadline 0.001");
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_EQ(Table()["pairs"][0]["status"], "deadline");
}

}  // namespace
}  // namespace dbd
