#include "axle_file.h"

#include <dbd/core/error.h>
#include <dbd/core/terramechanics.h>
#include <dbd/core/units.h>

#include "curve.h"
#include "solid_axle.h"
#include "suspension.h"
#include "vehicle_file_parts.h"

namespace dbd {
namespace {

using internal::JsonObject;

CurveModel ReadCurve(const JsonObject& parent, const std::string& key, const std::string& x,
                     const std::string& y) {
  const JsonObject object = parent.Child(key);
  const std::vector<double> at = object.Numbers(x), value = object.Numbers(y);
  object.RefuseUnknownKeys();
  try {
    return MakeCurve(at, value);
  } catch (const InputError& error) {
    parent.Fail(key, error.what());
  }
}

BumpStopModel ReadBumpStop(const JsonObject& object) {
  BumpStopModel stop;
  stop.travel_compression = object.Number("travel_compression", 0, kMostLength);
  stop.travel_extension = object.Number("travel_extension", 0, kMostLength);
  stop.stiffness = object.Number("stiffness", kTiny, kMostStiffness);
  stop.progression = object.Number("progression", 0, kMostLength, 0);
  stop.damping = object.Number("damping", 0, kMostStiffness, 0);
  object.RefuseUnknownKeys();
  return stop;
}

/// Spring, damper and stops along the strut, linear or by curves.
void ReadStrut(const JsonObject& object, SpringLayout& spring) {
  if (object.Has("curve")) {
    spring.force_curve = ReadCurve(object, "curve", "deflection", "force");
    spring.rate.stiffness = SteepestSlope(spring.force_curve);
  } else {
    spring.rate.stiffness = object.Number("stiffness", kTiny, kMostStiffness);
  }
  if (object.Has("damping_curve")) {
    spring.damping_curve = ReadCurve(object, "damping_curve", "speed", "force");
    if (std::abs(EvaluateCurve(spring.damping_curve, 0.0)) > 1e-6) {
      object.Fail("damping_curve", "must pass through zero force at zero speed");
    }
  } else {
    spring.rate.damping = object.Number("damping", 0, kMostStiffness);
  }
  if (object.Has("bump_stop")) spring.bump_stop = ReadBumpStop(object.Child("bump_stop"));
  if (object.Has("free_length")) {
    spring.free_length = object.Number("free_length", kTiny, kMostLength);
  }
}

SpringLayout ReadSpring(const JsonObject& object) {
  SpringLayout spring;
  spring.mount = object.Point("mount");
  spring.pivot = object.Point("pivot");
  spring.hub_point = object.Point("hub_point");
  spring.lever = object.Number("lever", 0.05, 1.5);
  ReadStrut(object, spring);
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

IndependentSuspension::Link ReadTieRod(const JsonObject& object) {
  const IndependentSuspension::Link rod{"tie rod", object.Point("inner"), object.Point("outer")};
  object.RefuseUnknownKeys();
  return rod;
}

IndependentSuspension ReadIndependent(const JsonObject& object, const std::string& type) {
  IndependentSuspension suspension;
  const JsonObject carrier = object.Child("carrier");
  suspension.carrier_mass = carrier.Number("mass", kTiny, kMostMass);
  suspension.carrier_inertia = ReadInertia(carrier);
  carrier.RefuseUnknownKeys();
  const Eigen::Vector3d lower = object.Point("lower_ball");
  const Eigen::Vector3d upper = object.Point("upper_ball");
  if (type == "double_wishbone") {
    AddArmLinks(object, "lower_arm", lower, suspension);
    AddArmLinks(object, "upper_arm", upper, suspension);
    if (object.Has("tie_rod")) suspension.tie_rod = ReadTieRod(object.Child("tie_rod"));
    suspension.steering_axis = lower;
  } else {
    AddTrailingLinks(object, lower, upper, suspension);
  }
  suspension.link_rate = ReadOwnRate(object, "links");
  suspension.spring = ReadSpring(object.Child("spring"));
  suspension.toe = ReadOwnRate(object, "toe");
  if (object.Has("camber")) suspension.camber = ReadOwnRate(object, "camber");
  object.RefuseUnknownKeys();
  return suspension;
}

SpringLayout ReadAxleSpring(const JsonObject& object) {
  SpringLayout spring;
  spring.mount = object.Point("mount");
  spring.pivot = spring.mount;  // without an arm: lever 1
  spring.hub_point = object.Point("axle_point");
  ReadStrut(object, spring);
  object.RefuseUnknownKeys();
  return spring;
}

SolidAxle ReadSolidAxle(const JsonObject& object) {
  SolidAxle axle;
  axle.mass = object.Number("mass", kTiny, kMostMass);
  axle.inertia = ReadInertia(object);
  if (object.Has("links")) {
    axle.link_rate = ReadOwnRate(object, "link_rate");
    for (const JsonObject& link : object.Children("links")) {
      axle.links.push_back({link.Text("name"), link.Point("chassis_point"),
                            link.Point("axle_point"), link.Flag("mirrored", false)});
      link.RefuseUnknownKeys();
    }
  }
  if (object.Has("spring")) axle.spring = ReadAxleSpring(object.Child("spring"));
  object.RefuseUnknownKeys();
  return axle;
}

void AddSuspension(const JsonObject& object, const Eigen::Vector3d& center, const WheelModel& wheel,
                   VehicleModel& vehicle) {
  const std::string type = object.Text("type");
  if (type == "solid_axle") {
    AddSolidAxle(ReadSolidAxle(object), wheel, vehicle);
  } else if (type == "double_wishbone" || type == "trailing_arm") {
    AddIndependentAxle(ReadIndependent(object, type), center, wheel, vehicle);
  } else {
    object.Fail("type", "is \"" + type + "\", must be double_wishbone, trailing_arm or solid_axle");
  }
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
  tire.traction = type == "radial" ? RadialCoefficients() : BiasCoefficients();
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

}  // namespace

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
  WheelModel wheel = ReadWheel(object.Child("wheel"));
  wheel.tire = ReadTire(object.Child("tire"));
  vehicle.axles.push_back(axle);
  AddSuspension(object.Child("suspension"), {center[0], center[1], 0}, wheel, vehicle);
  object.RefuseUnknownKeys();
}

}  // namespace dbd
