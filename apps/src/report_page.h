#pragma once

#include <filesystem>
#include <string>

#include "map_image.h"
#include "plan_json.h"

namespace dbd {

/// report.html: the plan as one page that needs nothing else, neither other files nor a network.
/// The map, the drive's charts and the tables answer to the pointer together. `image` is the map's
/// PNG file, drawn as `layout` says.
std::string ReportPage(const PlanRecord& record, const std::filesystem::path& image,
                       const MapLayout& layout);

}  // namespace dbd
