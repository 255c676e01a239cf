#include "simulation_json.h"

#include <nlohmann/json.hpp>

#include "json_parts.h"

namespace dbd {
namespace {

using nlohmann::ordered_json;

ordered_json RequestJson(const SimulationRecord& record) {
  const SimulateArguments& arguments = record.arguments;
  const LocalFrame& frame = record.terrain.frame();
  ordered_json start = PlaceJson(frame, record.start);
  start["heading_deg"] = Rounded(CompassDegrees(record.yaw), 3);
  return {{"dem", arguments.terrain.dem},
          {"materials", arguments.terrain.materials},
          {"obstacles", arguments.terrain.obstacles},
          {"map_crs", frame.CrsName()},
          {"vehicle", record.vehicle.name},
          {"path", arguments.path},
          {"path_length", Rounded(record.path.length(), 3)},
          {"start", std::move(start)},
          {"speed_kmh", arguments.speed_kmh}};
}

}  // namespace

std::string SimulationJson(const SimulationRecord& record) {
  const LocalFrame& frame = record.terrain.frame();
  ordered_json document = {{"schema", "dbd.simulation/1"}, {"completed", record.completed}};
  document.update(RolloutJson(record.rollout, frame));
  document["request"] = RequestJson(record);
  document["certificate"] = CertificateJson(record.rollout, frame);
  document["versions"] = VersionsJson();
  return JsonText(document);
}

}  // namespace dbd
