#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace dbd {

/// A box in a file's own coordinates; `low` above `high` when it holds nothing.
struct FileExtent {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(1e300);
  Eigen::Vector3d high = Eigen::Vector3d::Constant(-1e300);

  bool empty() const { return !(low.x() <= high.x()); }
  void Add(const Eigen::Vector3d& point) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
};

/// A raster as its file states it; values of the band that was asked for.
struct RasterFileInfo {
  int columns = 0;
  int rows = 0;
  int bands = 0;
  std::string data_type;  ///< GDAL's name: Byte, Int16, Float32, ...
  bool has_georeference = false;
  /// Signed as in the file: y is negative where rows run from north to south. In `unit`.
  Eigen::Vector2d cell_size = Eigen::Vector2d::Zero();
  std::string unit;                      ///< of the cell size: metre, degree, US survey foot, ...
  std::string crs_name;                  ///< empty when there is none
  std::optional<double> nodata;          ///< as declared
  std::optional<double> lowest;          ///< after scale and offset; none when every cell is nodata
  std::optional<double> highest;         ///< "
  double nodata_share = 0;               ///< of the cells [-]
  std::vector<std::int64_t> classes;     ///< the different values, of integers when at most 64
  std::size_t memory_bytes_to_load = 0;  ///< what loading it as elevation takes at its peak
};

/// Points, lines or areas.
struct VectorFileInfo {
  struct Layer {
    std::string name;
    std::string geometry;  ///< Point, Line String, Polygon, ...
    std::int64_t features = 0;
    FileExtent extent;  ///< longitude or easting first
    std::string crs_name;
  };
  std::vector<Layer> layers;  ///< those that hold features
};

struct OctreeFileInfo {
  double resolution = 0;  ///< [m]
  std::size_t occupied_leaves = 0;
  std::size_t free_leaves = 0;
  FileExtent extent;  ///< of all leaves
};

struct MeshFileInfo {
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  FileExtent extent;
};

struct PointFileInfo {
  std::size_t points = 0;
  FileExtent extent;  ///< empty when the format states none and the points cannot be read
};

/// What a file holds, nothing converted.
struct FileInfo {
  std::string format;  ///< GTiff, GPX, OctoMap, PLY, ...
  std::variant<RasterFileInfo, VectorFileInfo, OctreeFileInfo, MeshFileInfo, PointFileInfo> content;
  std::vector<std::string> warnings;
};

/// Reads a raster (every cell of its first band, or of `band` counted from 1), a vector file, an
/// OctoMap (.bt, .ot), a mesh (.ply, .obj) or points (.xyz, .pcd, .las, .laz: the last three from
/// their header). Throws InputError that names the file and what is wrong with it.
FileInfo DescribeFile(const std::string& file, int band = 0);

}  // namespace dbd
