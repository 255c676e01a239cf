#include "terrain_command.h"

#include <dbd/core/error.h>
#include <dbd/terrain/terrain_info.h>

#include <cstdio>
#include <filesystem>

#include "cli.h"
#include "map_image.h"
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

/// Pictures and class rasters hold bytes or several bands; headers alone are no ground.
bool MayBeGround(const FileInfo& file) {
  if (const auto* raster = std::get_if<RasterFileInfo>(&file.content)) {
    return raster->bands == 1 && raster->data_type != "Byte" && raster->has_georeference &&
           raster->lowest;
  }
  return std::holds_alternative<MeshFileInfo>(file.content) ||
         std::holds_alternative<OctreeFileInfo>(file.content) || file.format == "XYZ";
}

/// Null when it cannot be driven on; the file's warnings then say why.
std::shared_ptr<const Terrain> LoadGround(DescribedFile* described) {
  if (!MayBeGround(described->file)) return nullptr;
  TerrainFiles files;
  files.elevation = described->name;
  std::vector<std::string>& warnings = described->file.warnings;
  try {
    auto terrain = LoadTerrain(files);
    warnings.insert(warnings.end(), terrain->notes().begin(), terrain->notes().end());
    return terrain;
  } catch (const InputError& error) {
    std::string reason = error.what();
    const std::string name = described->name + ": ";
    if (reason.rfind(name, 0) == 0) reason.erase(0, name.size());
    warnings.push_back("not loaded as ground: " + reason);
    return nullptr;
  }
}

void WritePreview(const std::string& picture, const std::string& file, const Terrain* terrain) {
  if (terrain == nullptr) {
    throw InputError("--preview: " + file + " is no ground that can be drawn");
  }
  MapContent content;
  content.title = std::filesystem::path(file).filename().string();
  content.subtitle = terrain->frame().CrsName();
  WriteMapImage(picture, *terrain, content);
}

DescribedFile Describe(const std::string& file, const std::string& picture) {
  DescribedFile described{file, DescribeFile(file), std::nullopt};
  const std::shared_ptr<const Terrain> terrain = LoadGround(&described);
  if (terrain) described.ground = DescribeTerrain(*terrain);
  if (!picture.empty()) WritePreview(picture, file, terrain.get());
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
  for (const std::string& file : arguments.files) {
    described.push_back(Describe(file, described.empty() ? arguments.preview : ""));
  }
  if (arguments.json) {
    std::fputs(TerrainInfoJson(described).c_str(), stdout);
    return kExitOk;
  }
  for (const DescribedFile& file : described) std::fputs(TerrainInfoText(file).c_str(), stdout);
  return kExitOk;
}

}  // namespace dbd
