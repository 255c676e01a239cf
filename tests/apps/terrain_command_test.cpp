#include "support/program.h"
#include "support/terrain_files.h"

namespace dbd {
namespace {

using testing::HasSubstr;

TEST_F(Program, DescribesTerrain) {
  const Ending run = RunDbd("terrain info --json " + Land("dem.tif"));
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(nlohmann::json::parse(run.output)["files"][0]["columns"], 160);
  EXPECT_GT(nlohmann::json::parse(run.output)["files"][0]["ground"]["slope_deg"]["median"], 0);
}

TEST_F(Program, DescribesTerrainInTheCoordinatesThatRequestsTake) {
  TestRaster raster;
  raster.columns = raster.rows = 60;
  raster.transform = {15, 2e-5, 0, 47, 0, -2e-5};
  raster.crs = "EPSG:4326";
  const std::string dem = raster.Write(Scratch("given_degrees.tif"));
  const auto info = nlohmann::json::parse(RunDbd("terrain info --json " + dem).output);
  const auto& ground = info["files"][0]["ground"];
  EXPECT_EQ(ground["file_crs"], "WGS 84 (EPSG:4326)");
  EXPECT_EQ(ground["map_crs"], "WGS 84 / UTM zone 33N (EPSG:32633)");
  const double x = ground["file_south_west"][0], y = ground["file_south_west"][1];
  EXPECT_NEAR(x, 15, 1e-4);
  EXPECT_NEAR(y, 47 - 60 * 2e-5, 1e-4);
  EXPECT_NEAR(ground["map_min"][0], 500000, 10);
  const std::string text = RunDbd("terrain info " + dem).output;
  EXPECT_THAT(text, HasSubstr("requests take places in WGS 84 (EPSG:4326)\n"));
  EXPECT_THAT(text, HasSubstr("drives are in WGS 84 / UTM zone 33N (EPSG:32633)\n"));
  // A place between the corners is taken by a request as it stands there.
  const double x_end = ground["file_north_east"][0], y_end = ground["file_north_east"][1];
  const auto at = [&](double share) {
    return std::to_string(x + share * (x_end - x)) + "," + std::to_string(y + share * (y_end - y));
  };
  const Ending run =
      RunDbd(PlanCommand(dem, kVehicle + std::string("--start ") + at(0.4) + " --goal " + at(0.6)));
  EXPECT_TRUE(run.exit_code == 0 || run.exit_code == 3) << run.errors;
}

TEST_F(Program, StatesMetricCornersOnce) {
  const std::string text = RunDbd("terrain info " + Land("dem.tif")).output;
  EXPECT_THAT(text, HasSubstr("requests take places in WGS 84 / UTM zone 33N"));
  EXPECT_THAT(text, HasSubstr("  x        500000 to 500160\n"));
  EXPECT_THAT(text, testing::Not(HasSubstr("drives are in")));
}

}  // namespace
}  // namespace dbd
