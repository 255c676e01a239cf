#include <dbd/core/error.h>
#include <dbd/core/internal/json_object.h>
#include <dbd/core/units.h>
#include <dbd/core/vehicle_database.h>

#include <algorithm>
#include <cmath>

#include "axle_file.h"
#include "engine_state.h"
#include "time_steps.h"
#include "trim.h"
#include "vehicle_file.h"
#include "vehicle_file_elements.h"
#include "vehicle_file_parts.h"

namespace dbd {
namespace {

using internal::JsonObject;

void ReadRanges(const JsonObject& object, PowertrainModel& powertrain) {
  const JsonObject ratios = object.Child("transfer_ratios");
  for (const char* name : {"high", "low"}) {
    powertrain.ranges.push_back({name, ratios.Number(name, 1e-3, 100)});
  }
  ratios.RefuseUnknownKeys();
  powertrain.range = object.Text("range", "high");
  if (powertrain.range != "high" && powertrain.range != "low") {
    object.Fail("range", "is \"" + powertrain.range + "\", must be high or low");
  }
  powertrain.transfer_ratio = powertrain.ranges[powertrain.range == "low"].ratio;
}

PowertrainModel ReadPowertrain(const JsonObject& object) {
  PowertrainModel powertrain;
  const std::vector<double> c = object.Numbers("torque_polynomial_rpm", 3);
  const double rpm = ToRpm(1.0);
  powertrain.torque_polynomial = {c[0] * rpm * rpm, c[1] * rpm, c[2]};
  powertrain.min_speed = Rpm(object.Number("min_speed_rpm", 0, 1e5));
  powertrain.max_speed = Rpm(object.Number("max_speed_rpm", ToRpm(powertrain.min_speed), 1e5));
  powertrain.braking_torque = object.Number("braking_torque", 0, 1e5, 0);
  powertrain.gear_ratios = object.Numbers("gear_ratios");
  for (const double ratio : powertrain.gear_ratios) {
    if (ratio <= 0) object.Fail("gear_ratios", "must all be greater than 0");
  }
  if (powertrain.gear_ratios.empty()) object.Fail("gear_ratios", "needs at least one gear");
  // Reverse gears are about as low as the lowest forward gear.
  powertrain.reverse_ratio =
      object.Number("reverse_gear_ratio", 1e-3, 1000, powertrain.gear_ratios.front());
  if (object.Has("transfer_ratios")) {
    ReadRanges(object, powertrain);
  } else {
    powertrain.transfer_ratio = object.Number("transfer_ratio", 1e-3, 100, 1);
  }
  powertrain.final_ratio = object.Number("final_ratio", 1e-3, 1000);
  powertrain.upshift_speed = Rpm(object.Number("upshift_rpm", 0, 1e5));
  powertrain.downshift_speed = Rpm(object.Number("downshift_rpm", 0, 1e5));
  powertrain.shift_interval = object.Number("shift_interval", 0, 60, powertrain.shift_interval);
  powertrain.clutch_time = object.Number("clutch_time", 0, 60, powertrain.clutch_time);
  powertrain.efficiency = object.Number("efficiency", 0.1, 1, 1);
  if (object.Has("centre")) powertrain.centre = ReadDifferential(object.Child("centre"));
  object.RefuseUnknownKeys();
  return powertrain;
}

VehicleLimits ReadLimits(const JsonObject& object) {
  VehicleLimits limits;
  limits.max_roll = Degrees(object.Number("max_roll_deg", 1, 89));
  limits.max_pitch = Degrees(object.Number("max_pitch_deg", 1, 89));
  limits.max_slope = Degrees(object.Number("max_slope_deg", 1, 89));
  limits.max_sinkage = object.Number("max_sinkage", 1e-3, 5);
  limits.min_clearance = object.Number("min_clearance", -1, 5);
  limits.max_speed = object.Number("max_speed", 0.1, 100);
  limits.max_lateral_acceleration = object.Number("max_lateral_acceleration", 0.1, 20);
  limits.max_load_transfer = object.Number("max_load_transfer", 0.01, 1, limits.max_load_transfer);
  limits.max_absorbed_power =
      object.Number("max_absorbed_power", 0.1, 1000, limits.max_absorbed_power);
  limits.max_shock = object.Number("max_shock", 0.1, 1000, limits.max_shock);
  object.RefuseUnknownKeys();
  return limits;
}

VehicleOutline ReadOutline(const JsonObject& object, double p_RB_x) {
  VehicleOutline outline;
  outline.front = object.Number("front", -kMostLength, kMostLength) - p_RB_x;
  outline.rear = p_RB_x - object.Number("rear", -kMostLength, kMostLength);
  outline.half_width = object.Number("width", 0.05, kMostLength) / 2;
  outline.height = object.Number("height", 0.05, kMostLength);
  outline.belly_height = object.Number("belly_height", 0.005, outline.height);
  if (outline.front <= 0) object.Fail("front", "must be ahead of the centre of mass");
  if (outline.rear <= 0) object.Fail("rear", "must be behind the centre of mass");
  object.RefuseUnknownKeys();
  return outline;
}

void ReadChassis(const JsonObject& object, VehicleModel& vehicle) {
  vehicle.bodies.push_back({"chassis", object.Number("mass", kTiny, kMostMass), ReadInertia(object),
                            object.Point("center_of_mass")});
  object.RefuseUnknownKeys();
}

void ReadSteps(const JsonObject& object, StepSizes& steps) {
  steps.construction = object.Number("construction", 1e-5, 0.02, steps.construction);
  steps.spring = object.Number("spring", 1e-5, 0.05, steps.spring);
  steps.tire = object.Number("tire", 1e-5, 0.05, steps.tire);
  steps.control = object.Number("control", 1e-5, 0.1, steps.control);
  object.RefuseUnknownKeys();
}

void CheckWhole(const JsonObject& root, const VehicleModel& vehicle, bool towed) {
  if (vehicle.axles.size() < 2) root.Fail("axles", "needs at least two");
  if (vehicle.wheels.size() > kMaxWheels) {
    root.Fail("axles", "has more than " + std::to_string(kMaxWheels / 2));
  }
  bool driven = false, steered = false;
  for (const AxleModel& axle : vehicle.axles) {
    driven = driven || axle.driven;
    steered = steered || axle.steer_ratio != 0;
  }
  if (driven && towed) root.Fail("axles", "one is driven: a trailer has no powertrain");
  if (!driven && !towed) root.Fail("axles", "none is driven");
  if (!steered) root.Fail("axles", "none steers");
  if (vehicle.wheelbase() <= 0.01) root.Fail("axles", "all have the same place");
}

/// A body without links would fall off the vehicle.
void CheckBodiesAreHeld(const JsonObject& root, const VehicleModel& vehicle) {
  for (int body = 1; body < static_cast<int>(vehicle.bodies.size()); ++body) {
    const bool held = std::any_of(vehicle.links.begin(), vehicle.links.end(),
                                  [&](const LinkModel& link) { return link.body_b == body; });
    if (held) continue;
    root.Fail("axles", "nothing holds the \"" + vehicle.bodies[body].name +
                           "\": it needs links or a connection");
  }
}

}  // namespace

VehicleModel ReadVehicle(const JsonObject& root, const std::string& origin, bool towed) {
  VehicleModel vehicle;
  vehicle.name = root.Text("name");
  vehicle.description = root.Text("description", "");
  vehicle.reference_height = root.Number("reference_height", 0, kMostLength);
  ReadChassis(root.Child("chassis"), vehicle);
  for (const JsonObject& axle : root.Children("axles")) ReadAxle(axle, vehicle);
  CheckWhole(root, vehicle, towed);
  vehicle.outline = ReadOutline(root.Child("outline"), vehicle.bodies[0].p_RB.x());
  vehicle.limits = ReadLimits(root.Child("limits"));
  if (!towed) vehicle.powertrain = ReadPowertrain(root.Child("powertrain"));
  TrimWheelLoads(origin, vehicle);  // sets the heights of the axles that connections refer to
  ReadElements(root, vehicle);
  CheckBodiesAreHeld(root, vehicle);
  TrimFreeLengths(vehicle);
  vehicle.steps = ChooseStepSizes(vehicle);
  if (root.Has("steps")) ReadSteps(root.Child("steps"), vehicle.steps);
  SynchroniseSteps(vehicle.steps);
  return vehicle;
}

std::shared_ptr<const VehicleModel> ParseVehicle(const std::string& text,
                                                 const std::string& origin) {
  const JsonObject root = JsonObject::Parse(text, origin, "dbd.vehicle/1");
  auto vehicle = std::make_shared<const VehicleModel>(ReadVehicle(root, origin, false));
  root.RefuseUnknownKeys();
  return vehicle;
}

}  // namespace dbd
