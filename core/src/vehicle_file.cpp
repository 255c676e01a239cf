#include <dbd/core/error.h>
#include <dbd/core/internal/json_object.h>
#include <dbd/core/terramechanics.h>
#include <dbd/core/units.h>
#include <dbd/core/vehicle_database.h>

#include <cmath>

#include "engine_state.h"
#include "suspension.h"
#include "time_steps.h"
#include "trim.h"

namespace dbd {
namespace {

using internal::JsonObject;

constexpr double kMostMass = 1e5;       // [kg]
constexpr double kMostLength = 50;      // [m]
constexpr double kMostStiffness = 1e9;  // [N/m]
constexpr double kTiny = 1e-6;          // stands for "greater than zero"

Eigen::Vector3d ReadInertia(const JsonObject& object) {
  const Eigen::Vector3d inertia = object.Point("inertia");
  const double sum = inertia.sum();
  if (inertia.minCoeff() <= 0) object.Fail("inertia", "must be positive in all three axes");
  if (inertia.maxCoeff() > sum - inertia.maxCoeff() + 1e-9) {
    object.Fail("inertia", "one moment is larger than the sum of the others: no body is like that");
  }
  return inertia;
}

StiffnessDamping ReadRate(const JsonObject& object) {
  return {object.Number("stiffness", kTiny, kMostStiffness),
          object.Number("damping", 0, kMostStiffness)};
}

StiffnessDamping ReadOwnRate(const JsonObject& parent, const std::string& key) {
  const JsonObject object = parent.Child(key);
  const StiffnessDamping rate = ReadRate(object);
  object.RefuseUnknownKeys();
  return rate;
}

SpringLayout ReadSpring(const JsonObject& object) {
  SpringLayout spring;
  spring.mount = object.Point("mount");
  spring.pivot = object.Point("pivot");
  spring.hub_point = object.Point("hub_point");
  spring.lever = object.Number("lever", 0.05, 1.5);
  spring.rate = ReadRate(object);
  if (object.Has("free_length")) {
    spring.free_length = object.Number("free_length", kTiny, kMostLength);
  }
  object.RefuseUnknownKeys();
  return spring;
}

void AddArmLinks(const JsonObject& object, const std::string& name, const Eigen::Vector3d& ball,
                 IndependentSuspension& suspension) {
  const JsonObject arm = object.Child(name);
  suspension.links.push_back({name + " front", arm.Point("front"), ball});
  suspension.links.push_back({name + " rear", arm.Point("rear"), ball});
  arm.RefuseUnknownKeys();
}

void AddTrailingLinks(const JsonObject& object, const Eigen::Vector3d& lower,
                      const Eigen::Vector3d& upper, IndependentSuspension& suspension) {
  const std::vector<Eigen::Vector3d> pivots = object.Points("pivots", 2);
  const char* names[] = {"outer", "inner"};
  for (std::size_t i = 0; i < pivots.size(); ++i) {
    suspension.links.push_back({std::string(names[i]) + " lower", pivots[i], lower});
    suspension.links.push_back({std::string(names[i]) + " upper", pivots[i], upper});
  }
}

IndependentSuspension ReadSuspension(const JsonObject& object) {
  IndependentSuspension suspension;
  const std::string type = object.Text("type");
  const JsonObject carrier = object.Child("carrier");
  suspension.carrier_mass = carrier.Number("mass", kTiny, kMostMass);
  suspension.carrier_inertia = ReadInertia(carrier);
  carrier.RefuseUnknownKeys();
  const Eigen::Vector3d lower = object.Point("lower_ball");
  const Eigen::Vector3d upper = object.Point("upper_ball");
  if (type == "double_wishbone") {
    AddArmLinks(object, "lower_arm", lower, suspension);
    AddArmLinks(object, "upper_arm", upper, suspension);
  } else if (type == "trailing_arm") {
    AddTrailingLinks(object, lower, upper, suspension);
  } else {
    object.Fail("type", "is \"" + type + "\", must be double_wishbone or trailing_arm");
  }
  suspension.link_rate = ReadOwnRate(object, "links");
  suspension.spring = ReadSpring(object.Child("spring"));
  suspension.toe = ReadOwnRate(object, "toe");
  if (object.Has("camber")) suspension.camber = ReadOwnRate(object, "camber");
  object.RefuseUnknownKeys();
  return suspension;
}

BrixiusCoefficients ReadBrixius(const JsonObject& object) {
  BrixiusCoefficients c;
  c.traction_max = object.Number("traction_max", 0.01, 2, c.traction_max);
  c.mobility_rate = object.Number("mobility_rate", 1e-3, 10, c.mobility_rate);
  c.slip_rate = object.Number("slip_rate", 0.1, 100, c.slip_rate);
  c.carcass_loss = object.Number("carcass_loss", 0, 1, c.carcass_loss);
  c.resistance_mobility = object.Number("resistance_mobility", 0, 10, c.resistance_mobility);
  c.resistance_slip = object.Number("resistance_slip", 0, 10, c.resistance_slip);
  object.RefuseUnknownKeys();
  return c;
}

TireModel ReadTire(const JsonObject& object) {
  TireModel tire;
  tire.radius = object.Number("radius", 0.02, 5);
  tire.width = object.Number("width", 0.01, 3);
  tire.section_height = object.Number("section_height", 0.005, tire.radius);
  tire.rim_diameter = Inches(object.Number("rim_diameter_in", 0.5, 200));
  tire.pressure = Psi(object.Number("pressure_psi", 0.5, 200));
  const std::string type = object.Text("type", "radial");
  if (type != "radial" && type != "bias") {
    object.Fail("type", "is \"" + type + "\", must be radial or bias");
  }
  tire.stiffness =
      object.Number("stiffness", 100, kMostStiffness,
                    LinesMurphyStiffness(tire.rim_diameter, tire.width, tire.pressure));
  tire.damping = object.Number("damping", 0, kMostStiffness);
  tire.lateral_limit = object.Number("lateral_limit", 0.01, 2, tire.lateral_limit);
  tire.lateral_rate = object.Number("lateral_rate", 0.1, 100, tire.lateral_rate);
  tire.relaxation_length = object.Number("relaxation_length", 0.01, 5, tire.relaxation_length);
  tire.points = object.Has("points") ? object.Integer("points", 12, 64) : tire.points;
  if (object.Has("brixius")) tire.traction = ReadBrixius(object.Child("brixius"));
  object.RefuseUnknownKeys();
  return tire;
}

WheelModel ReadWheel(const JsonObject& object) {
  WheelModel wheel;
  wheel.spin_inertia = object.Number("spin_inertia", 1e-4, kMostMass);
  wheel.gyroscopic_inertia =
      object.Number("gyroscopic_inertia", 0, wheel.spin_inertia, wheel.spin_inertia);
  wheel.brake_torque = object.Number("brake_torque", 0, 1e6);
  object.RefuseUnknownKeys();
  return wheel;
}

DifferentialModel ReadDifferential(const JsonObject& object) {
  DifferentialModel differential;
  const std::string type = object.Text("type");
  if (type == "locked") {
    differential.type = DifferentialType::kLocked;
  } else if (type == "limited_slip") {
    differential.type = DifferentialType::kLimitedSlip;
    differential.bias_torque = object.Number("bias_torque", 0, 1e6);
  } else if (type != "open") {
    object.Fail("type", "is \"" + type + "\", must be open, limited_slip or locked");
  }
  object.RefuseUnknownKeys();
  return differential;
}

void ReadAxle(const JsonObject& object, VehicleModel& vehicle) {
  AxleModel axle;
  axle.name = object.Text("name");
  const std::vector<double> center = object.Numbers("center", 2);
  if (center[1] <= 0) object.Fail("center", "must be the left wheel's: y greater than 0");
  axle.x = center[0];
  axle.track = 2 * center[1];
  axle.driven = object.Flag("driven", false);
  axle.steer_ratio = object.Number("steer_ratio", -1, 1, 0);
  if (axle.steer_ratio != 0) axle.max_steer = Degrees(object.Number("max_steer_deg", 1, 60));
  if (object.Has("differential"))
    axle.differential = ReadDifferential(object.Child("differential"));
  const IndependentSuspension suspension = ReadSuspension(object.Child("suspension"));
  WheelModel wheel = ReadWheel(object.Child("wheel"));
  wheel.tire = ReadTire(object.Child("tire"));
  object.RefuseUnknownKeys();
  vehicle.axles.push_back(axle);
  AddIndependentAxle(suspension, {center[0], center[1], 0}, wheel, vehicle);
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
  powertrain.transfer_ratio = object.Number("transfer_ratio", 1e-3, 100, 1);
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

void CheckWhole(const JsonObject& root, const VehicleModel& vehicle) {
  if (vehicle.axles.size() < 2) root.Fail("axles", "needs at least two");
  if (vehicle.wheels.size() > kMaxWheels) {
    root.Fail("axles", "has more than " + std::to_string(kMaxWheels / 2));
  }
  bool driven = false, steered = false;
  for (const AxleModel& axle : vehicle.axles) {
    driven = driven || axle.driven;
    steered = steered || axle.steer_ratio != 0;
  }
  if (!driven) root.Fail("axles", "none is driven");
  if (!steered) root.Fail("axles", "none steers");
  if (vehicle.wheelbase() <= 0.01) root.Fail("axles", "all have the same place");
}

}  // namespace

std::shared_ptr<const VehicleModel> ParseVehicle(const std::string& text,
                                                 const std::string& origin) {
  const JsonObject root = JsonObject::Parse(text, origin, "dbd.vehicle/1");
  auto vehicle = std::make_shared<VehicleModel>();
  vehicle->name = root.Text("name");
  vehicle->description = root.Text("description", "");
  vehicle->reference_height = root.Number("reference_height", 0, kMostLength);
  ReadChassis(root.Child("chassis"), *vehicle);
  for (const JsonObject& axle : root.Children("axles")) ReadAxle(axle, *vehicle);
  CheckWhole(root, *vehicle);
  vehicle->outline = ReadOutline(root.Child("outline"), vehicle->bodies[0].p_RB.x());
  vehicle->limits = ReadLimits(root.Child("limits"));
  vehicle->powertrain = ReadPowertrain(root.Child("powertrain"));
  TrimWheelLoads(*vehicle);
  TrimFreeLengths(*vehicle);
  vehicle->steps = ChooseStepSizes(*vehicle);
  if (root.Has("steps")) ReadSteps(root.Child("steps"), vehicle->steps);
  root.RefuseUnknownKeys();
  SynchroniseSteps(vehicle->steps);
  return vehicle;
}

}  // namespace dbd
