#include <dbd/core/error.h>
#include <dbd/terrain/terrain.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "fill_unknown.h"

#include "load_elevation.h"
#include "load_materials.h"

namespace dbd {
namespace {

LocalFrame MakeFrame(const ElevationRaster& elevation) {
  const HeightMap::Grid& grid = elevation.grid;
  const Eigen::Vector2d center =
      0.5 * (grid.first_center + grid.Center(grid.columns - 1, grid.rows - 1));
  // Whole metres, so that local and map coordinates differ by a number that is easy to read.
  LocalFrame frame(elevation.map_wkt,
                   Eigen::Vector2d(std::round(center.x()), std::round(center.y())));
  frame.set_source_wkt(elevation.source_wkt);
  return frame;
}

HeightMap MakeHeights(const ElevationRaster& elevation, const LocalFrame& frame) {
  HeightMap::Grid grid = elevation.grid;
  grid.first_center = frame.ToLocal(grid.first_center);
  return HeightMap(grid, elevation.heights, elevation.base_height);
}

ObstacleMap LoadObstacleLayer(const TerrainFiles& files, const HeightMap& heights,
                              const LocalFrame& frame) {
  if (files.obstacles.empty()) return {};
  const Eigen::Vector2d zero_in_map =
      files.obstacles_in_map_coordinates ? Eigen::Vector2d::Zero() : files.obstacles_origin;
  return LoadObstacles(files.obstacles, heights, frame.ToLocal(zero_in_map));
}

RasterRequest ElevationRequest(const TerrainFiles& files) {
  RasterRequest request{{files.elevation}, files.elevation_band, files.crs};
  request.files.insert(request.files.end(), files.more_elevation.begin(),
                       files.more_elevation.end());
  return request;
}

ElevationRaster LoadGround(const TerrainFiles& files, std::vector<std::string>* notes) {
  ElevationRaster elevation = LoadElevation(ElevationRequest(files));
  if (files.unknown_ground == UnknownGround::kForbid) return elevation;
  const double share = FillUnknown(files.fill_distance, &elevation);
  char text[120];
  std::snprintf(text, sizeof text, "%.3g %% of the ground was unknown and is interpolated",
                100 * share);
  notes->emplace_back(text);
  return elevation;
}

}  // namespace

std::shared_ptr<const Terrain> LoadTerrain(const TerrainFiles& files) {
  std::vector<std::string> notes;
  const ElevationRaster elevation = LoadGround(files, &notes);
  LocalFrame frame = MakeFrame(elevation);
  HeightMap heights = MakeHeights(elevation, frame);
  MaterialMap materials = LoadMaterials(files, elevation, frame, &notes);
  ObstacleMap obstacles = LoadObstacleLayer(files, heights, frame);
  auto terrain = std::make_shared<Terrain>(std::move(frame), std::move(heights),
                                           std::move(materials), std::move(obstacles));
  terrain->set_notes(std::move(notes));
  return terrain;
}

}  // namespace dbd
