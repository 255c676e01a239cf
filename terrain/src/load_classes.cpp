#include "load_classes.h"

#include <dbd/core/error.h>
#include <gdal_utils.h>

#include <algorithm>
#include <iomanip>
#include <memory>
#include <sstream>

#include "raster_file.h"

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
                        const std::string& map_wkt) {
  Arguments arguments = TargetGrid(grid);
  const Arguments fixed = {"-of", "VRT",   "-r",         "near",
                           "-ot", "Int32", "-dstnodata", std::to_string(kNoClass),
                           "-et", "0.01"};
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

void CheckOverlap(const RasterFile& file, const std::vector<std::int32_t>& classes) {
  const bool any = std::any_of(classes.begin(), classes.end(),
                               [](std::int32_t code) { return code != kNoClass; });
  if (!any) file.Fail("has no class anywhere on the elevation raster; do they overlap?");
}

}  // namespace

std::vector<std::int32_t> LoadClasses(const RasterRequest& request, const HeightMap::Grid& map_grid,
                                      const std::string& map_wkt) {
  const RasterFile file(request);
  const GDALDataType type = file.band()->GetRasterDataType();
  if (!GDALDataTypeIsInteger(type)) {
    file.Fail(std::string("holds ") + GDALGetDataTypeName(type) +
              ", a class raster holds integers");
  }
  const GdalSession gdal;
  const GDALDatasetUniquePtr band = ExtractBand(file);
  const GDALDatasetUniquePtr warped =
      Warp(band ? band.get() : file.dataset(), WarpArguments(file, map_grid, map_wkt));
  if (!warped) file.Fail("cannot be resampled: " + gdal.Reason("no reason given"));
  std::vector<std::int32_t> classes(map_grid.CellCount(), kNoClass);
  for (int row = 0; row < map_grid.rows; ++row) {
    std::int32_t* line =
        classes.data() + static_cast<std::size_t>(map_grid.rows - 1 - row) * map_grid.columns;
    const CPLErr read = warped->GetRasterBand(1)->RasterIO(
        GF_Read, 0, row, map_grid.columns, 1, line, map_grid.columns, 1, GDT_Int32, 0, 0, nullptr);
    if (read != CE_None || !gdal.error().empty()) {
      file.Fail("is corrupt: " + gdal.Reason("read error"));
    }
  }
  CheckOverlap(file, classes);
  return classes;
}

}  // namespace dbd
