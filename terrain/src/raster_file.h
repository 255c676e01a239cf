#pragma once

#include <dbd/terrain/terrain.h>
#include <gdal_priv.h>

#include <cstddef>
#include <string>
#include <vector>

#include "gdal_session.h"

namespace dbd {

/// Opens any raster that GDAL reads. Throws InputError that names the file and what is wrong.
GDALDatasetUniquePtr OpenRaster(const std::string& name);

/// Which raster is meant.
struct RasterRequest {
  std::vector<std::string> files;  ///< several of one coordinate system are joined; later ones win
  int band = 0;                    ///< counted from 1; 0: the only one
  std::string crs;                 ///< instead of the file's own; empty: the file's own
  double memory_limit = 4.0 * 1024 * 1024 * 1024;  ///< for the heights [bytes]
  std::vector<Eigen::Vector2d> places;        ///< to cut a larger raster round; see TerrainFiles
  std::vector<Eigen::Vector2d> wgs84_places;  ///< "
  LoadProgress progress;                      ///< may be empty
};

/// A raster that was opened and can be used: one band of real numbers with a place on the map,
/// not rotated.
class RasterFile {
 public:
  /// Throws InputError that names the file and what is wrong with it.
  explicit RasterFile(const RasterRequest& request);

  const std::string& name() const { return name_; }
  GDALDataset* dataset() const { return dataset_.get(); }
  GDALRasterBand* band() const { return dataset_->GetRasterBand(band_number_); }
  int band_number() const { return band_number_; }

  /// Cells as the file has them, row 0 south, in the file's coordinates.
  HeightMap::Grid Grid() const;
  /// Rows of the file run from south to north.
  bool is_south_up() const { return transform_[5] > 0; }

  /// How stored values become heights: meters = scale * value + offset. The unit is the band's, or
  /// that of the vertical coordinate system, or metres.
  double height_scale() const { return height_scale_; }
  double height_offset() const { return height_offset_; }

  /// Coordinate system without its vertical part; null when the file has none.
  const OGRSpatialReference* crs() const { return has_crs_ ? &crs_ : nullptr; }

  /// From now on the raster is this window of itself, counted in cells of the file.
  void CutTo(int column, int row, int columns, int rows);

  /// Throws InputError with the file's name.
  [[noreturn]] void Fail(const std::string& what) const;

 private:
  void ChooseBand(int requested);
  void ReadTransform();
  void ReadCrs(const std::string& instead);
  void ReadHeightScale(const RasterRequest& request);

  std::string name_;
  GDALDatasetUniquePtr whole_;  // what dataset_ is a window of; null when it is whole
  GDALDatasetUniquePtr dataset_;
  double transform_[6] = {};
  OGRSpatialReference crs_;
  bool has_crs_ = false;
  int band_number_ = 1;
  double height_scale_ = 1;
  double height_offset_ = 0;
};

/// Throws InputError with `name` when the cells at `bytes_per_cell` exceed `limit` bytes.
void CheckMemoryNeed(const std::string& name, int columns, int rows, std::size_t bytes_per_cell,
                     double limit);

/// Height of the top edge to the south edge turned round: grid of a north-up or south-up
/// geotransform (`transform`: six numbers as GDAL gives them), row 0 south.
HeightMap::Grid GridOfTransform(const double* transform, int columns, int rows);

/// Band `number`, counted from 1, of real numbers. Throws InputError with `name`.
GDALRasterBand* BandOf(const std::string& name, GDALDataset* dataset, int number);

/// "WGS 84 / UTM zone 33N (EPSG:32633)", or its name alone when it has no code.
std::string CrsNameOf(const OGRSpatialReference& crs);

std::string WktOf(const OGRSpatialReference& crs);

}  // namespace dbd
