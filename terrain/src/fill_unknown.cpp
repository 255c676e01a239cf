#include "fill_unknown.h"

#include <dbd/core/error.h>
#include <gdal_alg.h>
#include <gdal_priv.h>

#include <algorithm>
#include <cmath>

#include "gdal_session.h"

namespace dbd {
namespace {

// A band over memory that stays the caller's.
GDALDatasetUniquePtr Wrap(const HeightMap::Grid& grid, GDALDataType type, void* cells) {
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("MEM");
  GDALDatasetUniquePtr dataset(driver->Create("", grid.columns, grid.rows, 0, type, nullptr));
  char pointer[64] = {};
  CPLPrintPointer(pointer, cells, sizeof pointer - 1);
  const std::string option = std::string("DATAPOINTER=") + pointer;
  const char* const options[] = {option.c_str(), nullptr};
  dataset->AddBand(type, const_cast<char**>(options));
  return dataset;
}

std::size_t CountUnknown(const std::vector<float>& heights) {
  return static_cast<std::size_t>(
      std::count_if(heights.begin(), heights.end(), [](float h) { return std::isnan(h); }));
}

}  // namespace

double FillUnknown(double distance, ElevationRaster* raster) {
  const std::size_t unknown = CountUnknown(raster->heights);
  if (unknown == 0) return 0;
  const GdalSession gdal;
  std::vector<std::uint8_t> is_known(raster->heights.size());
  std::transform(raster->heights.begin(), raster->heights.end(), is_known.begin(),
                 [](float h) { return std::isnan(h) ? 0 : 1; });
  const GDALDatasetUniquePtr heights = Wrap(raster->grid, GDT_Float32, raster->heights.data());
  const GDALDatasetUniquePtr mask = Wrap(raster->grid, GDT_Byte, is_known.data());
  const CPLErr filled =
      GDALFillNodata(heights->GetRasterBand(1), mask->GetRasterBand(1),
                     distance / raster->grid.cell_size.maxCoeff(), 0, 0, nullptr, nullptr, nullptr);
  if (filled != CE_None) throw InputError("unknown ground cannot be filled: " + gdal.Reason(""));
  heights->FlushCache();
  return static_cast<double>(unknown - CountUnknown(raster->heights)) /
         static_cast<double>(raster->heights.size());
}

}  // namespace dbd
