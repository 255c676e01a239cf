#include "terrain_command.h"

#include <cstdio>

#include "cli.h"
#include "output_directory.h"

namespace dbd {

int RunTerrainGenerate(const TerrainGenerateArguments& arguments) {
  arguments.options.Validate();
  OutputDirectory output(arguments.out);
  std::filesystem::path staging;
  for (const char* name : {"dem.tif", "materials.tif", "materials.json", "obstacles.bt"}) {
    staging = output.Stage(name).parent_path();
  }
  GenerateTerrain(arguments.options, staging.string());
  output.Commit();
  const std::string out = output.path().string();
  std::printf("%s: dem.tif materials.tif materials.json obstacles.bt\n", out.c_str());
  return kExitOk;
}

int RunTerrainInfo(const TerrainInfoArguments&) { return kExitOk; }

}  // namespace dbd
