#include "png_file.h"

#include <dbd/core/error.h>
#include <gdal_priv.h>
#include <gtest/gtest.h>

#include <vector>

#include "support/temporary_directory.h"

namespace dbd {
namespace {

/// Rows of colours that depend on the place, some smooth and some not, with a rest in each row that
/// is not part of the picture.
std::vector<std::uint32_t> Colours(int width, int height, int stride) {
  std::vector<std::uint32_t> pixels(static_cast<std::size_t>(stride) * height, 0xdeadbeef);
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const auto red = static_cast<std::uint32_t>(row % 256);
      const auto green = static_cast<std::uint32_t>((row * 7 + column * column) % 256);
      const auto blue = static_cast<std::uint32_t>(column / 3 % 256);
      pixels[static_cast<std::size_t>(row) * stride + column] =
          0xff000000u | red << 16 | green << 8 | blue;
    }
  }
  return pixels;
}

void ExpectReadBack(const std::filesystem::path& file, const PixelRows& image) {
  GDALAllRegister();
  const GDALDatasetUniquePtr dataset(GDALDataset::Open(file.c_str(), GDAL_OF_RASTER));
  ASSERT_TRUE(dataset);
  ASSERT_EQ(dataset->GetRasterXSize(), image.width);
  ASSERT_EQ(dataset->GetRasterYSize(), image.height);
  ASSERT_EQ(dataset->GetRasterCount(), 3);
  std::vector<std::uint8_t> samples(static_cast<std::size_t>(image.width) * image.height);
  for (int band = 0; band < 3; ++band) {
    ASSERT_EQ(dataset->GetRasterBand(band + 1)->RasterIO(GF_Read, 0, 0, image.width, image.height,
                                                         samples.data(), image.width, image.height,
                                                         GDT_Byte, 0, 0),
              CE_None);
    for (int row = 0; row < image.height; ++row) {
      for (int column = 0; column < image.width; ++column) {
        const std::uint32_t pixel =
            image.pixels[static_cast<std::size_t>(row) * image.stride + column];
        ASSERT_EQ(samples[static_cast<std::size_t>(row) * image.width + column],
                  (pixel >> (16 - 8 * band) & 0xff))
            << "band " << band << ", row " << row << ", column " << column;
      }
    }
  }
}

TEST(WritePng, IsReadBackAsItWas) {
  const TemporaryDirectory directory;
  for (const auto& [width, height] :
       {std::pair{1, 1}, {3, 64}, {5, 65}, {200, 63}, {301, 300}, {1, 129}}) {
    const auto pixels = Colours(width, height, width + 2);
    const PixelRows image{width, height, static_cast<std::size_t>(width) + 2, pixels.data()};
    const std::filesystem::path file = directory.path() / "image.png";
    WritePng(file, image);
    ExpectReadBack(file, image);
  }
}

TEST(WritePng, SaysWhichFileCannotBeWritten) {
  const std::uint32_t pixel = 0;
  EXPECT_THROW(WritePng("/nowhere/image.png", {1, 1, 1, &pixel}), InputError);
}

}  // namespace
}  // namespace dbd
