#pragma once

#include <dbd/planner/plan_types.h>
#include <dbd/terrain/local_frame.h>

#include <string>

#include "output_directory.h"

namespace dbd {

/// Stages trace.csv and the driven line: route.geojson, route.gpx, route.kml and
/// route.gpkg, or route.csv in map coordinates where the terrain has no coordinate system. Throws
/// InputError.
void WriteRouteFiles(const Rollout& route, const std::string& name, const LocalFrame& frame,
                     OutputDirectory* output);

}  // namespace dbd
