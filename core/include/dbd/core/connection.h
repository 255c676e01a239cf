#pragma once

#include <dbd/core/vehicle_model.h>

#include <string>

namespace dbd {

// Connections between two bodies as sets of stiff spring-dampers (paper section 3, Fig. 2, in three
// dimensions). The links of a set meet in points of body b and run to points of body a, so that a
// motion that the connection allows changes no length however far it goes.

enum class ConnectionKind {
  kFree,       ///< nothing: six degrees of freedom remain
  kSpherical,  ///< three links into one point: three remain
  kRevolute,   ///< five links into two points on the axis: one remains
  kFixed,      ///< six links into three points: none remains
};

struct Connection {
  std::string name;
  ConnectionKind kind = ConnectionKind::kFixed;
  int body_a = 0;
  int body_b = 0;
  /// The joint in the design pose, reference frame. At body b's centre of mass the links give no
  /// torque about it ("revolute at the body centre"); elsewhere it swings ("off the centre").
  Eigen::Vector3d p_R = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitY();  ///< of a revolute connection
  double base = 0.2;       ///< distance of the points, and length of the links [m]
  double stiffness = 5e5;  ///< of each link [N/m]
  double damping = 1e3;    ///< of each link [N s/m]
};

/// Adds the links to `vehicle.links`, without tension in the design pose.
/// Throws InputError when bodies, axis, base or rates make no sense.
void AddConnection(const Connection& connection, VehicleModel& vehicle);

}  // namespace dbd
