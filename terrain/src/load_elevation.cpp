#include "load_elevation.h"

#include <dbd/core/error.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "map_window.h"
#include "raster_file.h"
#include "warp_raster.h"

namespace dbd {
namespace {

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

// While loading: the raster, a copy when it is warped, and the finished map.
const std::size_t kBytesPerCell = 2 * sizeof(float) + HeightMap::MemoryNeed(1);

// Of GDAL, while the rows are read: some rows of tiles.
constexpr std::int64_t kCacheBytes = 64 << 20;

// Values that files without a nodata entry use for it.
bool IsNeverAHeight(double height) {
  return !std::isfinite(height) || height == -9999.0 || std::abs(height) > 30e3;
}

class BandReader {
 public:
  explicit BandReader(const RasterFile& file)
      : file_(file),
        band_(file.band()),
        mask_(band_->GetMaskBand()),
        values_(band_->GetXSize()),
        is_known_(band_->GetXSize()) {}

  // Heights [m], not a number where unknown.
  const std::vector<double>& Row(int row) {
    const GdalSession gdal;
    const int columns = band_->GetXSize();
    const CPLErr read = band_->RasterIO(GF_Read, 0, row, columns, 1, values_.data(), columns, 1,
                                        GDT_Float64, 0, 0, nullptr);
    const CPLErr masked = mask_->RasterIO(GF_Read, 0, row, columns, 1, is_known_.data(), columns, 1,
                                          GDT_Byte, 0, 0, nullptr);
    if (read != CE_None || masked != CE_None || !gdal.error().empty()) {
      file_.Fail("is corrupt at row " + std::to_string(row) + ": " + gdal.Reason("read error"));
    }
    for (int i = 0; i < columns; ++i) {
      const bool unknown = is_known_[i] == 0 || IsNeverAHeight(values_[i]);
      values_[i] = unknown ? std::numeric_limits<double>::quiet_NaN()
                           : file_.height_scale() * values_[i] + file_.height_offset();
    }
    return values_;
  }

 private:
  const RasterFile& file_;
  GDALRasterBand* band_;
  GDALRasterBand* mask_;
  std::vector<double> values_;
  std::vector<std::uint8_t> is_known_;
};

// A round number near the raster's heights, so that floats relative to it are exact.
double BaseHeightOf(const std::vector<double>& row) {
  const auto known =
      std::find_if(row.begin(), row.end(), [](double h) { return std::isfinite(h); });
  return known == row.end() ? std::numeric_limits<double>::quiet_NaN() : std::round(*known);
}

// Tells of every hundredth of the rows.
class RowProgress {
 public:
  RowProgress(const LoadProgress& progress, const HeightMap::Grid& grid)
      : progress_(progress), rows_(grid.rows) {
    const double bytes = static_cast<double>(ElevationMemoryNeed(grid.columns, grid.rows));
    char text[80];
    std::snprintf(text, sizeof text, "elevation, %.2f GB, row", bytes / 1e9);
    stage_ = text;
  }

  void Reach(int row) const {
    if (progress_ && row % std::max(1, rows_ / 100) == 0) progress_(stage_, row, rows_);
  }

 private:
  const LoadProgress& progress_;
  int rows_;
  std::string stage_;
};

void ReadHeights(const RasterFile& file, const LoadProgress& progress, ElevationRaster* raster) {
  const HeightMap::Grid& grid = raster->grid;
  const RowProgress reached(progress, grid);
  reached.Reach(0);
  const GdalCacheLimit cache(kCacheBytes);
  raster->heights.assign(grid.CellCount(), kUnknown);
  BandReader reader(file);
  bool has_base = false;
  for (int row = 0; row < grid.rows; ++row) {
    const std::vector<double>& heights = reader.Row(row);
    reached.Reach(row + 1);
    if (!has_base) {
      const double base = BaseHeightOf(heights);
      if (std::isnan(base)) continue;
      raster->base_height = base;
      has_base = true;
    }
    const int target = file.is_south_up() ? row : grid.rows - 1 - row;
    float* line = raster->heights.data() + static_cast<std::size_t>(target) * grid.columns;
    for (int i = 0; i < grid.columns; ++i) {
      line[i] = static_cast<float>(heights[i] - raster->base_height);
    }
  }
  if (!has_base) file.Fail("holds no known height, every cell is nodata");
}

}  // namespace

std::size_t ElevationMemoryNeed(int columns, int rows) {
  return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows) * kBytesPerCell;
}

ElevationRaster LoadElevation(const RasterRequest& request) {
  RasterFile file(request);
  const std::string& name = file.name();
  ElevationRaster raster;
  raster.note = CutToMemory(request, kBytesPerCell, &file);
  raster.grid = file.Grid();
  if (raster.grid.columns < 2 || raster.grid.rows < 2) {
    file.Fail("is " + std::to_string(raster.grid.columns) + " x " +
              std::to_string(raster.grid.rows) + " cells, at least 2 x 2 are needed");
  }
  ReadHeights(file, request.progress, &raster);
  if (file.crs() == nullptr) return raster;
  raster.source_wkt = raster.map_wkt = WktOf(*file.crs());
  if (NeedsWarp(*file.crs(), raster.grid))
    WarpToUtm(name, kBytesPerCell, request.memory_limit, &raster);
  return raster;
}

}  // namespace dbd
