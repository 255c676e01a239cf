#pragma once

#include <dbd/core/ground.h>

#include <memory>
#include <string>

namespace dbd {

/// The ground of `--terrain`: a CSV grid (see ReadGridGround) or an elevation raster. Throws
/// InputError that names the file.
std::shared_ptr<const Ground> LoadScenarioGround(const std::string& file);

}  // namespace dbd
