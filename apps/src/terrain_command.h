#pragma once

#include <dbd/terrain/generator.h>

#include <string>
#include <vector>

namespace dbd {

struct TerrainGenerateArguments {
  GeneratorOptions options;
  std::string out;
};

struct TerrainInfoArguments {
  std::vector<std::string> files;
  std::string preview;  ///< picture of the first file's ground; empty: none
  bool json = false;
};

// Both return the exit code and throw InputError.

/// Writes a synthetic landscape, all files or none, and prints how to plan on it.
int RunTerrainGenerate(const TerrainGenerateArguments& arguments);

/// Prints what the files hold.
int RunTerrainInfo(const TerrainInfoArguments& arguments);

}  // namespace dbd
