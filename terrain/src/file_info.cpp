#include <dbd/core/error.h>
#include <dbd/terrain/file_info.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "file_formats.h"

namespace dbd {
namespace {

std::string LowerExtension(const std::string& file) {
  std::string extension = std::filesystem::path(file).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

bool IsOneOf(const std::string& extension, std::initializer_list<const char*> names) {
  return std::find(names.begin(), names.end(), extension) != names.end();
}

bool IsUsuallyVector(const std::string& extension) {
  return IsOneOf(extension, {".gpx", ".geojson", ".json", ".kml", ".csv", ".shp", ".gpkg", ".fgb",
                             ".gml", ".dxf"});
}

}  // namespace

FileInfo DescribeFile(const std::string& file, int band) {
  std::error_code ignored;
  const bool is_virtual = file.rfind("/vsi", 0) == 0;
  if (!is_virtual && !std::filesystem::exists(file, ignored)) {
    throw InputError(file + ": no such file");
  }
  const std::string extension = LowerExtension(file);
  if (IsOneOf(extension, {".bt", ".ot", ".graph"})) return DescribeOctreeFile(file);
  if (IsOneOf(extension, {".ply", ".obj"})) return DescribeMeshFile(file);
  if (IsOneOf(extension, {".xyz", ".pcd", ".las", ".laz"})) {
    return DescribePointFile(file, extension);
  }
  return IsUsuallyVector(extension) ? DescribeVectorFile(file) : DescribeRasterFile(file, band);
}

}  // namespace dbd
