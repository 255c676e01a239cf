#pragma once

#include <functional>

#include "scene_command.h"

namespace CLI {
class App;
}

namespace dbd {

/// Declares `convoy` and `road-train` under `dbd scenario`. `arguments` must outlive the parsing;
/// `chosen` is called while parsing when one of them is named.
void DeclareScenes(CLI::App* scenario, SceneArguments* arguments,
                   const std::function<void()>& chosen);

}  // namespace dbd
