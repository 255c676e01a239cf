#include <dbd/terrain/local_frame.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>
#include <vector>

#include "support/terrain_files.h"

namespace dbd {
namespace {

using testing::HasSubstr;

TEST(LocalFrame, KnowsTheCentralMeridian) {
  // UTM zone 33 has its central meridian at 15 degrees east, easting 500 km; the equator is at
  // northing 0.
  const LocalFrame frame("EPSG:32633", {500000, 0});
  EXPECT_NEAR(frame.ToWgs84({0, 0}).x(), 15, 1e-9);
  EXPECT_NEAR(frame.ToWgs84({0, 0}).y(), 0, 1e-9);
}

TEST(LocalFrame, ReturnsFromWgs84WithinAMillimetre) {
  for (const char* crs : {"EPSG:32633", "EPSG:3794", "EPSG:2949", "EPSG:31287"}) {
    const LocalFrame seed(crs, {0, 0});
    const double longitude = std::string(crs) == "EPSG:2949" ? -70.5 : 14.8;
    const LocalFrame frame(crs, seed.FromWgs84({longitude, 46.5}));
    for (const Eigen::Vector2d& local : {Eigen::Vector2d(0, 0), Eigen::Vector2d(812.5, -431.25)}) {
      EXPECT_LT((frame.FromWgs84(frame.ToWgs84(local)) - local).norm(), 1e-3) << crs;
    }
  }
}

TEST(LocalFrame, AddsItsOrigin) {
  const LocalFrame frame("", {1000, 2000});
  EXPECT_EQ(frame.ToMap({3, 4}), Eigen::Vector2d(1003, 2004));
  EXPECT_EQ(frame.ToLocal({1003, 2004}), Eigen::Vector2d(3, 4));
  EXPECT_EQ(frame.FromSource({1003, 2004}), Eigen::Vector2d(3, 4));
}

TEST(LocalFrame, TakesCoordinatesOfAGeographicFile) {
  LocalFrame frame("EPSG:32633", {500000, 0});
  frame.set_source_wkt("EPSG:4326");
  const Eigen::Vector2d lon_lat(15.01, 0.02);
  EXPECT_LT((frame.FromSource(lon_lat) - frame.FromWgs84(lon_lat)).norm(), 1e-6);
  EXPECT_LT((frame.ToSource(frame.FromSource(lon_lat)) - lon_lat).norm(), 1e-9);
}

TEST(LocalFrame, SaysWhatItCannotDo) {
  EXPECT_THAT(ErrorOf([] {
                LocalFrame("", {0, 0}).ToWgs84({0, 0});
              }),
              HasSubstr("no coordinate system"));
  EXPECT_THAT(ErrorOf([] { LocalFrame("EPSG:4326", {0, 0}); }), HasSubstr("not projected"));
  EXPECT_THAT(ErrorOf([] { LocalFrame("nonsense", {0, 0}); }), HasSubstr("not understood"));
}

TEST(LocalFrame, NamesItsCoordinateSystem) {
  EXPECT_EQ(LocalFrame("EPSG:32633", {0, 0}).CrsName(), "WGS 84 / UTM zone 33N (EPSG:32633)");
}

TEST(LocalFrame, ServesManyThreads) {
  const LocalFrame frame("EPSG:32633", {500000, 5200000});
  const Eigen::Vector2d expected = frame.ToWgs84({100, 200});
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&] {
      const LocalFrame copy = frame;
      for (int k = 0; k < 50; ++k) EXPECT_EQ(copy.ToWgs84({100, 200}), expected);
    });
  }
  for (std::thread& thread : threads) thread.join();
}

}  // namespace
}  // namespace dbd
