#include "file_extension.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <initializer_list>

namespace dbd {
namespace {

bool IsOneOf(const std::string& extension, std::initializer_list<const char*> names) {
  return std::find(names.begin(), names.end(), extension) != names.end();
}

}  // namespace

std::string LowerExtension(const std::string& file) {
  std::string extension = std::filesystem::path(file).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

bool IsVectorExtension(const std::string& extension) {
  return IsOneOf(extension, {".gpx", ".geojson", ".json", ".kml", ".csv", ".shp", ".gpkg", ".fgb",
                             ".gml", ".dxf"});
}

bool IsOctreeExtension(const std::string& extension) { return IsOneOf(extension, {".bt", ".ot"}); }

bool IsMeshExtension(const std::string& extension) { return IsOneOf(extension, {".ply", ".obj"}); }

}  // namespace dbd
