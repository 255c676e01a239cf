#include "resample_raster.h"

#include <dbd/core/error.h>
#include <gdal_utils.h>

#include <iomanip>
#include <memory>
#include <sstream>
#include <vector>

namespace dbd {
namespace {

using Arguments = std::vector<std::string>;

// As GDAL wants them, ended by null; valid as long as the arguments.
std::vector<char*> Raw(Arguments& arguments) {
  std::vector<char*> raw;
  for (std::string& argument : arguments) raw.push_back(argument.data());
  raw.push_back(nullptr);
  return raw;
}

std::string Number(double value) {
  std::ostringstream text;
  text << std::setprecision(17) << value;
  return text.str();
}

Arguments TargetGrid(const HeightMap::Grid& grid) {
  const Eigen::Vector2d low = grid.first_center - 0.5 * grid.cell_size;
  const Eigen::Vector2d high = grid.Center(grid.columns - 1, grid.rows - 1) + 0.5 * grid.cell_size;
  return {"-te",
          Number(low.x()),
          Number(low.y()),
          Number(high.x()),
          Number(high.y()),
          "-ts",
          std::to_string(grid.columns),
          std::to_string(grid.rows)};
}

Arguments WarpArguments(const RasterFile& file, const HeightMap::Grid& grid,
                        const std::string& map_wkt, const Resampling& resampling) {
  Arguments arguments = TargetGrid(grid);
  const Arguments fixed = {"-of",        "VRT",
                           "-r",         resampling.method,
                           "-ot",        resampling.data_type,
                           "-dstnodata", resampling.nodata,
                           "-et",        "0.01"};
  arguments.insert(arguments.end(), fixed.begin(), fixed.end());
  if (file.crs() != nullptr && !map_wkt.empty()) {
    arguments.insert(arguments.end(), {"-s_srs", WktOf(*file.crs()), "-t_srs", map_wkt});
  }
  return arguments;
}

// The chosen band alone; null when it already is alone.
GDALDatasetUniquePtr ExtractBand(const RasterFile& file) {
  if (file.dataset()->GetRasterCount() == 1) return nullptr;
  Arguments arguments = {"-of", "VRT", "-b", std::to_string(file.band_number())};
  const std::vector<char*> raw = Raw(arguments);
  const std::unique_ptr<GDALTranslateOptions, decltype(&GDALTranslateOptionsFree)> options(
      GDALTranslateOptionsNew(const_cast<char**>(raw.data()), nullptr), &GDALTranslateOptionsFree);
  return GDALDatasetUniquePtr(GDALDataset::FromHandle(
      GDALTranslate("", GDALDataset::ToHandle(file.dataset()), options.get(), nullptr)));
}

GDALDatasetUniquePtr Warp(GDALDataset* dataset, Arguments arguments) {
  const std::vector<char*> raw = Raw(arguments);
  const std::unique_ptr<GDALWarpAppOptions, decltype(&GDALWarpAppOptionsFree)> options(
      GDALWarpAppOptionsNew(const_cast<char**>(raw.data()), nullptr), &GDALWarpAppOptionsFree);
  GDALDatasetH source = GDALDataset::ToHandle(dataset);
  return GDALDatasetUniquePtr(
      GDALDataset::FromHandle(GDALWarp("", nullptr, 1, &source, options.get(), nullptr)));
}

}  // namespace

GDALDatasetUniquePtr ResampleTo(const RasterFile& file, const HeightMap::Grid& map_grid,
                                const std::string& map_wkt, const Resampling& resampling) {
  const GdalSession gdal;
  const GDALDatasetUniquePtr band = ExtractBand(file);
  // Reads through the band's VRT while it lives, so it is copied into memory.
  const GDALDatasetUniquePtr warped =
      Warp(band ? band.get() : file.dataset(), WarpArguments(file, map_grid, map_wkt, resampling));
  if (!warped) file.Fail("cannot be resampled: " + gdal.Reason("no reason given"));
  GDALDriver* memory = GetGDALDriverManager()->GetDriverByName("MEM");
  GDALDatasetUniquePtr copy(memory->CreateCopy("", warped.get(), FALSE, nullptr, nullptr, nullptr));
  if (!copy || !gdal.error().empty()) file.Fail("is corrupt: " + gdal.Reason("read error"));
  return copy;
}

}  // namespace dbd
