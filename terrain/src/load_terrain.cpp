#include <dbd/core/error.h>
#include <dbd/terrain/terrain.h>

#include <cstdio>
#include <utility>

#include "extract_ground.h"
#include "file_extension.h"
#include "fill_unknown.h"
#include "load_elevation.h"
#include "load_materials.h"
#include "load_surface_model.h"
#include "load_tin.h"

namespace dbd {
namespace {

LocalFrame MakeFrame(const ElevationRaster& elevation) {
  LocalFrame frame(elevation.map_wkt, OriginOf(elevation.grid));
  frame.set_source_wkt(elevation.source_wkt);
  return frame;
}

// Takes the heights, unless what stands on them is read later.
HeightMap MakeHeights(const TerrainFiles& files, const LocalFrame& frame,
                      ElevationRaster* elevation) {
  HeightMap::Grid grid = elevation->grid;
  grid.first_center = frame.ToLocal(grid.first_center);
  if (!files.surface_model.empty()) {
    return HeightMap(grid, elevation->heights, elevation->base_height);
  }
  return HeightMap(grid, std::move(elevation->heights), elevation->base_height);
}

RasterRequest ElevationRequest(const TerrainFiles& files, const LoadProgress& progress) {
  RasterRequest request;
  request.files = {files.elevation};
  request.band = files.elevation_band;
  request.crs = files.crs;
  // The other half is for materials, obstacles and the planner's layer.
  request.memory_limit = 0.5 * files.memory_limit;
  request.places = files.places;
  request.wgs84_places = files.wgs84_places;
  request.progress = progress;
  request.files.insert(request.files.end(), files.more_elevation.begin(),
                       files.more_elevation.end());
  return request;
}

bool IsTin(const std::string& extension) {
  return IsMeshExtension(extension) || extension == ".xyz";
}

// A raster of the ground, and its triangles where it is a TIN.
TinGround ReadGround(const TerrainFiles& files, const LoadProgress& progress,
                     std::vector<std::string>* notes) {
  const std::string extension = LowerExtension(files.elevation);
  const bool is_raster = !IsTin(extension) && !IsOctreeExtension(extension);
  if (!is_raster && !files.more_elevation.empty()) {
    throw InputError(files.elevation + ": only rasters can be joined with others");
  }
  if (IsTin(extension)) return LoadTin(files, notes);
  if (IsOctreeExtension(extension)) return {ExtractGround(files, notes), nullptr};
  TinGround ground{LoadElevation(ElevationRequest(files, progress)), nullptr};
  if (!ground.raster.note.empty()) notes->push_back(ground.raster.note);
  return ground;
}

TinGround LoadGround(const TerrainFiles& files, const LoadProgress& progress,
                     std::vector<std::string>* notes) {
  TinGround ground = ReadGround(files, progress, notes);
  if (files.unknown_ground == UnknownGround::kForbid) return ground;
  const double share = FillUnknown(files.fill_distance, &ground.raster);
  char text[120];
  std::snprintf(text, sizeof text, "%.3g %% of the ground was unknown and is interpolated",
                100 * share);
  notes->emplace_back(text);
  return ground;
}

// Without a file of its own, an OctoMap that the ground comes from holds the obstacles too.
ObstacleMap LoadObstacleLayer(const TerrainFiles& files, const ElevationRaster& elevation,
                              const HeightMap& heights, const LocalFrame& frame) {
  if (!files.surface_model.empty()) {
    if (!files.obstacles.empty()) {
      throw InputError(files.surface_model + ": a surface model and an OctoMap of obstacles " +
                       "cannot both be given");
    }
    return LoadSurfaceModel(files.surface_model, files.surface_threshold, elevation, frame);
  }
  const bool is_own = files.obstacles.empty() && IsOctreeExtension(LowerExtension(files.elevation));
  const std::string& file = is_own ? files.elevation : files.obstacles;
  if (file.empty()) return {};
  MapPlacement placement = is_own ? files.elevation_placement : files.obstacles_placement;
  placement.origin = frame.ToLocal(placement.origin);
  constexpr double kFloor = 0.3;
  return LoadObstacles(file, heights, placement, kFloor, files.unknown_space);
}

}  // namespace

std::shared_ptr<const Terrain> LoadTerrain(const TerrainFiles& files,
                                           const LoadProgress& progress) {
  std::vector<std::string> notes;
  TinGround ground = LoadGround(files, progress, &notes);
  LocalFrame frame = MakeFrame(ground.raster);
  HeightMap heights = MakeHeights(files, frame, &ground.raster);
  MaterialMap materials = LoadMaterials(files, ground.raster, frame, &notes);
  ObstacleMap obstacles = LoadObstacleLayer(files, ground.raster, heights, frame);
  auto terrain = std::make_shared<Terrain>(std::move(frame), std::move(heights),
                                           std::move(materials), std::move(obstacles));
  terrain->set_tin(ground.tin);
  terrain->set_notes(std::move(notes));
  return terrain;
}

}  // namespace dbd
