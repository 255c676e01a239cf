#include "suspension_corner.h"

#include <dbd/core/error.h>

namespace dbd {
namespace {

/// Links of the carrier whose outer ends share a ball with the first of them, and the rest.
struct Links {
  std::vector<int> first_ball;
  std::vector<int> others;
};

Links LinksOf(const VehicleModel& vehicle, int carrier) {
  Links links;
  for (std::size_t i = 0; i < vehicle.links.size(); ++i) {
    const LinkModel& link = vehicle.links[i];
    if (link.body_a != 0 || link.body_b != carrier) continue;
    const bool same_ball =
        link.steered_wheel < 0 &&
        (links.first_ball.empty() || link.p_B == vehicle.links[links.first_ball.front()].p_B);
    (same_ball ? links.first_ball : links.others).push_back(static_cast<int>(i));
  }
  return links;
}

[[noreturn]] void Refuse(const VehicleModel& vehicle, const WheelModel& wheel) {
  throw InputError(vehicle.name + ": wheel \"" + wheel.name +
                   "\" needs two wishbones with a tie rod, or a trailing arm with two pivots");
}

}  // namespace

SuspensionCorner FindCorner(const VehicleModel& vehicle, int wheel_index) {
  const WheelModel& wheel = vehicle.wheels[wheel_index];
  const Links links = LinksOf(vehicle, wheel.body);
  if (links.first_ball.size() != 2) Refuse(vehicle, wheel);
  const LinkModel& a = vehicle.links[links.first_ball[0]];
  const LinkModel& b = vehicle.links[links.first_ball[1]];
  SuspensionCorner corner;
  corner.carrier = wheel.body;
  corner.axis = (b.p_A - a.p_A).normalized();
  corner.p_pivot = a.p_A;
  corner.p_ball = a.p_B;
  int on_the_same_pivots = 0, tie_rods = 0;
  for (const int i : links.others) {
    const LinkModel& link = vehicle.links[i];
    on_the_same_pivots += link.p_A == a.p_A || link.p_A == b.p_A;
    tie_rods += link.steered_wheel >= 0;
  }
  const bool trailing_arm = links.others.size() == 2 && on_the_same_pivots == 2;
  const bool wishbones = links.others.size() == 3 && on_the_same_pivots == 0 && tie_rods == 1;
  if (!trailing_arm && !wishbones) Refuse(vehicle, wheel);
  if (wishbones) corner.upper_links = links.others;
  return corner;
}

double DesignLength(const VehicleModel& vehicle, const LinkModel& link) {
  const Eigen::Vector3d a = vehicle.bodies[link.body_a].p_RB + link.p_A;
  const Eigen::Vector3d b = vehicle.bodies[link.body_b].p_RB + link.p_B;
  return (b - a).norm();
}

std::array<int, 4> WheelOrder(const VehicleModel& vehicle) {
  if (vehicle.axles.size() != 2) throw InputError(vehicle.name + ": needs two axles");
  const bool first_is_front = vehicle.axles[0].x > vehicle.axles[1].x;
  const AxleModel& front = vehicle.axles[first_is_front ? 0 : 1];
  const AxleModel& rear = vehicle.axles[first_is_front ? 1 : 0];
  return {front.left, front.right, rear.left, rear.right};
}

}  // namespace dbd
