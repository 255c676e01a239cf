#include <dbd/terrain/geo_path.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/terrain_files.h"

namespace dbd {
namespace {

using testing::HasSubstr;

class GeoPathTest : public testing::Test {
 protected:
  GeoPath Read(const std::string& name, const std::string& text) {
    return ReadGeoPath(directory_.Write(name, text));
  }
  std::string Message(const std::string& name, const std::string& text) {
    return ErrorOf([&] { Read(name, text); });
  }
  TemporaryDirectory directory_;
};

TEST_F(GeoPathTest, ReadsGeoJson) {
  const GeoPath path = Read("a.geojson", R"({"type": "LineString",
      "coordinates": [[14.5, 46.1, 300], [14.6, 46.2, 310], [14.6, 46.2, 311]]})");
  ASSERT_EQ(path.points.size(), 2U);
  EXPECT_EQ(path.points[0], Eigen::Vector2d(14.5, 46.1));
  EXPECT_FALSE(path.in_map_coordinates);
}

TEST_F(GeoPathTest, ReadsGpxRoutesAndTracks) {
  const std::string head =
      R"(<gpx version="1.1" creator="t" xmlns="http://www.topografix.com/GPX/1/1">)";
  const GeoPath route = Read("a.gpx", head +
                                          R"(<rte><rtept lat="46" lon="14"/>
      <rtept lat="46.5" lon="14.5"/></rte></gpx>)");
  EXPECT_EQ(route.points[1], Eigen::Vector2d(14.5, 46.5));
  const GeoPath track = Read("b.gpx", head +
                                          R"(<trk><trkseg>
      <trkpt lat="46" lon="14"/><trkpt lat="46.1" lon="14"/></trkseg><trkseg>
      <trkpt lat="47" lon="14"/><trkpt lat="47.5" lon="14"/></trkseg></trk></gpx>)");
  EXPECT_EQ(track.line_count, 2);
  EXPECT_EQ(track.points[0].y(), 47);
}

TEST_F(GeoPathTest, ReadsKml) {
  const GeoPath path = Read("a.kml", R"(<?xml version="1.0"?>
      <kml xmlns="http://www.opengis.net/kml/2.2"><Document><Placemark><LineString>
      <coordinates>14,46,0 14.5,46.5,0</coordinates></LineString></Placemark></Document></kml>)");
  EXPECT_EQ(path.points.back(), Eigen::Vector2d(14.5, 46.5));
}

TEST_F(GeoPathTest, ReadsCsv) {
  const GeoPath degrees = Read("a.csv", "name,lat,lon\na,46,14\nb,46.5,14.5\n");
  EXPECT_EQ(degrees.points[1], Eigen::Vector2d(14.5, 46.5));
  EXPECT_FALSE(degrees.in_map_coordinates);
  const GeoPath meters = Read("b.csv", "x,y\n564050,146300\n564060,146310\n");
  EXPECT_EQ(meters.points[0], Eigen::Vector2d(564050, 146300));
  EXPECT_TRUE(meters.in_map_coordinates);
}

TEST_F(GeoPathTest, RefusesWhatIsNoPath) {
  EXPECT_EQ(ErrorOf([] { ReadGeoPath("/no/path.gpx"); }), "/no/path.gpx: no such file");
  EXPECT_THAT(Message("a.geojson", R"({"type": "Point", "coordinates": [1, 2]})"),
              HasSubstr("holds no line"));
  EXPECT_THAT(Message("b.geojson", R"({"type": "LineString", "coordinates": [[1, 2], [1, 2]]})"),
              HasSubstr("fewer than two"));
  EXPECT_THAT(Message("c.geojson", R"({"type": "LineString", "coordinates": [[5e5, 2], [1, 2]]})"),
              HasSubstr("not a longitude"));
  EXPECT_THAT(Message("d.geojson", "{\"type\": \"LineStr"), HasSubstr("d.geojson"));
  EXPECT_THAT(Message("e.csv", "a,b\n1,2\n3,4\n"), HasSubstr("lon and lat"));
  EXPECT_THAT(Message("f.csv", "lon,lat\n1,2\n3,north\n"), HasSubstr("line 3"));
  EXPECT_THAT(Message("g.txt", "nothing"), HasSubstr("cannot be read as a path"));
  EXPECT_NE(Message("h.csv", ""), "");
}

TEST_F(GeoPathTest, ReadsRealTracks) {
  const std::string file = SharedFile("gps/korita-zbevnica.gpx");
  if (file.empty()) GTEST_SKIP() << "no shared data";
  const GeoPath gpx = ReadGeoPath(file);
  EXPECT_EQ(gpx.line_count, 4);
  EXPECT_EQ(gpx.points.size(), ReadGeoPath(SharedFile("gps/korita-zbevnica.kml")).points.size());
  EXPECT_EQ(ReadGeoPath(SharedFile("gps/route.gpx")).points.size(), 55U);
}

TEST_F(GeoPathTest, SurvivesMalformedFiles) {
  const std::string directory = SharedFile("malformed");
  if (directory.empty()) GTEST_SKIP() << "no shared data";
  testing::internal::CaptureStderr();
  for (const auto& entry : std::filesystem::recursive_directory_iterator(directory)) {
    if (!entry.is_regular_file()) continue;
    const std::string message = ErrorOf([&] { ReadGeoPath(entry.path().string()); });
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace dbd
