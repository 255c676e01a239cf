#include "route_files.h"

#include "geojson.h"
#include "route_formats.h"
#include "trace_table.h"

namespace dbd {

void WriteRouteFiles(const Rollout& route, const std::string& name, const LocalFrame& frame,
                     OutputDirectory* output, FileWriters* writers) {
  writers->WriteText(output->Stage("trace.csv"), [&] { return TraceCsv(route.trace, frame); });
  if (!frame.has_crs()) {
    writers->WriteText(output->Stage("route.csv"), [&] { return RouteCsv(route.trace, frame); });
    return;
  }
  writers->WriteText(output->Stage("route.geojson"),
                     [&, name] { return RouteGeoJson(route, name, frame); });
  const auto write = [&](const char* file, auto* format) {
    writers->Run([&route, &frame, name, format, path = output->Stage(file)] {
      format(path, route, name, frame);
    });
  };
  write("route.gpx", &WriteGpx);
  write("route.kml", &WriteKml);
  write("route.gpkg", &WriteGeoPackage);
}

}  // namespace dbd
