#include "plan_basis.h"

#include "file_hash.h"

namespace dbd {

std::vector<BasisItem> FilesBehind(const PlanArguments& arguments) {
  const TerrainArguments& terrain = arguments.terrain;
  std::vector<BasisItem> items;
  const auto add = [&items](const char* what, const std::string& name) {
    if (!name.empty()) items.push_back({what, name, Sha256OfFile(name)});
  };
  for (const std::string& file : terrain.dem) add("elevation", file);
  add("materials", terrain.materials);
  add("material table", terrain.material_table);
  add("obstacles", terrain.obstacles);
  add("surface model", terrain.surface_model);
  add("vehicle", arguments.vehicle);
  return items;
}

}  // namespace dbd
