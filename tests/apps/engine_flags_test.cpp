// Flags that change how drives are computed: each has an effect, and wrong values are refused.
#include "support/program.h"

namespace dbd {
namespace {

using nlohmann::json;

class EngineFlags : public Program {
 protected:
  /// Last row of the trajectory of scenario B.
  static std::string EndOfScenario(const std::string& flags) {
    const std::string file = Scratch("given.csv");
    const Ending run = RunDbd("scenario B " + flags + " --out " + file);
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    const std::string text = ReadWhole(file);
    return text.substr(text.rfind('\n', text.size() - 2) + 1);
  }

  static std::string SimulateCommand(const std::string& flags) {
    return "simulate --dem " + Land("dem.tif") + " --materials " + Land("materials.tif") +
           " --material-table " + Land("materials.json") + " " + kVehicle +
           "--start 500030,5200030,90 --duration-s 5 --json --out " + Scratch("given_drive") + " " +
           flags;
  }

  /// Deepest rut of a short drive [m].
  static double Sinkage(const std::string& flags) {
    const Ending run = RunDbd(SimulateCommand(flags));
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    const json answer = json::parse(run.output);
    for (const json& limit : answer["certificate"]["margins"]) {
      if (limit["name"] == "sinkage") return limit["worst"];
    }
    ADD_FAILURE() << "no sinkage in " << run.output;
    return 0;
  }

  static json PlanWith(const std::string& flags) {
    const Ending run = RunDbd("plan --dem " + Land("dem.tif") + " --candidates 2 --json --out " +
                              Scratch("given_out") + " " + kVehicle + kEnds + flags);
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    return json::parse(run.output);
  }
};

TEST_F(EngineFlags, TireSchemeHoldsTheForceInsteadOfTheShape) {
  const std::string split = EndOfScenario("--tire-scheme split");
  EXPECT_EQ(EndOfScenario(""), split);
  const std::string hold = EndOfScenario("--tire-scheme hold");
  EXPECT_NE(hold, split);
  EXPECT_NEAR(std::stod(hold.substr(hold.find(',') + 1)),  // the same drive nevertheless
              std::stod(split.substr(split.find(',') + 1)), 0.01);
}

TEST_F(EngineFlags, MultipassExponentDeepensRuts) {
  const double fresh = Sinkage("");
  const double firm = Sinkage("--multipass-exponent 4");
  const double loose = Sinkage("--multipass-exponent 2");
  EXPECT_GT(fresh, 0);
  EXPECT_GT(firm, fresh);
  EXPECT_GT(loose, firm);
}

TEST_F(EngineFlags, WetSoilsLetWheelsSinkDeeper) {
  const double stated = Sinkage("");
  EXPECT_EQ(Sinkage("--moisture moist"), stated);
  EXPECT_GT(Sinkage("--moisture wet"), 1.5 * stated);
  EXPECT_LT(Sinkage("--moisture dry"), stated);
  const json plan = PlanWith("--moisture dry");
  EXPECT_EQ(plan["request"]["terrain"]["moisture"], "dry");
}

TEST_F(EngineFlags, EngineChoosesThePrecision) {
  const json lanes = PlanWith("--engine lanes");
  EXPECT_EQ(PlanWith("")["digest"], lanes["digest"]);
  const json reference = PlanWith("--engine reference");
  EXPECT_NE(reference["digest"], lanes["digest"]);
  const double time = lanes["candidates"][0]["time"];
  EXPECT_NEAR(reference["candidates"][0]["time"], time, 0.01 * time);
}

TEST_F(EngineFlags, WrongValuesAreRefused) {
  const std::string plan = PlanCommand(Land("dem.tif"), std::string(kVehicle) + kEnds);
  ExpectRefusal("scenario A --tire-scheme round", "--tire-scheme: round not in {split,hold}");
  ExpectRefusal("scenario A --tire-scheme hold --vertical-tire", "excludes --vertical-tire");
  ExpectRefusal(plan + "--moisture soaked", "--moisture: soaked not in {dry,moist,wet}");
  ExpectRefusal(plan + "--engine fast", "--engine: fast not in {lanes,reference}");
  for (const std::string wrong : {"0.9", "11", "deep", "nan", "-nan", "inf", "''"}) {
    ExpectRefusal(SimulateCommand("--multipass-exponent=" + wrong), "--multipass-exponent: ");
  }
}

TEST_F(EngineFlags, NumbersThatAreNoneAreRefusedEverywhere) {
  const std::string plan = PlanCommand(Land("dem.tif"), std::string(kVehicle) + kEnds);
  for (const std::string flag :
       {"--deadline", "--max-speed-kmh", "--memory-gb", "--draws 2 --min-success"}) {
    ExpectRefusal(plan + flag + " nan", ": 'nan' is not a number from ");
  }
  ExpectRefusal(SimulateCommand("--speed-kmh nan"), "--speed-kmh: 'nan' is not a number from 0.1");
}

}  // namespace
}  // namespace dbd
