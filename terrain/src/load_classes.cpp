#include "load_classes.h"

#include <dbd/core/error.h>

#include <algorithm>

#include "raster_file.h"
#include "resample_raster.h"

namespace dbd {
namespace {

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
  const GDALDatasetUniquePtr resampled =
      ResampleTo(file, map_grid, map_wkt, {"near", "Int32", std::to_string(kNoClass)});
  std::vector<std::int32_t> classes(map_grid.CellCount(), kNoClass);
  const GdalSession gdal;
  for (int row = 0; row < map_grid.rows; ++row) {
    std::int32_t* line =
        classes.data() + static_cast<std::size_t>(map_grid.rows - 1 - row) * map_grid.columns;
    const CPLErr read = resampled->GetRasterBand(1)->RasterIO(
        GF_Read, 0, row, map_grid.columns, 1, line, map_grid.columns, 1, GDT_Int32, 0, 0, nullptr);
    if (read != CE_None) file.Fail("is corrupt: " + gdal.Reason("read error"));
  }
  CheckOverlap(file, classes);
  return classes;
}

}  // namespace dbd
