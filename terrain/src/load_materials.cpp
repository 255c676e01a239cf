#include "load_materials.h"

#include <dbd/core/error.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <unordered_map>
#include <utility>

#include "load_classes.h"
#include "load_polygons.h"

namespace dbd {
namespace {

constexpr const char* kDefaultTable = "basic";

// A class that the table lacks, and the first cell that has it.
using UnknownCodes = std::map<std::int32_t, std::size_t>;

[[noreturn]] void FailUnknownCodes(const std::string& file, const HeightMap::Grid& map_grid,
                                   const UnknownCodes& codes, const MaterialTable& table) {
  const auto& [code, cell] = *codes.begin();
  const Eigen::Vector2d place = map_grid.Center(static_cast<int>(cell % map_grid.columns),
                                                static_cast<int>(cell / map_grid.columns));
  char text[200];
  std::snprintf(text, sizeof text, ": class %d at %.1f, %.1f is not in the material table '%s'",
                code, place.x(), place.y(), table.name().c_str());
  std::string others;
  for (auto other = std::next(codes.begin()); other != codes.end(); ++other) {
    others += (others.empty() ? "; nor are " : ", ") + std::to_string(other->first);
  }
  throw InputError(file + text + others);
}

struct Lookup {
  std::unordered_map<std::int32_t, std::uint8_t> index_of;
  std::uint8_t otherwise = MaterialMap::kNone;
  bool refuses_unknown = true;
};

Lookup MakeLookup(const MaterialTable& table, const std::string& unknown_material) {
  Lookup lookup;
  for (std::size_t i = 0; i < table.materials().size(); ++i) {
    lookup.index_of[table.materials()[i].code] = static_cast<std::uint8_t>(i);
  }
  if (!unknown_material.empty()) {
    lookup.otherwise = lookup.index_of[table.GetName(unknown_material).code];
    lookup.refuses_unknown = false;
  }
  return lookup;
}

std::vector<std::uint8_t> ToIndices(const TerrainFiles& files, const HeightMap::Grid& map_grid,
                                    const std::vector<std::int32_t>& classes,
                                    const MaterialTable& table, std::vector<std::string>* notes) {
  const Lookup lookup = MakeLookup(table, files.unknown_material);
  std::vector<std::uint8_t> indices(classes.size(), lookup.otherwise);
  UnknownCodes unknown;
  std::size_t replaced = 0;
  for (std::size_t i = 0; i < classes.size(); ++i) {
    const auto known = lookup.index_of.find(classes[i]);
    if (known != lookup.index_of.end()) {
      indices[i] = known->second;
    } else {
      ++replaced;
      if (classes[i] != kNoClass) unknown.emplace(classes[i], i);
    }
  }
  if (lookup.refuses_unknown && !unknown.empty()) {
    FailUnknownCodes(files.materials, map_grid, unknown, table);
  }
  if (!lookup.refuses_unknown && replaced > 0) {
    char text[160];
    std::snprintf(text, sizeof text, "%.3g %% of the ground has no known class and is taken for %s",
                  100.0 * static_cast<double>(replaced) / static_cast<double>(classes.size()),
                  files.unknown_material.substr(0, 60).c_str());
    notes->emplace_back(text);
  }
  return indices;
}

}  // namespace

MaterialMap LoadMaterials(const TerrainFiles& files, const ElevationRaster& elevation,
                          const LocalFrame& frame, std::vector<std::string>* notes) {
  MaterialTable table =
      MaterialTable::Load(files.material_table.empty() ? kDefaultTable : files.material_table);
  if (files.moisture) table = table.InState(*files.moisture);
  if (files.materials.empty()) return MaterialMap(table.GetName(files.default_material));
  RasterRequest request;
  request.files = {files.materials};
  request.band = files.materials_band;
  const std::vector<std::int32_t> classes =
      IsPolygonFile(files.materials) ? LoadPolygons(files.materials, files.material_field, table,
                                                    elevation.grid, elevation.map_wkt)
                                     : LoadClasses(request, elevation.grid, elevation.map_wkt);
  std::vector<std::uint8_t> indices = ToIndices(files, elevation.grid, classes, table, notes);
  HeightMap::Grid grid = elevation.grid;
  grid.first_center = frame.ToLocal(grid.first_center);
  return MaterialMap(std::move(table), grid, std::move(indices));
}

}  // namespace dbd
