#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "map_image.h"
#include "plan_json.h"

namespace dbd {

/// What report.html shows, ready for its script: places in pixels of the map's image, quantities
/// in the units in which people read them.
nlohmann::ordered_json ReportData(const PlanRecord& record, const std::filesystem::path& image,
                                  const MapLayout& layout);

}  // namespace dbd
