#include "solid_axle.h"

namespace dbd {
namespace {

void AddAxleLink(const SolidAxle::Link& link, const StiffnessDamping& rate, double side, int body,
                 const std::string& name, VehicleModel& vehicle) {
  LinkModel model;
  model.name = name;
  model.body_b = body;
  model.p_A = OnSide(link.chassis_point, side) - vehicle.bodies[0].p_RB;
  model.p_B = OnSide(link.axle_point, side);
  model.stiffness = rate.stiffness;
  model.damping = rate.damping;
  vehicle.links.push_back(model);
}

void AddWheels(const WheelModel& wheel_of_both, int body, VehicleModel& vehicle) {
  AxleModel& axle = vehicle.axles.back();
  for (const double side : {1.0, -1.0}) {
    WheelModel wheel = wheel_of_both;
    wheel.name = axle.name + (side > 0 ? " left" : " right");
    wheel.body = body;
    wheel.axle = static_cast<int>(vehicle.axles.size()) - 1;
    wheel.p_BH = {0, 0.5 * side * axle.track, 0};
    wheel.steers_hub = axle.steer_ratio != 0;
    wheel.reaction_body = body;
    (side > 0 ? axle.left : axle.right) = static_cast<int>(vehicle.wheels.size());
    vehicle.wheels.push_back(wheel);
  }
}

}  // namespace

void AddSolidAxle(const SolidAxle& design, const WheelModel& wheel_of_both, VehicleModel& vehicle) {
  const AxleModel axle = vehicle.axles.back();
  const int body = static_cast<int>(vehicle.bodies.size());
  vehicle.bodies.push_back({axle.name + " axle", design.mass, design.inertia, {axle.x, 0, 0}});
  AddWheels(wheel_of_both, body, vehicle);
  for (const SolidAxle::Link& link : design.links) {
    const std::string name = axle.name + " " + link.name;
    AddAxleLink(link, design.link_rate, 1, body, link.mirrored ? name + " left" : name, vehicle);
    if (link.mirrored) AddAxleLink(link, design.link_rate, -1, body, name + " right", vehicle);
  }
  if (!design.spring) return;
  AddSpring(*design.spring, 1, body, axle.name + " left", vehicle);
  AddSpring(*design.spring, -1, body, axle.name + " right", vehicle);
}

}  // namespace dbd
