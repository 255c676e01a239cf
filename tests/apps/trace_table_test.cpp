#include "trace_table.h"

#include <gmock/gmock.h>

#include <sstream>

#include "apps/synthetic_plan.h"

namespace dbd {
namespace {

std::vector<std::string> Lines(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(TraceCsv, HasAHeaderWithUnitsAndOneRowPerSample) {
  const SyntheticPlan made = MakePlan("");
  const auto lines = Lines(TraceCsv(made.plan.rollouts[0].trace, made.terrain.frame()));
  ASSERT_EQ(lines.size(), 1 + made.plan.rollouts[0].trace.size());
  EXPECT_THAT(lines[0], testing::StartsWith(
                            "time_s,distance_m,x_m,y_m,z_m,ground_z_m,heading_deg,pitch_deg"));
  // Sample 4: s = 1 m, t = 1 / 5 s, x = 500000 + 20 + 1, ground 100 + 0.1 * 21, heading east.
  EXPECT_THAT(lines[5], testing::StartsWith(
                            "0.200,1.000,500021.000,5000050.000,102.900,102.100,90.00,-5.712"));
}

TEST(TraceCsv, HasLongitudeAndLatitudeWhereThereIsACoordinateSystem) {
  const SyntheticPlan made = MakePlan(kUtm33);
  const auto lines = Lines(TraceCsv(made.plan.rollouts[0].trace, made.terrain.frame()));
  EXPECT_THAT(lines[0], testing::HasSubstr(",longitude_deg,latitude_deg,"));
  EXPECT_THAT(lines[1], testing::HasSubstr(",15.0002"));  // just east of the zone's meridian
}

TEST(WorstPerMeter, KeepsTheWorstOfEachMeter) {
  std::vector<TraceSample> trace(4);
  trace[0].s = 0.0, trace[0].roll = 0.1, trace[0].clearance = 0.3, trace[0].speed = 2;
  trace[1].s = 0.5, trace[1].roll = -0.2, trace[1].clearance = 0.1, trace[1].speed = 3;
  trace[2].s = 1.2, trace[2].roll = 0.05, trace[2].clearance = 0.2, trace[2].slip = -0.3;
  trace[3].s = 3.9, trace[3].roll = 0.01;  // the meter from 2 to 3 was jumped over
  const auto rows = WorstPerMeter(trace);
  ASSERT_EQ(rows.size(), 3);
  EXPECT_EQ(rows[0].roll, -0.2);
  EXPECT_EQ(rows[0].clearance, 0.1);
  EXPECT_EQ(rows[0].speed, 3);
  EXPECT_EQ(rows[1].roll, 0.05);
  EXPECT_EQ(rows[1].slip, -0.3);
  EXPECT_EQ(rows[2].s, 3.9);
}

TEST(RouteCsv, IsTheLineInMapCoordinates) {
  const SyntheticPlan made = MakePlan("");
  const auto lines = Lines(RouteCsv(made.plan.rollouts[0].trace, made.terrain.frame()));
  EXPECT_EQ(lines[0], "x_m,y_m,ground_z_m");
  EXPECT_EQ(lines[1], "500020.000,5000050.000,102.000");
}

}  // namespace
}  // namespace dbd
