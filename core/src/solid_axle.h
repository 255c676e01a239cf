#pragma once

#include <dbd/core/vehicle_model.h>

#include <optional>
#include <string>
#include <vector>

#include "suspension.h"

namespace dbd {

// A solid (beam) axle: one body with both wheels, located by stiff links and carried by a spring on
// each side. Without links it hangs on a connection instead: a pivot pin, or bolted on.

/// Points on the chassis are in the reference frame, those on the axle relative to the middle
/// between its wheel centres; both of the left side where they have one.
struct SolidAxle {
  struct Link {
    std::string name;
    Eigen::Vector3d chassis_point;
    Eigen::Vector3d axle_point;
    bool mirrored = false;  // the same on the right
  };
  double mass = 0;                                    // housing, hubs and wheels
  Eigen::Vector3d inertia = Eigen::Vector3d::Ones();  // without the spin of the wheels
  std::vector<Link> links;
  StiffnessDamping link_rate;
  std::optional<SpringLayout> spring;  // its hub_point is on the axle
};

/// Adds axle body, links, springs and both wheels. Steered wheels turn on the axle; it takes the
/// reaction of the drive torque. The axle must be the last in `vehicle.axles`.
void AddSolidAxle(const SolidAxle& design, const WheelModel& wheel_of_both, VehicleModel& vehicle);

}  // namespace dbd
