#include "scenario_plots.h"

#include <dbd/core/error.h>
#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>

#include "support/temporary_directory.h"

namespace dbd {
namespace {

namespace fs = std::filesystem;

/// Six seconds at 250 Hz of a chassis that bounces at 2 Hz with 10 mm.
std::vector<TrajectoryRow> Bouncing() {
  std::vector<TrajectoryRow> rows;
  for (int i = 0; i < 1500; ++i) {
    TrajectoryRow row;
    row.t = 4e-3 * i;
    row.x_cg = 0.784 + row.t;
    row.z_cg = 0.475 + 0.01 * std::sin(2 * std::numbers::pi * 2 * row.t);
    row.pitch = 0.01;
    row.spring_force = {1, 2, 3, 4000};
    rows.push_back(row);
  }
  return rows;
}

std::vector<std::vector<double>> ReadTable(const std::string& file) {
  std::ifstream stream(file);
  std::vector<std::vector<double>> table;
  std::string line;
  std::getline(stream, line);
  while (std::getline(stream, line)) {
    std::istringstream cells(line);
    std::vector<double> row;
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(std::stod(cell));
    table.push_back(row);
  }
  return table;
}

class ScenarioPlotsTest : public testing::Test {
 protected:
  void SetUp() override {
    if (std::system("gnuplot --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "no gnuplot";
  }

  void Draw(const ScenarioPlots& plots) {
    OutputDirectory output(Path(""), "--plots", ScenarioPlotFiles());
    WriteScenarioPlots(plots, Gnuplot("--plots"), &output);
    output.Commit();
  }

  std::string Path(const std::string& file) const { return scratch_.File("plots/" + file); }

  static void ExpectPng(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    std::string begin(8, '\0');
    stream.read(begin.data(), 8);
    EXPECT_EQ(begin, "\x89PNG\r\n\x1a\n") << file;
    EXPECT_GT(fs::file_size(file), 5000u) << file;
  }

  TemporaryDirectory scratch_;
};

TEST_F(ScenarioPlotsTest, WritesPicturesScriptsAndData) {
  const std::vector<TrajectoryRow> rows = Bouncing();
  Draw({"Test", rows, std::vector<double>(rows.size(), 250.0), "a link", rows});
  for (const std::string& name : ScenarioPlotFiles()) EXPECT_TRUE(fs::exists(Path(name))) << name;
  for (const char* name : {"motion.png", "forces.png", "spectrum.png"}) ExpectPng(Path(name));
  const auto drive = ReadTable(Path("drive.csv"));
  ASSERT_EQ(drive.size(), 1500u);
  // t, x, z, pitch: 0.01 rad = 0.57296 deg, the rear right spring and the link in kN
  const std::vector<double> expected{0.5, 1.284, 0.475, 0.57296, 4.0, 0.25};
  EXPECT_THAT(drive[125], testing::Pointwise(testing::DoubleNear(1e-5), expected));
}

// A sine of 10 mm at 2 Hz accelerates with (4 pi)^2 0.01 = 1.579 m/s^2. 1000 samples from t = 2 s
// on, 998 second differences: 2 Hz lies between lines, next to the eighth (2.004 Hz).
TEST_F(ScenarioPlotsTest, SpectrumShowsTheBounce) {
  Draw({"Test", Bouncing(), {}, "", {}});
  const auto spectrum = ReadTable(Path("spectrum.csv"));
  ASSERT_EQ(spectrum.size(), 500u);
  EXPECT_NEAR(spectrum[8][0], 2.004, 1e-3);
  EXPECT_NEAR(spectrum[8][1], 1.579, 0.005);
  EXPECT_LT(spectrum[20][1], 0.01);
}

TEST_F(ScenarioPlotsTest, LeavesNoReferenceOfAnEarlierRun) {
  const std::vector<TrajectoryRow> rows = Bouncing();
  Draw({"Test", rows, {}, "", rows});
  EXPECT_TRUE(fs::exists(Path("reference-drive.csv")));
  Draw({"Test", rows, {}, "", {}});
  EXPECT_FALSE(fs::exists(Path("reference-drive.csv")));
}

TEST_F(ScenarioPlotsTest, RefusesAReferenceWithGaps) {
  std::vector<TrajectoryRow> gaps = Bouncing();
  gaps.erase(gaps.begin() + 700, gaps.begin() + 800);
  try {
    Draw({"Test", Bouncing(), {}, "", gaps});
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "--compare: rows must be evenly spaced in time for the spectrum");
  }
  EXPECT_FALSE(fs::exists(Path("")));
}

}  // namespace
}  // namespace dbd
