#include "map_image.h"

#include <dbd/core/error.h>
#include <gdal_priv.h>
#include <gmock/gmock.h>

#include <array>

#include "apps/synthetic_plan.h"
#include "map_canvas.h"
#include "support/temporary_directory.h"

namespace dbd {
namespace {

/// A PNG file read back.
class Image {
 public:
  explicit Image(const std::string& file) {
    GDALAllRegister();
    dataset_.reset(GDALDataset::Open(file.c_str(), GDAL_OF_RASTER));
  }
  int width() const { return dataset_->GetRasterXSize(); }
  int height() const { return dataset_->GetRasterYSize(); }
  std::array<int, 3> At(int x, int y) const {
    std::array<int, 3> rgb{};
    for (int band = 0; band < 3; ++band) {
      EXPECT_EQ(dataset_->GetRasterBand(band + 1)->RasterIO(GF_Read, x, y, 1, 1, &rgb[band], 1, 1,
                                                            GDT_Int32, 0, 0),
                CE_None);
    }
    return rgb;
  }

 private:
  GDALDatasetUniquePtr dataset_;
};

MapContent StraightRoute() {
  MapContent content;
  content.title = "A straight route";
  content.start = Eigen::Vector2d(20, 50);
  content.goal = Eigen::Vector2d(180, 50);
  content.route = {{20, 50}, {180, 50}};
  content.candidates = {
      {{{20, 50}, {180, 50}}, Outcome::kReached, {180, 50}},
      {{{5, 5}, {5, 80}, {195, 80}, {195, 95}}, Outcome::kImmobilized, {195, 95}}};
  return content;
}

// The slope measures 200 m x 100 m and is shown whole, since the lines spread over most of it:
// 1400 pixels / 200 m = 7 pixels per metre.
constexpr int kPixelsPerMeter = 7;
std::array<int, 3> PixelAt(const Image& image, double x, double y) {
  return image.At(static_cast<int>(x * kPixelsPerMeter),
                  kMapTitleHeight + static_cast<int>((100 - y) * kPixelsPerMeter));
}

std::array<int, 3> Rgb(const Color& color) {
  const auto part = [](double value) { return static_cast<int>(value * 255 + 0.5); };
  return {part(color.red), part(color.green), part(color.blue)};
}

TEST(MapImage, HasTheMapBetweenTitleAndLegend) {
  const TemporaryDirectory scratch;
  WriteMapImage(scratch.File("map.png"), MakeSlope(""), StraightRoute());
  const Image image(scratch.File("map.png"));
  EXPECT_EQ(image.width(), kMapImageWidth);
  EXPECT_GE(image.height(), kMapTitleHeight + 700 + 60);
  EXPECT_LE(image.height(), kMapTitleHeight + 700 + 160);
}

TEST(MapImage, TheRouteIsWhereItWasDriven) {
  const TemporaryDirectory scratch;
  WriteMapImage(scratch.File("map.png"), MakeSlope(""), StraightRoute());
  const Image image(scratch.File("map.png"));
  EXPECT_EQ(PixelAt(image, 100, 50), Rgb(kRouteColor));
  EXPECT_EQ(PixelAt(image, 150, 50), Rgb(kRouteColor));
  EXPECT_NE(PixelAt(image, 100, 30), Rgb(kRouteColor));
  // Candidate 1 is drawn see-through: more red than the ground around it and far less blue.
  const auto line = PixelAt(image, 100, 80);
  const auto ground = PixelAt(image, 100, 70);
  EXPECT_LT(line[2], ground[2] - 60);
}

TEST(MapImage, ACrossMarksTheBlockedPlace) {
  const TemporaryDirectory scratch;
  MapContent content = StraightRoute();
  content.blocked = Eigen::Vector2d(60, 20);
  WriteMapImage(scratch.File("map.png"), MakeSlope(""), content);
  EXPECT_EQ(PixelAt(Image(scratch.File("map.png")), 60, 20), Rgb(kBlockedColor));
}

TEST(MapImage, LowGroundIsGreenAndHighGroundPale) {
  const TemporaryDirectory scratch;
  WriteMapImage(scratch.File("map.png"), MakeSlope(""), MapContent());
  const Image image(scratch.File("map.png"));
  const auto west = PixelAt(image, 5, 52);
  const auto east = PixelAt(image, 195, 52);
  EXPECT_GT(west[1], west[0]);
  EXPECT_GT(east[0], west[0]);
}

TEST(MapImage, AFileThatCannotBeWrittenIsNamed) {
  try {
    WriteMapImage("/nonexistent/map.png", MakeSlope(""), MapContent());
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "/nonexistent/map.png: cannot be written");
  }
}

TEST(RoundLength, IsOneTwoOrFiveTimesAPowerOfTen) {
  EXPECT_DOUBLE_EQ(RoundLength(99), 50);
  EXPECT_DOUBLE_EQ(RoundLength(49), 20);
  EXPECT_DOUBLE_EQ(RoundLength(1900), 1000);
  EXPECT_DOUBLE_EQ(RoundLength(0.7), 0.5);
}

}  // namespace
}  // namespace dbd
