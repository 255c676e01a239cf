#include "load_surface_model.h"

#include <dbd/core/error.h>

#include <cmath>
#include <limits>

#include "resample_raster.h"

namespace dbd {

ObstacleMap LoadSurfaceModel(const std::string& name, double threshold,
                             const ElevationRaster& ground, const LocalFrame& frame) {
  RasterRequest request;
  request.files = {name};
  const RasterFile file(request);
  HeightMap::Grid grid = ground.grid;
  const GDALDatasetUniquePtr surface =
      ResampleTo(file, grid, ground.map_wkt, {"bilinear", "Float64", "nan"});
  std::vector<float> lowest(grid.CellCount(), std::numeric_limits<float>::infinity());
  std::vector<double> line(static_cast<std::size_t>(grid.columns));
  bool overlaps = false;
  for (int row = 0; row < grid.rows; ++row) {
    const CPLErr read = surface->GetRasterBand(1)->RasterIO(
        GF_Read, 0, grid.rows - 1 - row, grid.columns, 1, line.data(), grid.columns, 1, GDT_Float64,
        0, 0, nullptr);
    if (read != CE_None) file.Fail("is corrupt");
    for (int column = 0; column < grid.columns; ++column) {
      const std::size_t cell = static_cast<std::size_t>(row) * grid.columns + column;
      const double top = file.height_scale() * line[column] + file.height_offset();
      const double above = top - (double{ground.heights[cell]} + ground.base_height);
      overlaps = overlaps || std::isfinite(above);
      if (above > threshold) lowest[cell] = 0;  // stands on the ground
    }
  }
  if (!overlaps) file.Fail("has no height anywhere on the elevation; do they overlap?");
  grid.first_center = frame.ToLocal(grid.first_center);
  return ObstacleMap(grid, std::move(lowest));
}

}  // namespace dbd
