#pragma once

#include <dbd/core/vehicle_model.h>

#include <optional>

namespace dbd {

// Suspensions as sets of stiff spring-dampers (paper sections 4.2, 4.3 and Fig. 4). Each builder
// adds the bodies and force elements of one axle's left and right side to the vehicle. Points are
// of the left side, in the reference frame; balls and hub points are relative to the wheel centre.

struct StiffnessDamping {
  double stiffness = 0;
  double damping = 0;
};

struct SpringLayout {
  Eigen::Vector3d mount;      // on the chassis
  Eigen::Vector3d pivot;      // of the arm, on the chassis
  Eigen::Vector3d hub_point;  // of the arm, on the wheel body
  double lever = 1;
  StiffnessDamping rate;
  CurveModel force_curve;    // replaces the stiffness where given
  CurveModel damping_curve;  // replaces the damping where given
  BumpStopModel bump_stop;
  std::optional<double> free_length;  // absent: trimmed
};

/// Mirrors left-side geometry to the right when `side` is -1.
inline Eigen::Vector3d OnSide(const Eigen::Vector3d& left, double side) {
  return {left.x(), side * left.y(), left.z()};
}

/// The spring of one side between the chassis and `body`.
void AddSpring(const SpringLayout& layout, double side, int body, const std::string& prefix,
               VehicleModel& vehicle);

/// An independent wheel: carrier body held by links from chassis points to balls, a spring, and
/// rotational stiffness against toe and, if needed, camber.
struct IndependentSuspension {
  struct Link {
    std::string name;
    Eigen::Vector3d chassis_point;
    Eigen::Vector3d ball;
  };
  double carrier_mass = 0;
  Eigen::Vector3d carrier_inertia = Eigen::Vector3d::Ones();
  std::vector<Link> links;
  std::optional<Link> tie_rod;                              // inner end and outer ball
  Eigen::Vector3d steering_axis = Eigen::Vector3d::Zero();  // its lower ball
  StiffnessDamping link_rate;
  SpringLayout spring;
  StiffnessDamping toe;
  StiffnessDamping camber;  // zero stiffness: the links hold camber
};

/// Adds both sides. `center`: left wheel centre in the reference frame; `wheel`: what both wheels
/// share (its body and name are filled in). The axle must be the last in `vehicle.axles`.
void AddIndependentAxle(const IndependentSuspension& suspension, const Eigen::Vector3d& center,
                        const WheelModel& wheel, VehicleModel& vehicle);

}  // namespace dbd
