#pragma once

#include "terrain_options.h"

namespace CLI {
class App;
}

namespace dbd {

/// Declares the flags that say which terrain is meant. `terrain` must outlive the parsing.
void AddTerrainFlags(CLI::App* command, TerrainArguments* terrain);

}  // namespace dbd
