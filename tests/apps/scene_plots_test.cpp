#include "scene_plots.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "support/temporary_directory.h"

namespace dbd {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

std::string Read(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Ten rows of two vehicles, the second 5 m behind and towed with `drawbar` N.
std::vector<SceneRow> Rows(double drawbar) {
  std::vector<SceneRow> rows;
  for (int i = 0; i < 10; ++i) {
    for (const int vehicle : {0, 1}) {
      SceneRow row;
      row.t = 0.1 * i;
      row.vehicle = vehicle;
      row.speed = i + 0.5 * vehicle;
      row.gap = 5.0 * vehicle;
      row.drawbar_force = drawbar * vehicle;
      rows.push_back(row);
    }
  }
  return rows;
}

class ScenePlotsTest : public testing::Test {
 protected:
  void SetUp() override {
    if (std::system("gnuplot --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "no gnuplot";
  }

  void Draw(const std::vector<SceneRow>& rows) {
    OutputDirectory output(Path(""), "--plots", ScenePlotFiles());
    WriteScenePlots("Two", rows, Gnuplot("--plots"), &output);
    output.Commit();
  }

  std::string Path(const std::string& file) const { return scratch_.File("plots/" + file); }

  TemporaryDirectory scratch_;
};

TEST_F(ScenePlotsTest, DrawsSpeedsAndGapsOfAConvoy) {
  Draw(Rows(0));
  for (const std::string& name : ScenePlotFiles()) EXPECT_TRUE(fs::exists(Path(name))) << name;
  // Third row of the data: t, then speed, gap and drawbar of both.
  EXPECT_THAT(Read(Path("scene.csv")),
              HasSubstr("\n0.200,2.0000,0.0000,0.0000,2.5000,5.0000,0.0000\n"));
  const std::string script = Read(Path("scene.gp"));
  EXPECT_THAT(script, HasSubstr("gap to the vehicle ahead"));
  EXPECT_THAT(script, HasSubstr("using 1:6"));  // the gap of the second vehicle
  EXPECT_THAT(script, Not(HasSubstr("drawbar")));
}

TEST_F(ScenePlotsTest, DrawsTheDrawbarsOfATrainInColoursOfTheirOwn) {
  Draw(Rows(2500));
  EXPECT_THAT(Read(Path("scene.csv")), HasSubstr("\n0.000,0.0000,0.0000,0.0000,0.5000,5.0000,2.5"));
  const std::string script = Read(Path("scene.gp"));
  EXPECT_THAT(script, HasSubstr("drawbar, tension [kN]"));
  EXPECT_THAT(script, HasSubstr("using 1:7 with lines linecolor '#e69f00'"));
  EXPECT_THAT(script, HasSubstr("using 1:2 with lines linecolor '#1d3557'"));
}

}  // namespace
}  // namespace dbd
