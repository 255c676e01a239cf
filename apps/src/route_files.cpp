#include "route_files.h"

#include "geojson.h"
#include "route_formats.h"
#include "text.h"
#include "trace_table.h"

namespace dbd {

void WriteRouteFiles(const Rollout& route, const std::string& name, const LocalFrame& frame,
                     OutputDirectory* output) {
  WriteTextFile(output->Stage("trace.csv"), TraceCsv(route.trace, frame));
  if (!frame.has_crs()) {
    WriteTextFile(output->Stage("route.csv"), RouteCsv(route.trace, frame));
    return;
  }
  WriteTextFile(output->Stage("route.geojson"), RouteGeoJson(route, name, frame));
  WriteGpx(output->Stage("route.gpx"), route, name, frame);
  WriteKml(output->Stage("route.kml"), route, name, frame);
  WriteGeoPackage(output->Stage("route.gpkg"), route, name, frame);
}

}  // namespace dbd
