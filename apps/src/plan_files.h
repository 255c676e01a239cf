#pragma once

#include "output_directory.h"
#include "plan_json.h"

namespace dbd {

/// Writes everything that `dbd plan` leaves behind: plan.json, map.png, report.html and the
/// candidates always; the route's files when there is a route. Without a coordinate system no
/// GeoJSON and GPX can be written; route.csv in local coordinates takes their place. All files or
/// none. Throws InputError.
void WritePlanFiles(const PlanRecord& record, OutputDirectory* output);

}  // namespace dbd
