#include "terrain_command.h"

#include <dbd/core/error.h>
#include <dbd/terrain/terrain_info.h>

#include <cstdio>
#include <filesystem>

#include "cli.h"
#include "output_directory.h"
#include "summary.h"
#include "terrain_description.h"
#include "text.h"

namespace dbd {
namespace {

/// A command line that plans across the generated land, to copy.
std::string ExampleCommand(const GeneratedTerrain& terrain, const std::string& directory) {
  const auto file = [&directory](const char* name) {
    return (std::filesystem::path(directory) / name).string();
  };
  return Format(
      "dbd plan --dem %s --materials %s --material-table %s --obstacles %s "
      "--obstacles-origin %.10g,%.10g --vehicle tomcar-tm27 --start %.10g,%.10g "
      "--goal %.10g,%.10g --out %s\n",
      file("dem.tif").c_str(), file("materials.tif").c_str(), file("materials.json").c_str(),
      file("obstacles.bt").c_str(), terrain.obstacles_origin.x(), terrain.obstacles_origin.y(),
      terrain.start.x(), terrain.start.y(), terrain.goal.x(), terrain.goal.y(),
      file("plan").c_str());
}

/// Pictures and class rasters hold bytes or several bands.
bool MayBeElevation(const RasterFileInfo& raster) {
  return raster.bands == 1 && raster.data_type != "Byte" && raster.has_georeference &&
         raster.lowest;
}

DescribedFile Describe(const std::string& file) {
  DescribedFile described{file, DescribeFile(file), std::nullopt};
  const auto* raster = std::get_if<RasterFileInfo>(&described.file.content);
  if (raster == nullptr || !MayBeElevation(*raster)) return described;
  TerrainFiles files;
  files.elevation = file;
  try {
    described.ground = DescribeTerrain(*LoadTerrain(files));
  } catch (const InputError& error) {
    std::string reason = error.what();
    if (reason.rfind(file + ": ", 0) == 0) reason.erase(0, file.size() + 2);
    described.file.warnings.push_back("not loaded as ground: " + reason);
  }
  return described;
}

}  // namespace

int RunTerrainGenerate(const TerrainGenerateArguments& arguments) {
  arguments.options.Validate();
  OutputDirectory output(arguments.out);
  std::filesystem::path staging;
  for (const char* name : {"dem.tif", "materials.tif", "materials.json", "obstacles.bt"}) {
    staging = output.Stage(name).parent_path();
  }
  const GeneratedTerrain terrain = GenerateTerrain(arguments.options, staging.string());
  output.Commit();
  std::printf("%s\nPlan across it with:\n  %s", FilesWritten(output).c_str(),
              ExampleCommand(terrain, arguments.out).c_str());
  return kExitOk;
}

int RunTerrainInfo(const TerrainInfoArguments& arguments) {
  std::vector<DescribedFile> described;
  for (const std::string& file : arguments.files) described.push_back(Describe(file));
  if (arguments.json) {
    std::fputs(TerrainInfoJson(described).c_str(), stdout);
    return kExitOk;
  }
  for (const DescribedFile& file : described) std::fputs(TerrainInfoText(file).c_str(), stdout);
  return kExitOk;
}

}  // namespace dbd
