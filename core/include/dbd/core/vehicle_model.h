#pragma once

#include <dbd/core/vehicle_limits.h>

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

namespace dbd {

// The immutable description of a vehicle: rigid bodies, and flat lists of the force elements that
// join them. The builders (double wishbone, trailing arm, solid axle) fill these lists; the engine
// runs over them and knows no suspension by name.
//
// Points are given in the frame of their body: origin at its centre of mass, axes parallel to the
// chassis frame B (x forward, y left, z up) in the design pose. SI units.

/// A rigid body. Body 0 is the chassis.
struct BodyModel {
  std::string name;
  double mass = 0;
  Eigen::Vector3d inertia = Eigen::Vector3d::Ones();  ///< principal, about the body's axes
  Eigen::Vector3d p_RB = Eigen::Vector3d::Zero();     ///< design position in the reference frame R
};

/// A stiff spring-damper between two points: what DBD puts in the place of an arm or a joint
/// (paper section 4.2). Acts in tension and compression.
struct LinkModel {
  std::string name;
  int body_a = 0;
  int body_b = 0;
  Eigen::Vector3d p_A = Eigen::Vector3d::Zero();
  Eigen::Vector3d p_B = Eigen::Vector3d::Zero();
  double stiffness = 0;
  double damping = 0;
  double free_length = 0;
  // A tie rod follows the steering: its free length grows by s (linear + quadratic s) with s the
  // sine of the wheel's steer angle, as if body b turned about the vertical through p_BK.
  int steered_wheel = -1;                          ///< -1: not a tie rod
  Eigen::Vector3d p_BK = Eigen::Vector3d::Zero();  ///< on the steering axis, in body b
  double steer_linear = 0;
  double steer_quadratic = 0;
};

/// A piecewise linear function as a sum of hinges, so that a pack of lanes evaluates it without a
/// search: f(x) = value + slope (x - origin) + sum of change_i max(0, x - at_i). Beyond its table
/// it goes on along the outer segments. No hinges and no slope: not given.
struct CurveModel {
  struct Hinge {
    double at = 0;
    double slope_change = 0;
  };
  double origin = 0;
  double value = 0;
  double slope = 0;
  std::vector<Hinge> hinges;

