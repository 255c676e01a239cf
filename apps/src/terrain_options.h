#pragma once

#include <dbd/terrain/terrain.h>

#include <memory>
#include <string>
#include <vector>

#include "places.h"

namespace dbd {

/// The flags that say which terrain is meant, shared by all sub-commands that drive on one.
struct TerrainArguments {
  std::vector<std::string> dem;
  int band = 0;  ///< 0: the only one
  std::string crs;
  std::string unknown_ground = "forbid";
  double fill_distance_m = 50;
  double memory_gb = 4;
  std::string dem_origin;  ///< "X,Y[,YAW_DEG]" or empty: in map coordinates
  double surface_cell_m = 0;
  bool rasterise = false;
  std::string materials;
  int materials_band = 0;
  std::string material_field;
  std::string unknown_material;
  std::string material_table;
  std::string moisture;  ///< "dry", "moist", "wet" or empty: as the table states them
  std::string obstacles;
  std::string obstacles_origin;  ///< "X,Y[,YAW_DEG]" or empty: in map coordinates
  std::string unknown_space = "free";
  std::string surface_model;
  double surface_threshold_m = 0.5;
};

/// What a map must hold that is too large to be loaded whole.
struct PlacesToKeep {
  std::vector<Eigen::Vector2d> map;    ///< in the elevation's own coordinates
  std::vector<Eigen::Vector2d> wgs84;  ///< longitude, latitude [deg]

  std::vector<Eigen::Vector2d>& In(Coordinates coordinates) {
    return coordinates == Coordinates::kMap ? map : wgs84;
  }
};

/// Throws InputError when flags that belong together are given apart.
TerrainFiles MakeTerrainFiles(const TerrainArguments& arguments);

/// Checks the flags, reads the files, shows the progress and prints what is worth knowing of them.
/// Of a map that is too large for the memory the part round the places is read. Throws InputError.
std::shared_ptr<const Terrain> LoadTerrain(const TerrainArguments& arguments,
                                           const PlacesToKeep& places = {});

}  // namespace dbd
