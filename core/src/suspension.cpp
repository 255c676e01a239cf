#include "suspension.h"

namespace dbd {
namespace {

LinkModel MakeLink(const IndependentSuspension& suspension, const IndependentSuspension::Link& link,
                   const Eigen::Vector3d& p_RB_chassis, double side, int carrier,
                   const std::string& prefix) {
  LinkModel model;
  model.name = prefix + " " + link.name;
  model.body_b = carrier;
  model.p_A = OnSide(link.chassis_point, side) - p_RB_chassis;
  model.p_B = OnSide(link.ball, side);
  model.stiffness = suspension.link_rate.stiffness;
  model.damping = suspension.link_rate.damping;
  return model;
}

void AddLinks(const IndependentSuspension& suspension, const Eigen::Vector3d& p_RB_chassis,
              double side, int carrier, int steered_wheel, const std::string& prefix,
              VehicleModel& vehicle) {
  for (const IndependentSuspension::Link& link : suspension.links) {
    vehicle.links.push_back(MakeLink(suspension, link, p_RB_chassis, side, carrier, prefix));
  }
  if (!suspension.tie_rod) return;
  LinkModel rod = MakeLink(suspension, *suspension.tie_rod, p_RB_chassis, side, carrier, prefix);
  rod.steered_wheel = steered_wheel;
  rod.p_BK = OnSide(suspension.steering_axis, side);
  vehicle.links.push_back(rod);
}

/// Toe: the carrier's forward axis against the chassis' left axis; camber: the carrier's spin axis
/// against the chassis' vertical axis.
void AddJoints(const IndependentSuspension& suspension, int carrier, int steered_wheel,
               const std::string& prefix, VehicleModel& vehicle) {
  AxisJointModel toe;
  toe.name = prefix + " toe";
  toe.body_b = carrier;
  toe.axis_a = Eigen::Vector3d::UnitY();
  toe.axis_b = Eigen::Vector3d::UnitX();
  toe.stiffness = suspension.toe.stiffness;
  toe.damping = suspension.toe.damping;
  toe.steered_wheel = steered_wheel;
  vehicle.joints.push_back(toe);
  if (suspension.camber.stiffness == 0) return;
  AxisJointModel camber = toe;
  camber.name = prefix + " camber";
  camber.axis_a = Eigen::Vector3d::UnitZ();
  camber.axis_b = Eigen::Vector3d::UnitY();
  camber.stiffness = suspension.camber.stiffness;
  camber.damping = suspension.camber.damping;
  camber.steered_wheel = -1;
  vehicle.joints.push_back(camber);
}

}  // namespace

void AddSpring(const SpringLayout& layout, double side, int body, const std::string& prefix,
               VehicleModel& vehicle) {
  const Eigen::Vector3d p_RB_chassis = vehicle.bodies[0].p_RB;
  SpringModel spring;
  spring.name = prefix + " spring";
  spring.body_b = body;
  spring.p_A = OnSide(layout.mount, side) - p_RB_chassis;
  spring.p_Q = OnSide(layout.pivot, side) - p_RB_chassis;
  spring.p_B = OnSide(layout.hub_point, side);
  spring.lever = layout.lever;
  spring.stiffness = layout.rate.stiffness;
  spring.damping = layout.rate.damping;
  spring.force_curve = layout.force_curve;
  spring.damping_curve = layout.damping_curve;
  spring.bump_stop = layout.bump_stop;
  spring.free_length = layout.free_length.value_or(0);
  vehicle.springs.push_back(spring);
}

void AddIndependentAxle(const IndependentSuspension& suspension, const Eigen::Vector3d& center,
                        const WheelModel& wheel_of_both, VehicleModel& vehicle) {
  AxleModel& axle = vehicle.axles.back();
  const Eigen::Vector3d p_RB_chassis = vehicle.bodies[0].p_RB;
  for (const double side : {1.0, -1.0}) {
    const std::string prefix = axle.name + (side > 0 ? " left" : " right");
    const int carrier = static_cast<int>(vehicle.bodies.size());
    const int index = static_cast<int>(vehicle.wheels.size());
    vehicle.bodies.push_back({prefix + " carrier", suspension.carrier_mass,
                              suspension.carrier_inertia, OnSide(center, side)});
    WheelModel wheel = wheel_of_both;
    wheel.name = prefix;
    wheel.body = carrier;
    wheel.axle = static_cast<int>(vehicle.axles.size()) - 1;
    vehicle.wheels.push_back(wheel);
    (side > 0 ? axle.left : axle.right) = index;
    const int steered_wheel = axle.steer_ratio != 0 ? index : -1;
    AddLinks(suspension, p_RB_chassis, side, carrier, steered_wheel, prefix, vehicle);
    AddSpring(suspension.spring, side, carrier, prefix, vehicle);
    AddJoints(suspension, carrier, steered_wheel, prefix, vehicle);
  }
}

}  // namespace dbd
