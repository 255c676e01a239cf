#include <dbd/core/trajectory.h>
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "support/core_vehicle.h"
#include "support/temporary_directory.h"

namespace dbd {
namespace {

using testing::HasSubstr;

/// Four seconds at 100 Hz of a given height, standing in all else.
template <class Height>
std::vector<TrajectoryRow> Rows(Height height, double step = 0.01) {
  std::vector<TrajectoryRow> rows;
  for (int i = 0; i * step < 4.0001; ++i) {
    TrajectoryRow row;
    row.t = i * step;
    row.z_cg = height(row.t);
    rows.push_back(row);
  }
  return rows;
}

double Wave(double t) { return std::sin(2 * std::numbers::pi * t); }

// From 2 s to 4 s two full waves. Ours is 10 % higher: the residual is 0.1 of the signal, so
// R2 = 1 - 0.1^2 = 0.99; rms = 0.1 / sqrt(2) of a range of 2; the peak is off by 10 %, with the
// offset by (8.1 - 1) / 1.
TEST(CompareTrajectories, OfAWaveThatIsTooHigh) {
  const auto agreement =
      CompareTrajectories(Rows([](double t) { return 1.1 * Wave(t) + 7; }), Rows(Wave));
  ASSERT_EQ(agreement.size(), 1u);  // what does not move is left out
  EXPECT_EQ(agreement[0].name, "z_cg");
  EXPECT_NEAR(agreement[0].r_squared, 0.99, 1e-9);
  EXPECT_NEAR(agreement[0].rms, 0.1 / std::sqrt(2) / 2, 2e-4);  // 201 samples, both ends
  EXPECT_NEAR(agreement[0].peak_error, 0.1, 1e-9);
  EXPECT_NEAR(agreement[0].peak_value_error, 7.1, 1e-9);
}

TEST(CompareTrajectories, InterpolatesInTime) {
  const auto agreement = CompareTrajectories(Rows([](double t) { return t * t; }, 0.02),
                                             Rows([](double t) { return t * t; }));
  // Half-way between rows 0.02 s apart a parabola lies 0.01^2 below its chord; the range is 12.
  EXPECT_NEAR(agreement[0].rms, 1e-4 / std::sqrt(2) / 12, 1e-7);
  EXPECT_NEAR(agreement[0].r_squared, 1, 1e-9);
}

TEST(CompareTrajectories, NeedsASecondInCommon) {
  std::vector<TrajectoryRow> brief = Rows(Wave);
  brief.resize(250);
  EXPECT_EQ(InputErrorOf([&] { CompareTrajectories(brief, Rows(Wave)); }),
            "trajectories have too little time in common");
}

class TrajectoryFile : public testing::Test {
 protected:
  TemporaryDirectory directory_;
};

TEST_F(TrajectoryFile, ComesBackAsItWasWritten) {
  std::vector<TrajectoryRow> rows = Rows(Wave);
  rows[7].pitch = -0.012345678;
  rows[7].spring_force = {1, -2, 3.5, 4e4};
  rows[7].tire_force = {5, 6, 7, 8};
  const std::string file = directory_.File("rows.csv");
  WriteTrajectory(file, rows);
  const auto read = ReadTrajectory(file);
  ASSERT_EQ(read.size(), rows.size());
  EXPECT_NEAR(read[33].z_cg, rows[33].z_cg, 1e-9);
  EXPECT_EQ(read[7].pitch, rows[7].pitch);
  EXPECT_EQ(read[7].spring_force, rows[7].spring_force);
  EXPECT_EQ(read[7].tire_force, rows[7].tire_force);
}

TEST_F(TrajectoryFile, BadRowsAreNamed) {
  const std::string row = "0,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18\n";
  const auto message = [this](const std::string& text) {
    const std::string file = directory_.Write("given.csv", text);
    return InputErrorOf([&file] { ReadTrajectory(file); });
  };
  EXPECT_THAT(message("header\n" + row + "1,2\n"), HasSubstr("given.csv, line 3: must have 19"));
  EXPECT_THAT(message("header\n" + row + "nan" + row.substr(1)), HasSubstr("line 3"));
  EXPECT_THAT(message("header\n" + row), HasSubstr("needs a header and at least two rows"));
  EXPECT_THAT(InputErrorOf([] { ReadTrajectory("/nonexistent.csv"); }),
              HasSubstr("/nonexistent.csv: trajectory cannot be opened"));
}

}  // namespace
}  // namespace dbd
