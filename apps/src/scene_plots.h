#pragma once

#include <dbd/core/scene_scenario.h>

#include <string>
#include <vector>

#include "gnuplot.h"
#include "output_directory.h"

namespace dbd {

/// Writes `scene.png` and `scene.svg`, with data and script: speeds, gaps and, where there are any,
/// drawbar forces of the first vehicles against time. Throws InputError when gnuplot fails.
void WriteScenePlots(const std::string& title, const std::vector<SceneRow>& rows,
                     const Gnuplot& gnuplot, OutputDirectory* output);

/// All files that it may write.
std::vector<std::string> ScenePlotFiles();

}  // namespace dbd
