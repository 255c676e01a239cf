#include "simulate_command.h"

#include <dbd/core/error.h>
#include <dbd/core/units.h>
#include <dbd/core/vehicle_database.h>
#include <dbd/planner/drive.h>
#include <dbd/terrain/geo_path.h>

#include <algorithm>
#include <cstdio>
#include <optional>

#include "cli.h"
#include "console.h"
#include "file_writers.h"
#include "interrupt.h"
#include "map_image.h"
#include "output_directory.h"
#include "route_files.h"
#include "simulation_json.h"
#include "summary.h"
#include "text.h"

namespace dbd {
namespace {

constexpr double kDefaultDuration = 60;  // [s]

/// The line that was asked for, as its file has it.
std::optional<GeoPath> ReadLine(const SimulateArguments& arguments) {
  if (arguments.path.empty()) return std::nullopt;
  GeoPath line = ReadGeoPath(arguments.path);
  if (line.line_count > 1) {
    PrintNote(
        Format("%s holds %d lines; driving the longest", arguments.path.c_str(), line.line_count));
  }
  return line;
}

PlacesToKeep PlacesOf(const SimulateArguments& arguments, const std::optional<GeoPath>& line) {
  PlacesToKeep places;
  if (line) {
    places.In(line->in_map_coordinates ? Coordinates::kMap : Coordinates::kWgs84) = line->points;
  }
  if (!arguments.start.empty()) {
    places.In(arguments.coordinates).push_back(ParsePlace("--start", arguments.start).xy);
  }
  return places;
}

/// The path in W; empty when none was given.
Path MakePath(const SimulateArguments& arguments, const std::optional<GeoPath>& given,
              const Terrain& terrain) {
  if (!given) return Path();
  const GeoPath& line = *given;
  const LocalFrame& frame = terrain.frame();
  if (!line.in_map_coordinates && !frame.has_crs()) {
    throw InputError("--path " + arguments.path +
                     ": is in WGS84, but the elevation file has no coordinate system");
  }
  std::vector<Eigen::Vector2d> points;
  for (const Eigen::Vector2d& point : line.points) {
    points.push_back(line.in_map_coordinates ? frame.FromSource(point) : frame.FromWgs84(point));
  }
  return Path(points);
}

/// Where the drive begins: what was typed, else the path's beginning, else the map's middle.
LocalPlace FindStart(const SimulateArguments& arguments, const Path& path, const Terrain& terrain) {
  LocalPlace start;
  if (!arguments.start.empty()) {
    start = LocatePlace("--start", ParsePlace("--start", arguments.start), arguments.coordinates,
                        terrain);
  } else if (!path.empty()) {
    start.xy = path.Position(0);
  } else {
    start.xy = (terrain.heights().min_corner() + terrain.heights().max_corner()) / 2;
  }
  if (!terrain.IsKnown(start.xy.x(), start.xy.y())) {
    throw InputError("the drive begins at " + DescribePlace(terrain.frame(), start.xy) +
                     ", which is outside the map or unknown ground (nodata)");
  }
  if (!start.yaw) start.yaw = path.empty() ? 0 : path.Heading(0);
  return start;
}

DriveOptions MakeOptions(const SimulateArguments& arguments, const Path& path) {
  DriveOptions options;
  options.target_speed = KilometersPerHour(arguments.speed_kmh);
  options.duration = arguments.duration;
  options.sinkage.multipass_exponent = arguments.multipass_exponent;
  if (options.duration <= 0) {
    options.duration = std::max(kDefaultDuration, 30 + 3 * path.length() / options.target_speed);
  }
  return options;
}

/// A drive along a path is complete at its end; one straight ahead when its time is over.
bool IsComplete(const Path& path, const Rollout& rollout) {
  return rollout.outcome == Outcome::kReached ||
         (path.empty() && rollout.outcome == Outcome::kTimedOut);
}

std::string Headline(const SimulationRecord& record) {
  if (record.completed) {
    return record.path.empty() ? "Drove straight ahead" : "Reached the end of the path";
  }
  std::string outcome = OutcomeName(record.rollout.outcome);
  std::replace(outcome.begin(), outcome.end(), '_', ' ');
  const std::string reason =
      record.rollout.reason.empty() ? "" : " (" + record.rollout.reason + ")";
  return Format("Stopped after %.0f m: %s%s at %s", record.rollout.distance, outcome.c_str(),
                reason.c_str(),
                DescribePlace(record.terrain.frame(), record.rollout.place.head<2>()).c_str());
}

MapContent SimulationMap(const SimulationRecord& record) {
  MapContent content;
  content.title = record.vehicle.name + ": " + FormatLength(record.rollout.distance) + " in " +
                  FormatDuration(record.rollout.time);
  content.subtitle = Headline(record);
  content.start = record.start;
  content.obstacle_height = record.vehicle.outline.height;
  for (const TraceSample& sample : record.rollout.trace) {
    content.route.push_back({sample.x, sample.y});
  }
  const Eigen::Vector2d end = record.rollout.place.head<2>();
  if (!record.path.empty()) {
    content.candidates.push_back({record.path.points(), record.rollout.outcome, end});
    content.goal = record.path.points().back();
  }
  if (!record.completed) content.blocked = end;
  return content;
}

void WriteFiles(const SimulationRecord& record, OutputDirectory* output) {
  if (!record.terrain.frame().has_crs()) {
    PrintNote(
        "the elevation file has no coordinate system: route.csv in its coordinates instead "
        "of GeoJSON and GPX");
  }
  FileWriters writers;
  const auto answer = output->Stage("simulate.json");
  writers.Run([&record, image = output->Stage("map.png")] {
    WriteMapImage(image, record.terrain, SimulationMap(record));
  });
  writers.WriteText(answer, [&] { return SimulationJson(record); });
  WriteRouteFiles(record.rollout, record.vehicle.name + " drive", record.terrain.frame(), output,
                  &writers);
  writers.Wait();
  output->Commit();
}

std::string Summary(const SimulationRecord& record, const OutputDirectory& output) {
  std::string text = Headline(record) + "\n";
  text += "  drive      " + DriveTotals(record.rollout) + "\n";
  const std::string limit = TightestLimit(record.rollout, record.terrain.frame());
  if (!limit.empty()) text += "  tightest   " + limit + "\n";
  return text + "  files      " + FilesWritten(output) + "\n";
}

}  // namespace

int RunSimulate(const SimulateArguments& arguments) {
  Interrupt interrupt;
  OutputDirectory output(arguments.out);
  const auto vehicle = LoadVehicle(arguments.vehicle);
  const std::optional<GeoPath> line = ReadLine(arguments);
  const auto terrain = LoadTerrain(arguments.terrain, PlacesOf(arguments, line));
  const Path path = MakePath(arguments, line, *terrain);
  const LocalPlace start = FindStart(arguments, path, *terrain);
  const Rollout rollout = DrivePath(*terrain, *vehicle, path, start.xy, *start.yaw,
                                    MakeOptions(arguments, path), interrupt.token());
  if (rollout.outcome == Outcome::kCancelled) {
    PrintError("interrupted");
    return kExitStopped;
  }
  const SimulationRecord record{arguments, *terrain,   *vehicle, path,
                                start.xy,  *start.yaw, rollout,  IsComplete(path, rollout)};
  WriteFiles(record, &output);
  const std::string answer = arguments.json ? SimulationJson(record) : Summary(record, output);
  std::fputs(answer.c_str(), stdout);
  return record.completed ? kExitOk : kExitNoSafeRoute;
}

}  // namespace dbd
