#include <dbd/core/error.h>
#include <dbd/terrain/generator.h>

#include <cmath>
#include <sstream>

#include "synthetic_landscape.h"
#include "synthetic_obstacles.h"
#include "write_terrain.h"

namespace dbd {
namespace {

void Check(const char* field, double value, bool in_range, const std::string& rule) {
  if (in_range) return;
  std::ostringstream text;
  text << field << " is " << value << ", must be " << rule;
  throw InputError(text.str());
}

bool IsBetween(double value, double least, double most) { return value >= least && value <= most; }

}  // namespace

void GeneratorOptions::Validate() const {
  Check("size", size, IsBetween(size, 64, 8192), "64 to 8192 cells");
  Check("cell_size", cell_size, IsBetween(cell_size, 0.1, 100), "0.1 to 100 m");
  Check("relief", relief, IsBetween(relief, 0, 2000), "0 to 2000 m");
  Check("wavelength", wavelength, IsBetween(wavelength, 8 * cell_size, 1e5),
        "at least 8 cells and at most 100 km");
  Check("tree_density", tree_density, IsBetween(tree_density, 0, 1000), "0 to 1000 per hectare");
  const double extent = size * cell_size;
  if (walled_goal)
    Check("size x cell_size", extent, extent >= 100, "at least 100 m for walled_goal");
}

GeneratedTerrain GenerateTerrain(const GeneratorOptions& options, const std::string& directory) {
  options.Validate();
  const SyntheticLandscape landscape(options);
  const double extent = options.size * options.cell_size;
  const double search = 0.06 * extent;
  const Eigen::Vector2d start = landscape.FlattestPlace({0.12 * extent, 0.12 * extent}, search);
  const Eigen::Vector2d goal =
      options.walled_goal ? landscape.FlattestPlace(landscape.center(), 5.0)
                          : landscape.FlattestPlace({0.86 * extent, 0.86 * extent}, search);
  const auto obstacles = MakeObstacles(options, landscape, {start, goal});
  GeneratedTerrain terrain = WriteTerrain(landscape, *obstacles, directory);
  terrain.start = terrain.obstacles_origin + start;
  terrain.goal = terrain.obstacles_origin + goal;
  return terrain;
}

TerrainFiles FilesOf(const GeneratedTerrain& generated) {
  TerrainFiles files;
  files.elevation = generated.elevation;
  files.materials = generated.materials;
  files.material_table = generated.material_table;
  files.obstacles = generated.obstacles;
  files.obstacles_placement.origin = generated.obstacles_origin;
  return files;
}

}  // namespace dbd
