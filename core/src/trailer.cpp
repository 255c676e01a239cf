#include <dbd/core/internal/json_object.h>
#include <dbd/core/trailer.h>

#include <cmath>

#include "vehicle_file.h"
#include "vehicle_file_parts.h"

namespace dbd {
namespace {

using internal::JsonObject;

DrawbarModel ReadDrawbar(const JsonObject& object) {
  DrawbarModel drawbar;
  drawbar.pivot = object.Point("pivot");
  drawbar.length = object.Number("length", 0.1, kMostLength);
  drawbar.stiffness = object.Number("stiffness", kTiny, kMostStiffness, drawbar.stiffness);
  drawbar.damping = object.Number("damping", 0, kMostStiffness, drawbar.damping);
  object.RefuseUnknownKeys();
  return drawbar;
}

Eigen::Vector3d HitchOf(const VehicleModel& towing, const TrailerModel& trailer) {
  const double above_ground = trailer.vehicle->reference_height + trailer.drawbar.pivot.z();
  return {towing.bodies[0].p_RB.x() - towing.outline.rear, 0,
          above_ground - towing.reference_height};
}

}  // namespace

TrailerModel ParseTrailer(const std::string& text, const std::string& origin) {
  const JsonObject root = JsonObject::Parse(text, origin, "dbd.trailer/1");
  TrailerModel trailer;
  trailer.vehicle = std::make_shared<const VehicleModel>(ReadVehicle(root, origin, true));
  trailer.drawbar = ReadDrawbar(root.Child("drawbar"));
  root.RefuseUnknownKeys();
  return trailer;
}

std::vector<SceneVehicle> MakeRoadTrain(const SceneVehicle& tractor, const TrailerModel& trailer,
                                        int trailers) {
  std::vector<SceneVehicle> train{tractor};
  const Eigen::Vector2d forward(std::cos(tractor.heading), std::sin(tractor.heading));
  for (int i = 0; i < trailers; ++i) {
    const SceneVehicle& towing = train.back();
    SceneVehicle next{.model = trailer.vehicle, .heading = tractor.heading, .ahead = i};
    next.drawbar = trailer.drawbar;
    next.drawbar->hitch = HitchOf(*towing.model, trailer);
    const double to_hitch = next.drawbar->hitch.x() - towing.model->path_point_x();
    const double to_pivot = trailer.drawbar.pivot.x() - trailer.vehicle->path_point_x();
    next.position = towing.position + (to_hitch - trailer.drawbar.length - to_pivot) * forward;
    train.push_back(next);
  }
  return train;
}

}  // namespace dbd
