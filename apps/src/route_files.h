#pragma once

#include <dbd/planner/plan_types.h>
#include <dbd/terrain/local_frame.h>

#include <string>

#include "file_writers.h"
#include "output_directory.h"

namespace dbd {

/// Stages trace.csv and the driven line: route.geojson, route.gpx, route.kml and
/// route.gpkg, or route.csv in map coordinates where the terrain has no coordinate system. They are
/// written until `writers` have been waited for; `route` and `frame` must stay until then.
void WriteRouteFiles(const Rollout& route, const std::string& name, const LocalFrame& frame,
                     OutputDirectory* output, FileWriters* writers);

}  // namespace dbd
