// dbd batch as a process: every line is answered once, whatever happens.
#include <nlohmann/json.hpp>

#include <set>
#include <sstream>

#include "support/program.h"

namespace dbd {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class Batch : public Program {
 protected:
  ~Batch() override {
    for (const char* name : {"requests.jsonl", "all.jsonl", "part1.jsonl", "part2.jsonl"}) {
      std::filesystem::remove(Scratch(name));
    }
    std::filesystem::remove_all(Scratch("out"));
  }

  static std::string Request(const std::string& id, int goal_x) {
    return json{{"id", id},
                {"dem", Land("dem.tif")},
                {"vehicle", "tomcar-tm27"},
                {"start", {500030, 5200030}},
                {"goal", {goal_x, 5200030}},
                {"candidates", 4}}
        .dump();
  }

  static void WriteRequests(const std::vector<std::string>& lines) {
    std::ofstream file(Scratch("requests.jsonl"));
    for (const std::string& line : lines) file << line << "\n";
  }

  static Ending RunBatch(const std::string& out, const std::string& flags = "") {
    return RunDbd("batch " + Scratch("requests.jsonl") + " --out " + Scratch(out) + " " + flags);
  }

  /// The lines of a result file, in the order of their requests.
  static std::set<std::string> Results(const std::string& name) {
    std::istringstream stream(ReadWhole(Scratch(name)));
    std::set<std::string> lines;
    for (std::string line; std::getline(stream, line);) EXPECT_TRUE(lines.insert(line).second);
    return lines;
  }

  static json ResultOf(const std::string& name, int number) {
    for (const std::string& line : Results(name)) {
      if (json::parse(line)["line"] == number) return json::parse(line);
    }
    ADD_FAILURE() << "no result of line " << number;
    return {};
  }
};

TEST_F(Batch, AnswersAsPlanDoesAndABadLineHarmsNobody) {
  WriteRequests({Request("a", 500060), "{\"id\": \"b\", \"dme\": 1}", "", "no JSON",
                 std::string(100000, '['), Request("c", 500070)});
  const Ending run = RunBatch("all.jsonl");
  EXPECT_EQ(run.exit_code, 2) << run.errors;
  EXPECT_THAT(run.output, HasSubstr("5 requests answered, 3 error, 2 route"));
  EXPECT_EQ(Results("all.jsonl").size(), 5U);

  const Ending plan =
      RunDbd(PlanCommand(Land("dem.tif"), std::string(kVehicle) + kEnds + "--json"));
  const json alone = json::parse(plan.output), answer = ResultOf("all.jsonl", 1);
  EXPECT_EQ(answer["id"], "a");
  EXPECT_EQ(answer["digest"], alone["digest"]);
  EXPECT_EQ(answer["route"]["time"], alone["route"]["time"]);
  EXPECT_EQ(ResultOf("all.jsonl", 2)["id"], "b");
  EXPECT_THAT(ResultOf("all.jsonl", 2)["reason"].get<std::string>(),
              HasSubstr("line 2: dem: is missing"));
  EXPECT_THAT(ResultOf("all.jsonl", 4)["reason"].get<std::string>(), HasSubstr("not valid JSON"));
  EXPECT_THAT(ResultOf("all.jsonl", 5)["reason"].get<std::string>(), HasSubstr("nested deeper"));
  EXPECT_EQ(ResultOf("all.jsonl", 6)["status"], "route");
}

TEST_F(Batch, ResumesAfterACrashInTheMiddleOfALine) {
  WriteRequests({Request("a", 500060), "no JSON", Request("c", 500070), Request("d", 500050)});
  EXPECT_EQ(RunBatch("all.jsonl").exit_code, 2);
  const std::set<std::string> undisturbed = Results("all.jsonl");
  const std::string text = ReadWhole(Scratch("all.jsonl"));
  const std::size_t second_line = text.find('\n') + 1;
  std::ofstream(Scratch("all.jsonl")) << text.substr(0, text.find('\n', second_line) - 3);

  const Ending refused = RunBatch("all.jsonl");
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.errors, HasSubstr("exists; --resume goes on with it"));
  const Ending resumed = RunBatch("all.jsonl", "--resume");
  EXPECT_THAT(resumed.output, HasSubstr("1 had been answered before"));
  EXPECT_EQ(Results("all.jsonl"), undisturbed);

  WriteRequests({Request("other", 500060)});
  EXPECT_THAT(RunBatch("all.jsonl", "--resume").errors, HasSubstr("its result is of"));
  EXPECT_EQ(Results("all.jsonl"), undisturbed);
}

TEST_F(Batch, ShardsJoinToTheWhole) {
  WriteRequests({Request("a", 500060), Request("b", 500050), "no JSON"});
  EXPECT_EQ(RunBatch("all.jsonl").exit_code, 2);
  EXPECT_EQ(RunBatch("part1.jsonl", "--shard 1/2").exit_code, 2);
  EXPECT_EQ(RunBatch("part2.jsonl", "--shard 2/2").exit_code, 0);
  const std::set<std::string> whole = Results("all.jsonl");
  std::filesystem::remove(Scratch("all.jsonl"));
  const Ending merge = RunDbd("batch --merge " + Scratch("part1.jsonl") + " " +
                              Scratch("part2.jsonl") + " --out " + Scratch("all.jsonl"));
  EXPECT_EQ(merge.exit_code, 0) << merge.errors;
  EXPECT_EQ(Results("all.jsonl"), whole);
}

TEST_F(Batch, RefusesWrongUse) {
  WriteRequests({});
  for (const char* shard : {"0/2", "3/2", "1", "-1/2", "1/2x"}) {
    EXPECT_THAT(RunBatch("all.jsonl", std::string("--shard ") + shard).errors,
                HasSubstr("is not I/N"));
  }
  EXPECT_THAT(RunDbd("batch /nonexistent --out " + Scratch("all.jsonl")).errors,
              HasSubstr("/nonexistent: cannot be opened"));
  EXPECT_FALSE(std::filesystem::exists(Scratch("all.jsonl")));
}

}  // namespace
}  // namespace dbd
