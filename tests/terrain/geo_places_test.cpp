#include <dbd/terrain/geo_places.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/terrain_files.h"

namespace dbd {
namespace {

using testing::HasSubstr;

class GeoPlacesTest : public testing::Test {
 protected:
  GeoPlaces Read(const std::string& name, const std::string& text) {
    return ReadGeoPlaces(directory_.Write(name, text));
  }
  std::string Message(const std::string& name, const std::string& text) {
    return ErrorOf([&] { Read(name, text); });
  }
  static std::string Feature(const std::string& geometry, const std::string& properties) {
    return R"({"type": "Feature", "geometry": )" + geometry + R"(, "properties": )" + properties +
           "}";
  }
  TemporaryDirectory directory_;
};

TEST_F(GeoPlacesTest, ReadsGeoJsonWithNamesAndHeadings) {
  const std::string depot = Feature(R"({"type": "Point", "coordinates": [15.8, 46.4, 300]})",
                                    R"({"name": "depot", "heading_deg": 90})");
  const std::string other = Feature(R"({"type": "Point", "coordinates": [15.9, 46.5]})", "{}");
  const GeoPlaces read = Read(
      "a.geojson", R"({"type": "FeatureCollection", "features": [)" + depot + "," + other + "]}");
  ASSERT_EQ(read.places.size(), 2U);
  EXPECT_FALSE(read.in_map_coordinates);
  EXPECT_EQ(read.places[0].name, "depot");
  EXPECT_EQ(read.places[0].xy, Eigen::Vector2d(15.8, 46.4));
  EXPECT_EQ(read.places[0].heading_deg, 90);
  EXPECT_EQ(read.places[1].name, "");
  EXPECT_FALSE(read.places[1].heading_deg);
}

TEST_F(GeoPlacesTest, ReadsCsvInMapCoordinatesAndInDegrees) {
  const GeoPlaces map =
      Read("a.csv", "id,x,y,heading_deg\nb1,564050,146300,\nb2,564060,146310,45\n");
  EXPECT_TRUE(map.in_map_coordinates);
  ASSERT_EQ(map.places.size(), 2U);
  EXPECT_EQ(map.places[1].name, "b2");
  EXPECT_EQ(map.places[1].xy, Eigen::Vector2d(564060, 146310));
  EXPECT_FALSE(map.places[0].heading_deg);
  EXPECT_EQ(map.places[1].heading_deg, 45);
  EXPECT_FALSE(Read("b.csv", "lon,lat\n14,46\n").in_map_coordinates);
}

TEST_F(GeoPlacesTest, ReadsWaypointsButNotTracksOfGpx) {
  const GeoPlaces read = Read("a.gpx",
                              R"(<gpx version="1.1" creator="t"
      xmlns="http://www.topografix.com/GPX/1/1"><wpt lat="46" lon="14"><name>hut</name></wpt>
      <trk><trkseg><trkpt lat="46" lon="14"/><trkpt lat="46.1" lon="14"/></trkseg></trk></gpx>)");
  ASSERT_EQ(read.places.size(), 1U);
  EXPECT_EQ(read.places[0].name, "hut");
}

TEST_F(GeoPlacesTest, RefusesWhatHoldsNoPlaces) {
  EXPECT_EQ(ErrorOf([] { ReadGeoPlaces("/no/file.csv"); }), "/no/file.csv: no such file");
  EXPECT_THAT(Message("a.geojson", R"({"type": "FeatureCollection", "features": []})"),
              HasSubstr("holds no point"));
  EXPECT_THAT(Message("b.geojson", R"({"type": "LineString", "coordinates": [[1, 2], [1, 3]]})"),
              HasSubstr("place 1: is a LINESTRING, must be a point"));
  EXPECT_THAT(Message("c.geojson", R"({"type": "Point", "coordinates": [564050, 146300]})"),
              HasSubstr("not a longitude"));
  EXPECT_THAT(Message("d.csv", "a,b\n1,2\n"), HasSubstr("neither the columns lon and lat nor x"));
  EXPECT_THAT(Message("e.csv", "x,y\n1,2\n3,north\n"), HasSubstr("place 2: has no two numbers"));
  EXPECT_THAT(Message("f.csv", "x,y,heading_deg\n1,2,north\n"),
              HasSubstr("heading_deg is 'north', must be a number"));
  EXPECT_THAT(Message("g.geojson", "{\"type\": \"Poi"), HasSubstr("g.geojson"));
  EXPECT_NE(Message("h.csv", ""), "");
}

}  // namespace
}  // namespace dbd
