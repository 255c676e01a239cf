#pragma once

#include <dbd/terrain/terrain.h>

#include <memory>
#include <string>

namespace dbd {

/// The flags that say which terrain is meant, shared by all sub-commands that drive on one.
struct TerrainArguments {
  std::string dem;
  std::string materials;
  std::string material_table;
  std::string obstacles;
  std::string obstacles_origin;  ///< "X,Y" or empty: the OctoMap is in map coordinates
};

/// Throws InputError when flags that belong together are given apart.
TerrainFiles MakeTerrainFiles(const TerrainArguments& arguments);

/// Checks the flags and reads the files. Throws InputError.
std::shared_ptr<const Terrain> LoadTerrain(const TerrainArguments& arguments);

}  // namespace dbd
