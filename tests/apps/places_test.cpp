#include "places.h"

#include <dbd/core/error.h>
#include <gmock/gmock.h>

#include <numbers>

#include "apps/synthetic_plan.h"

namespace dbd {
namespace {

using testing::HasSubstr;

template <typename Action>
std::string MessageOf(Action action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(ParsePlace, ReadsTwoNumbersAndAHeading) {
  const TypedPlace place = ParsePlace("--start", "564050.5, -146300,90");
  EXPECT_EQ(place.xy, Eigen::Vector2d(564050.5, -146300));
  EXPECT_EQ(place.heading_deg, 90);
  EXPECT_FALSE(ParsePlace("--start", "1,2").heading_deg);
}

TEST(ParsePlace, SaysWhichFlagAndWhatWasTyped) {
  for (const char* text : {"12,abc", "", "1", "1,2,3,4", "1,2,", "nan,1", "1;2", "inf,0"}) {
    EXPECT_EQ(MessageOf([&] { ParsePlace("--start", text); }),
              std::string("--start: '") + text + "' is not X,Y or X,Y,HEADING_DEG");
  }
}

TEST(ParsePoint, TakesNoHeading) {
  EXPECT_EQ(ParsePoint("--obstacles-origin", "1,2"), Eigen::Vector2d(1, 2));
  EXPECT_EQ(MessageOf([] { ParsePoint("--obstacles-origin", "1,2,3"); }),
            "--obstacles-origin: '1,2,3' is not X,Y");
}

TEST(CompassDegrees, NorthIsZeroAndEastIsNinety) {
  EXPECT_DOUBLE_EQ(CompassDegrees(std::numbers::pi / 2), 0);
  EXPECT_DOUBLE_EQ(CompassDegrees(0), 90);
  EXPECT_DOUBLE_EQ(CompassDegrees(std::numbers::pi), 270);
  EXPECT_DOUBLE_EQ(YawFromCompass(90), 0);
  EXPECT_NEAR(CompassDegrees(YawFromCompass(211.5)), 211.5, 1e-12);
}

TEST(LocatePlace, TakesMapCoordinates) {
  const LocalPlace place =
      LocatePlace("--start", {{500020, 5000050}, 0.0}, Coordinates::kMap, MakeSlope(""));
  EXPECT_EQ(place.xy, Eigen::Vector2d(20, 50));
  EXPECT_DOUBLE_EQ(*place.yaw, std::numbers::pi / 2);
}

TEST(LocatePlace, TakesLongitudeAndLatitude) {
  const Terrain terrain = MakeSlope(kUtm33);
  const Eigen::Vector2d lon_lat = terrain.frame().ToWgs84({20, 50});
  const LocalPlace place = LocatePlace("--goal", {lon_lat, {}}, Coordinates::kWgs84, terrain);
  EXPECT_NEAR((place.xy - Eigen::Vector2d(20, 50)).norm(), 0, 1e-3);
  EXPECT_FALSE(place.yaw);
}

TEST(LocatePlace, RefusesPlacesOutsideTheMapAndSaysWhereItIs) {
  const std::string message = MessageOf([] {
    LocatePlace("--goal", {{1, 2}, {}}, Coordinates::kMap, MakeSlope(kUtm33));
  });
  EXPECT_EQ(message,
            "--goal 1,2: outside the map, which covers x 500000 to 500200, y 5000000 to 5000100");
}

TEST(LocatePlace, RefusesWgs84WithoutACoordinateSystem) {
  const auto locate = [] {
    LocatePlace("--start", {{15, 45}, {}}, Coordinates::kWgs84, MakeSlope(""));
  };
  EXPECT_THAT(MessageOf(locate), HasSubstr("no coordinate system"));
}

TEST(DescribePlace, IsInTheCoordinatesOfTheFile) {
  EXPECT_EQ(DescribePlace(MakeSlope(kUtm33).frame(), {12.34, 5}), "500012.3, 5000005.0");
}

}  // namespace
}  // namespace dbd
