#include "warp_raster.h"

#include <dbd/core/error.h>
#include <dbd/core/units.h>
#include <gdal_priv.h>
#include <gdal_utils.h>
#include <ogr_spatialref.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "gdal_session.h"
#include "raster_file.h"

namespace dbd {
namespace {

constexpr double kScaleTolerance = 0.02;

Eigen::Vector2d CenterOf(const HeightMap::Grid& grid) {
  return 0.5 * (grid.first_center + grid.Center(grid.columns - 1, grid.rows - 1));
}

OGRSpatialReference Epsg(int code) {
  OGRSpatialReference crs;
  crs.importFromEPSG(code);
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return crs;
}

// Longitude and latitude [deg].
std::optional<Eigen::Vector2d> ToWgs84(const OGRSpatialReference& crs, Eigen::Vector2d place) {
  const OGRSpatialReference wgs84 = Epsg(4326);
  const std::unique_ptr<OGRCoordinateTransformation> transformation(
      OGRCreateCoordinateTransformation(&crs, &wgs84));
  if (!transformation || !transformation->Transform(1, &place.x(), &place.y())) return {};
  if (!place.allFinite()) return {};
  return place;
}

// Distance on the ellipsoid of two near places, longitude and latitude [deg].
double GroundDistance(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  constexpr double kEquatorialRadius = 6378137.0;
  constexpr double kEccentricitySquared = 6.69437999e-3;
  const double latitude = Degrees(0.5 * (a.y() + b.y()));
  const double squeeze = 1 - kEccentricitySquared * std::pow(std::sin(latitude), 2);
  const double prime_vertical = kEquatorialRadius / std::sqrt(squeeze);
  const double meridian = prime_vertical * (1 - kEccentricitySquared) / squeeze;
  return std::hypot(prime_vertical * std::cos(latitude) * Degrees(b.x() - a.x()),
                    meridian * Degrees(b.y() - a.y()));
}

bool IsTrueToScale(const OGRSpatialReference& crs, const Eigen::Vector2d& center) {
  constexpr double kStep = 100.0;
  const auto here = ToWgs84(crs, center);
  for (const Eigen::Vector2d& direction : {Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 1)}) {
    const auto there = ToWgs84(crs, center + kStep * direction);
    if (!here || !there) return true;
    if (std::abs(GroundDistance(*here, *there) / kStep - 1) > kScaleTolerance) return false;
  }
  return true;
}

int UtmEpsgCode(const Eigen::Vector2d& lon_lat) {
  const bool north = lon_lat.y() >= 0;
  if (lon_lat.y() > 84 || lon_lat.y() < -80) return north ? 32661 : 32761;
  const double longitude = lon_lat.x() - 360.0 * std::floor((lon_lat.x() + 180.0) / 360.0);
  const int zone = std::min(60, 1 + static_cast<int>(std::floor((longitude + 180.0) / 6.0)));
  return (north ? 32600 : 32700) + zone;
}

GDALDatasetUniquePtr ToDataset(const ElevationRaster& raster) {
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("MEM");
  const HeightMap::Grid& grid = raster.grid;
  GDALDatasetUniquePtr dataset(
      driver->Create("", grid.columns, grid.rows, 1, GDT_Float32, nullptr));
  if (!dataset) return dataset;
  const Eigen::Vector2d corner = grid.first_center - 0.5 * grid.cell_size;
  double transform[6] = {corner.x(), grid.cell_size.x(), 0, corner.y(), 0, grid.cell_size.y()};
  dataset->SetGeoTransform(transform);
  OGRSpatialReference crs;
  crs.importFromWkt(raster.source_wkt.c_str());
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  dataset->SetSpatialRef(&crs);
  GDALRasterBand* band = dataset->GetRasterBand(1);
  band->SetNoDataValue(std::numeric_limits<double>::quiet_NaN());
  const CPLErr written = band->RasterIO(GF_Write, 0, 0, grid.columns, grid.rows,
                                        const_cast<float*>(raster.heights.data()), grid.columns,
                                        grid.rows, GDT_Float32, 0, 0, nullptr);
  return written == CE_None ? std::move(dataset) : nullptr;
}

GDALDatasetUniquePtr Warp(GDALDataset* source, int epsg) {
  const std::string target = "EPSG:" + std::to_string(epsg);
  std::array<const char*, 13> arguments = {"-of", "VRT",   "-t_srs",     target.c_str(),
                                           "-r",  "cubic", "-dstnodata", "nan",
                                           "-et", "0.01",  nullptr};
  const std::unique_ptr<GDALWarpAppOptions, decltype(&GDALWarpAppOptionsFree)> options(
      GDALWarpAppOptionsNew(const_cast<char**>(arguments.data()), nullptr),
      &GDALWarpAppOptionsFree);
  GDALDatasetH input = GDALDataset::ToHandle(source);
  return GDALDatasetUniquePtr(
      GDALDataset::FromHandle(GDALWarp("", nullptr, 1, &input, options.get(), nullptr)));
}

// The warped file has its north row first.
void ReadFlipped(const std::string& name, GDALDataset* dataset, ElevationRaster* raster) {
  const GdalSession gdal;
  const HeightMap::Grid& grid = raster->grid;
  raster->heights.assign(grid.CellCount(), std::numeric_limits<float>::quiet_NaN());
  for (int row = 0; row < grid.rows; ++row) {
    float* line =
        raster->heights.data() + static_cast<std::size_t>(grid.rows - 1 - row) * grid.columns;
    if (dataset->GetRasterBand(1)->RasterIO(GF_Read, 0, row, grid.columns, 1, line, grid.columns, 1,
                                            GDT_Float32, 0, 0, nullptr) != CE_None) {
      throw InputError(name + ": cannot be warped to UTM: " + gdal.Reason("read error"));
    }
  }
}

}  // namespace

bool NeedsWarp(const OGRSpatialReference& crs, const HeightMap::Grid& grid) {
  const GdalSession gdal;
  if (!crs.IsProjected()) return true;
  if (std::abs(crs.GetLinearUnits() - 1.0) > 1e-9) return true;
  return !IsTrueToScale(crs, CenterOf(grid));
}

void WarpToUtm(const std::string& name, std::size_t bytes_per_cell, double memory_limit,
               ElevationRaster* raster) {
  const GdalSession gdal;
  OGRSpatialReference source_crs;
  source_crs.importFromWkt(raster->source_wkt.c_str());
  source_crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const auto center = ToWgs84(source_crs, CenterOf(raster->grid));
  if (!center || std::abs(center->y()) > 90) {
    throw InputError(name + ": the place of its centre on Earth is not known: " +
                     gdal.Reason("its coordinates lie beyond its coordinate system"));
  }
  const int epsg = UtmEpsgCode(*center);
  const GDALDatasetUniquePtr source = ToDataset(*raster);
  const GDALDatasetUniquePtr warped = source ? Warp(source.get(), epsg) : nullptr;
  double transform[6];
  if (!warped || warped->GetGeoTransform(transform) != CE_None) {
    throw InputError(name + ": cannot be warped to UTM: " + gdal.Reason("no reason given"));
  }
  CheckMemoryNeed(name, warped->GetRasterXSize(), warped->GetRasterYSize(), bytes_per_cell,
                  2 * memory_limit);
  raster->grid = GridOfTransform(transform, warped->GetRasterXSize(), warped->GetRasterYSize());
  raster->map_wkt = WktOf(Epsg(epsg));
  ReadFlipped(name, warped.get(), raster);
}

}  // namespace dbd