  bool given() const { return slope != 0 || !hinges.empty(); }
};

/// Rubber stops at both ends of a spring's travel. A stop compressed by u pushes back with
/// k u (1 + u / 2p) plus its damping, which never makes it pull and at most doubles the push.
struct BumpStopModel {
  double travel_compression = 0;  ///< of the spring from the design pose to contact [m]
  double travel_extension = 0;
  double stiffness = 0;    ///< at first contact [N/m]; 0: no stops
  double progression = 0;  ///< p: compression at which the stiffness has doubled [m]; 0: linear
  double damping = 0;
  double shortest_length = 0;  ///< of the spring at contact, set by the trim
  double longest_length = 0;
};

/// A suspension spring and shock absorber. Its lower mount lies on a massless arm: at the fraction
/// `lever` of the way from pivot Q (on body a) to p_B (on body b). The force is shared between Q
/// and p_B in the same proportion, as the paper does between the lower arm's connection points.
struct SpringModel {
  std::string name;
  int body_a = 0;
  int body_b = 0;
  Eigen::Vector3d p_A = Eigen::Vector3d::Zero();
  Eigen::Vector3d p_Q = Eigen::Vector3d::Zero();  ///< on body a
  Eigen::Vector3d p_B = Eigen::Vector3d::Zero();
  double lever = 1;  ///< 1: mounted directly on body b
  double stiffness = 0;
  double damping = 0;
  double free_length = 0;
  CurveModel force_curve;    ///< over the deflection from the free length; replaces stiffness
  CurveModel damping_curve;  ///< over the speed of compression; replaces damping
  BumpStopModel bump_stop;
};

/// A rotational spring-damper that holds axis_a . axis_b at `rest` (+ sin of the steer angle).
/// The torque is the gradient of its energy, along axis_a x axis_b: any other choice of axis
/// creates energy.
struct AxisJointModel {
  std::string name;
  int body_a = 0;
  int body_b = 0;
  Eigen::Vector3d axis_a = Eigen::Vector3d::UnitY();
  Eigen::Vector3d axis_b = Eigen::Vector3d::UnitX();
  double stiffness = 0;    ///< [N m / rad]
  double damping = 0;      ///< [N m s / rad]
  double rest = 0;         ///< [-]
  int steered_wheel = -1;  ///< wheel whose steer angle is the target, -1: none
};

/// A point of a body that may touch the ground: belly, bumper, skid. Spring and damper along the
/// ground's normal, friction with a bristle that yields at friction * normal force, so that a
/// grounded vehicle neither creeps nor chatters.
struct ContactModel {
  std::string name;
  int body = 0;
  Eigen::Vector3d p_B = Eigen::Vector3d::Zero();
  double stiffness = 0;             ///< normal [N/m]
  double damping = 0;               ///< normal [N s/m]
  double friction = 0;              ///< coefficient [-]
  double tangential_stiffness = 0;  ///< of the bristle [N/m]
  double tangential_damping = 0;    ///< while it sticks [N s/m]
};

/// Dry friction between two bodies, along an axis or about it: a bristle that yields at `limit`.
/// Axis and force act at a point of body b.
struct FrictionModel {
  enum class Motion { kSliding, kTurning };
  std::string name;
  Motion motion = Motion::kSliding;
  int body_a = 0;
  int body_b = 0;
  Eigen::Vector3d axis_a = Eigen::Vector3d::UnitZ();  ///< fixed to body a
  Eigen::Vector3d p_B = Eigen::Vector3d::Zero();      ///< sliding only
  double limit = 0;                                   ///< [N] or [N m]
  double stiffness = 0;                               ///< before it slips [N/m] or [N m/rad]
  double damping = 0;                                 ///< before it slips
};

/// A constant force and torque on a body: a trailer's pull, a winch, a test rig.
struct AppliedLoadModel {
  std::string name;
  int body = 0;
  Eigen::Vector3d p_B = Eigen::Vector3d::Zero();     ///< where the force acts
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< [N]
  Eigen::Vector3d torque = Eigen::Vector3d::Zero();  ///< [N m]
  bool turns_with_body = false;                      ///< given in the body's axes, else in W
};

/// Coefficients of the Brixius (ASABE D497) wheel equations.
struct BrixiusCoefficients {
  double traction_max = 0.88;
  double mobility_rate = 0.1;
  double slip_rate = 7.5;
  double carcass_loss = 0.04;
  double resistance_mobility = 1.0;
  double resistance_slip = 0.5;
};

struct TireModel {
  double radius = 0;  ///< unloaded
  double width = 0;
  double section_height = 0;
  double rim_diameter = 0;
  double pressure = 0;             ///< inflation, gauge [Pa]
  double stiffness = 0;            ///< vertical [N/m]
  double damping = 0;              ///< vertical [N s/m]
  double lateral_limit = 0.8;      ///< largest lateral force / wheel load on firm ground
  double lateral_rate = 7.0;       ///< exponent of the lateral force [1/rad]
  double relaxation_length = 0.3;  ///< travel in which slip and slip angle build up
  int points = 30;                 ///< round each of the three planes
  BrixiusCoefficients traction;
};

struct WheelModel {
  std::string name;
  int body = 0;  ///< the body that carries the hub
  int axle = 0;
  Eigen::Vector3d p_BH = Eigen::Vector3d::Zero();  ///< hub in its body's frame
  bool steers_hub = false;        ///< the hub turns on its body (solid axle); else a joint steers
  int reaction_body = 0;          ///< takes the reaction of the drive torque
  double spin_inertia = 0;        ///< resists spinning up: wheel, shafts and gears [kg m^2]
  double gyroscopic_inertia = 0;  ///< of the wheel alone
  double brake_torque = 0;        ///< largest
  double static_load = 0;         ///< on level ground in the design pose [N]
  TireModel tire;
};

enum class DifferentialType { kOpen, kLimitedSlip, kLocked };

struct DifferentialModel {
  DifferentialType type = DifferentialType::kOpen;
  double bias_torque = 0;  ///< limited slip: largest torque moved across [N m]
};

struct AxleModel {
  std::string name;
  int left = 0;  ///< wheel indices
  int right = 0;
  double x = 0;  ///< of the wheel centres in the reference frame
  double track = 0;
  double steer_ratio = 0;  ///< 0 = fixed, 1 = steers fully, negative = counter-steers
  double max_steer = 0;    ///< of the mean wheel [rad]
  bool driven = false;
  DifferentialModel differential;
};

struct PowertrainModel {
  std::array<double, 3> torque_polynomial{};  ///< T = a w^2 + b w + c [N m], w engine speed [rad/s]
  double min_speed = 0;                       ///< engine [rad/s]
  double max_speed = 0;
  double braking_torque = 0;  ///< at closed throttle, positive
  std::vector<double> gear_ratios;
  double reverse_ratio = 1;   ///< of the reverse gear, positive
  double transfer_ratio = 1;  ///< in use: of the range that the vehicle file chooses
  struct Range {
    std::string name;
    double ratio = 1;
  };
  std::vector<Range> ranges;  ///< all that the transfer case has; empty: one ratio
  std::string range;          ///< name of the one in use
  double final_ratio = 1;
  double upshift_speed = 0;
  double downshift_speed = 0;
  double shift_interval = 0.5;  ///< least time between shifts [s]
  double clutch_time = 0.15;    ///< time constant of engagement [s]
  double efficiency = 1;
  DifferentialModel centre;  ///< between driven axles
};

/// Integration steps [s]. The slower groups are whole multiples of the construction step.
struct StepSizes {
  double construction = 2e-3;
  double spring = 2e-3;
  double tire = 4e-3;  ///< terrain sampling; the force law runs at the construction step
  double control = 4e-3;
};

struct VehicleModel {
  std::string name;
  std::string description;
  std::vector<BodyModel> bodies;
  std::vector<LinkModel> links;
  std::vector<SpringModel> springs;
  std::vector<AxisJointModel> joints;
  std::vector<ContactModel> contacts;
  std::vector<FrictionModel> frictions;
  std::vector<AppliedLoadModel> loads;
  std::vector<WheelModel> wheels;
  std::vector<AxleModel> axles;
  PowertrainModel powertrain;
  StepSizes steps;
  VehicleLimits limits;
  VehicleOutline outline;
  double reference_height = 0;  ///< of the reference frame's origin above level ground

  double total_mass() const;
  double wheelbase() const;  ///< foremost to rearmost axle
  double middle_x() const;   ///< half-way between them, in the reference frame
  /// The point that follows a path: the middle of the axles that do not steer (of all axles when
  /// all steer), in the reference frame.
  double path_point_x() const;
  double mean_track() const;
  /// Of the path of the rear axle's middle at full steer, plus a reserve for control [m].
  double min_turning_radius() const;
  /// Centre of mass of the whole vehicle above level ground.
  double mass_center_height() const;
};

}  // namespace dbd
