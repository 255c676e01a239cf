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

ObstacleMap ObstaclesOf(const std::string& octomap, MapPlacement placement,
                        const TerrainFiles& files, const HeightMap& heights,
                        const LocalFrame& frame) {
  constexpr double kFloor = 0.3;
  placement.origin = frame.ToLocal(placement.origin);
  return LoadObstacles(octomap, heights, placement, kFloor, files.unknown_space);
}

// Of every source. An OctoMap that the ground comes from holds obstacles too.
ObstacleMap LoadAllObstacles(const TerrainFiles& files, const ElevationRaster& elevation,
                             const HeightMap& heights, const LocalFrame& frame,
                             std::vector<std::string>* notes) {
  const bool is_ground = IsOctreeExtension(LowerExtension(files.elevation));
  ObstacleMap obstacles;
  if (is_ground) {
    obstacles.Add(ObstaclesOf(files.elevation, files.elevation_placement, files, heights, frame));
  }
  if (!files.obstacles.empty()) {
    obstacles.Add(ObstaclesOf(files.obstacles, files.obstacles_placement, files, heights, frame));
  }
  if (!files.surface_model.empty()) {
    obstacles.Add(LoadSurfaceModel(files.surface_model, files.surface_threshold, elevation, frame));
  }
  if (is_ground || !files.obstacles.empty()) {
    notes->emplace_back(files.unknown_space == UnknownSpace::kFree
                            ? "space that the OctoMap has not seen counts as free"
                            : "space that the OctoMap has not seen counts as an obstacle");
  }
  return obstacles;
}

// Of point clouds only headers are read, see DescribeFile.
void RefusePointCloud(const std::string& file, const char* instead) {
  const std::string extension = LowerExtension(file);
  if (extension != ".las" && extension != ".laz" && extension != ".pcd") return;
  throw InputError(file + ": is a point cloud, which is not driven on; convert " + instead);
}

void CheckFormats(const TerrainFiles& files) {
  constexpr char kGround[] =
      "its ground points to XYZ text, or to a GeoTIFF of heights (PDAL and LAStools do both)";
  RefusePointCloud(files.elevation, kGround);
  for (const std::string& file : files.more_elevation) RefusePointCloud(file, kGround);
  RefusePointCloud(files.obstacles, "it to an OctoMap (.bt)");
  RefusePointCloud(files.surface_model, "its highest points to a GeoTIFF of heights");
}

}  // namespace

std::shared_ptr<const Terrain> LoadTerrain(const TerrainFiles& files,
                                           const LoadProgress& progress) {
  CheckFormats(files);
  std::vector<std::string> notes;
  TinGround ground = LoadGround(files, progress, &notes);
  LocalFrame frame = MakeFrame(ground.raster);
  HeightMap heights = MakeHeights(files, frame, &ground.raster);
  MaterialMap materials = LoadMaterials(files, ground.raster, frame, &notes);
  ObstacleMap obstacles = LoadAllObstacles(files, ground.raster, heights, frame, &notes);
  auto terrain = std::make_shared<Terrain>(std::move(frame), std::move(heights),
                                           std::move(materials), std::move(obstacles));
  terrain->set_tin(ground.tin);
  terrain->set_notes(std::move(notes));
  return terrain;
}

}  // namespace dbd
