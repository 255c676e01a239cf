#pragma once

#include <dbd/core/driver.h>
#include <dbd/core/ground.h>
#include <dbd/core/powertrain.h>
#include <dbd/core/vehicle_model.h>

#include <Eigen/Geometry>
#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace dbd {

/// A wheel as others see it.
struct WheelView {
  Eigen::Vector3d p_WH = Eigen::Vector3d::Zero();       ///< hub
  Eigen::Vector3d contact_W = Eigen::Vector3d::Zero();  ///< last contact point
  Eigen::Vector3d normal_W = Eigen::Vector3d::UnitZ();  ///< of the ground there
  double load = 0;                                      ///< [N], 0 = in the air
  double slip = 0;                                      ///< signed
  double spin = 0;                                      ///< [rad/s]
  double net_traction = 0;                              ///< along the heading [N]
  double traction_capacity = 0;  ///< largest gross traction here under this load [N]
  double lateral = 0;            ///< [N]
  double deflection = 0;         ///< of the tire [m]
  double cone_index = 0;         ///< of the soil under it [Pa]
  double drive_power = 0;        ///< [W]
};

/// Pose and motion of the chassis; angles after REP-103: pitch nose down, roll left side up.
struct ChassisView {
  Eigen::Vector3d p_WB = Eigen::Vector3d::Zero();
  Eigen::Quaterniond q_WB = Eigen::Quaterniond::Identity();
  Eigen::Vector3d v_WB = Eigen::Vector3d::Zero();
  Eigen::Vector3d w_WB = Eigen::Vector3d::Zero();
  double yaw = 0;
  double pitch = 0;
  double roll = 0;
  double forward_speed = 0;
};

/// A whole vehicle at one moment.
struct VehicleSnapshot {
  double time = 0;
  ChassisView chassis;
  std::vector<WheelView> wheels;                         ///< like the model's
  Eigen::Vector2d path_point = Eigen::Vector2d::Zero();  ///< what follows the path, in W
};

/// How tires meet the ground.
enum class TireKind {
  kFull,          ///< three planes, Brixius, lateral force: the vehicle's own
  kVerticalDisc,  ///< vertical force only, for comparison with other multibody programs
};

/// What stays constant between two updates of the tires, where the tire step is longer than the
/// construction step.
enum class TireScheme {
  kSplit,  ///< the contact's geometry; the force law follows the wheel at every construction step
  kHold,   ///< the force itself, as the paper writes it (section 3); for comparison
};

/// A test rig instead of engine and steering, for comparison with other multibody programs: forces
/// on the chassis' centre of mass that hold it on y = 0 and pull it along x.
struct GuideForces {
  double target_speed = 0;        ///< [m/s]
  double standing_time = 2;       ///< [s]
  double acceleration = 2;        ///< [m/s^2] of the wanted speed
  double speed_gain = 5000;       ///< [N s/m]
  double side_stiffness = 20000;  ///< [N/m] sideways and [N m/rad] in yaw
  double side_damping = 10000;    ///< [N s/m] and [N m s/rad]
};

struct SimulationOptions {
  /// Wheels and their suspensions side by side in the lanes of one processor: the same vehicle to
  /// round-off, in about a third of the time. For the full, split tire without guide; vehicles
  /// whose wheels are joined by more than chassis and shafts are driven without. See
  /// `wheel_lanes()`.
  bool wheel_lanes = false;
  TireKind tire = TireKind::kFull;
  TireScheme tire_scheme = TireScheme::kSplit;  ///< of the full tire
  std::optional<GuideForces> guide = std::nullopt;
};

/// One vehicle driving on one ground, in double precision: the reference of the engine and the
/// simplest way to use it. Not safe to share between threads; vehicle and ground are only read and
/// may be shared by any number of simulations.
class Simulation {
 public:
  /// Both must outlive the simulation.
  Simulation(const VehicleModel& vehicle, const Ground& ground,
             const SimulationOptions& options = {});
  ~Simulation();
  Simulation(Simulation&&) noexcept;

  /// Stands the vehicle on the ground with the middle of its rearmost fixed axle over `position`,
  /// and lets it settle with brakes on for `settle_time` [s], with numerical damping so that the
  /// lightly damped springs come to rest. Time starts at 0 after that.
  void Place(const Eigen::Vector2d& position, double heading, double settle_time = 1.0);

  /// Drives one control interval.
  void Advance(const DriverCommand& command);

  double time() const;
  double control_step() const;
  ChassisView Chassis() const;
  WheelView Wheel(int index) const;
  /// Fills `snapshot`, reusing its memory.
  void Observe(VehicleSnapshot& snapshot) const;
  /// Without the going: who drives carefully adds what is observed of it.
  DriverView ViewForDriver() const;
  /// Of the chassis along its z axis, without gravity, mean over the last control step [m/s^2].
  double VerticalAcceleration() const;
  const PowertrainState& powertrain() const;

  double SpringForce(int index) const;  ///< of the last step, compression positive [N]
  double LinkForce(int index) const;    ///< tension positive [N]

  /// Work that the drive torque put into the wheels since the start [J].
  double drive_energy() const;

  /// Whether the wheels are lanes, as asked for.
  bool wheel_lanes() const;

  /// Everything finite, no body torn off (no stiff link stretched by more than 0.2 m).
  bool IsSane() const;

  /// Hash of the whole state, bit by bit: bodies, wheels, contacts, frictions, powertrain.
  std::uint64_t StateHash() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace dbd
