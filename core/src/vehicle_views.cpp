#include "vehicle_views.h"

#include <algorithm>
#include <cmath>

#include "engine_model.h"
#include "initial_state.h"

namespace dbd {
namespace {

Eigen::Vector3d ToEigen(const Vec3<double>& v) { return {v.x, v.y, v.z}; }

}  // namespace

ChassisView ViewOfChassis(const BodyState<double>& body) {
  const Mat3<double> R_WB = RotationMatrix(body.q_WB);
  ChassisView view;
  view.p_WB = ToEigen(body.p_WB);
  view.q_WB = Eigen::Quaterniond(body.q_WB.w, body.q_WB.x, body.q_WB.y, body.q_WB.z);
  view.v_WB = ToEigen(body.v_WB);
  view.w_WB = ToEigen(body.w_WB);
  view.yaw = std::atan2(R_WB.x.y, R_WB.x.x);
  view.pitch = -std::asin(std::clamp(R_WB.x.z, -1.0, 1.0));
  view.roll = std::atan2(R_WB.y.z, R_WB.z.z);
  view.forward_speed = Dot(body.v_WB, R_WB.x);
  return view;
}

WheelView ViewOfWheel(const WheelModel& wheel, const BodyState<double>& body,
                      const WheelState<double>& state, const TireReport<double>& tire) {
  WheelView view;
  ViewWheel(wheel, body, state, tire, view);
  return view;
}

void ViewWheel(const WheelModel& wheel, const BodyState<double>& body,
               const WheelState<double>& state, const TireReport<double>& tire, WheelView& view) {
  const Vec3<double> p_WH = body.p_WB + RotationMatrix(body.q_WB) * Broadcast<double>(wheel.p_BH);
  view.p_WH = ToEigen(p_WH);
  view.contact_W = ToEigen(state.contact.p_WH + state.contact.p_HC_W);
  view.normal_W = ToEigen(state.contact.normal_W);
  view.load = tire.load;
  view.slip = tire.slip;
  view.spin = state.spin;
  view.net_traction = tire.net_traction;
  view.traction_capacity = tire.capacity;
  view.lateral = tire.lateral;
  view.deflection = tire.deflection;
  view.cone_index = state.contact.cone_index;
  view.drive_power = tire.drive_power;
}

DriverView ViewOfDriver(const VehicleModel& vehicle, const BodyState<double>& chassis) {
  return ViewOfDriver(SteeringOrigin(vehicle), chassis);
}

DriverView ViewOfDriver(const Eigen::Vector3d& steering_origin, const BodyState<double>& chassis) {
  const Mat3<double> R_WB = RotationMatrix(chassis.q_WB);
  return {PathPoint(steering_origin, chassis), std::atan2(R_WB.x.y, R_WB.x.x),
          Dot(chassis.v_WB, R_WB.x)};
}

Eigen::Vector2d PathPoint(const Eigen::Vector3d& steering_origin,
                          const BodyState<double>& chassis) {
  const Vec3<double> p =
      chassis.p_WB + RotationMatrix(chassis.q_WB) * Broadcast<double>(steering_origin);
  return {p.x, p.y};
}

bool BodyIsFinite(const BodyState<double>& body) {
  return std::isfinite(body.p_WB.x + body.p_WB.y + body.p_WB.z + body.v_WB.x + body.v_WB.y +
                       body.v_WB.z + body.q_WB.w + body.w_WB.x + body.w_WB.y + body.w_WB.z);
}

bool LinkHolds(const LinkModel& link, double force) {
  return std::abs(force) < kTornLink * link.stiffness;
}

bool StateIsSane(const VehicleModel& vehicle, const EngineState<double>& state,
                 const Workspace<double>& work) {
  for (const BodyState<double>& body : state.bodies) {
    if (!BodyIsFinite(body)) return false;
  }
  for (std::size_t i = 0; i < vehicle.links.size(); ++i) {
    if (!LinkHolds(vehicle.links[i], work.link_force[i])) return false;
  }
  return true;
}

}  // namespace dbd
