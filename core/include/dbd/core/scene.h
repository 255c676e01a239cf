#pragma once

#include <dbd/core/driver.h>
#include <dbd/core/executor.h>
#include <dbd/core/ground.h>
#include <dbd/core/simulation.h>

#include <memory>
#include <optional>
#include <vector>

namespace dbd {

// Many vehicles on one ground, stepped together: convoys that may bump into each other, and road
// trains.

/// Bumpers are bars across the outline's front and rear, `height` above level ground. Three points
/// of a front bumper press against the plate of a rear one: spring and damper along the plate's
/// normal, which never pull, the damper at most doubling the spring; without friction. Rates are
/// assumed: they bring 750 kg to rest from 1 m/s in about 0.05 m.
struct BumperModel {
  double stiffness = 1e5;  ///< of each of the three points [N/m]
  double damping = 2e3;    ///< [N s/m]
  double height = 0.55;    ///< [m]
};

/// How a driver keeps the distance from the vehicle ahead: the speed is limited to
/// (gap - standing_gap) / time_gap, so that in steady driving the gap is standing_gap plus what is
/// driven in time_gap ("constant time gap").
struct GapOptions {
  double standing_gap = 3.0;  ///< between bumpers [m]
  double time_gap = 1.5;      ///< [s]
};

/// A bar between a hitch on the towing vehicle's chassis and a pivot on the trailer's, free to turn
/// at both ends: one stiff link. The trailer's steered axles follow the bar's direction. Points in
/// the reference frame of their vehicle. Rates default to those of the paper's stiff links.
struct DrawbarModel {
  Eigen::Vector3d hitch = Eigen::Vector3d::Zero();
  Eigen::Vector3d pivot = Eigen::Vector3d::Zero();
  double length = 2.0;     ///< without force [m]
  double stiffness = 5e5;  ///< [N/m]
  double damping = 1e4;    ///< [N s/m]
};

struct SceneVehicle {
  std::shared_ptr<const VehicleModel> model = {};
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< as in Simulation::Place
  double heading = 0;
  /// Made for `model`; absent: `command` holds throughout (of a trailer: nothing is commanded).
  std::shared_ptr<const Driver> driver = {};
  DriverCommand command = {};
  int ahead = -1;  ///< index of the vehicle in front that it may bump into, or that tows it
  std::optional<DrawbarModel> drawbar = {};  ///< given: towed by `ahead`, braked with it
};

struct SceneOptions {
  BumperModel bumper = {};
  GapOptions gap = {};
  double settle_time = 1.0;  ///< [s], as in Simulation::Place
};

/// Vehicles in lock-step, in double precision. Each vehicle gathers its own forces from what the
/// others published at the end of the step before, so that the order of the vehicles, and the
/// number of threads, changes no bit; far apart, each moves as in a Simulation of its own.
class Scene {
 public:
  /// Stands the vehicles on the ground, which must outlive the scene, and lets them settle. All
  /// take the shortest construction step among them. Throws InputError when a vehicle is not
  /// behind an earlier one, or two are behind the same.
  Scene(std::vector<SceneVehicle> vehicles, const Ground& ground, const SceneOptions& options = {});
  ~Scene();
  Scene(Scene&&) noexcept;

  /// Whole construction steps, the nearest number to `duration` [s]. The longer, the less the
  /// executor's start matters.
  void Advance(double duration, LockstepExecutor& executor);

  double time() const;
  double step() const;  ///< construction step [s]
  int vehicle_count() const;
  int body_count() const;
  ChassisView Chassis(int vehicle) const;
  /// From the front bumper to the rear one of the vehicle ahead, forward [m]; negative: pressed in.
  double Gap(int vehicle) const;
  double BumperForce(int vehicle) const;   ///< of the last step, on its front bumper [N]
  double DrawbarForce(int vehicle) const;  ///< of the last step, tension positive [N]
  /// By how much its drawbar is longer than without force [m].
  double DrawbarStretch(int vehicle) const;
  /// The driver stands at the path's end.
  bool Arrived(int vehicle) const;
  /// Everything finite, no stiff link torn (stretched by more than 0.2 m), as of the last step.
  bool IsSane() const;

  /// As Simulation::StateHash.
  std::uint64_t StateHash(int vehicle) const;
  /// Of all vehicles.
  std::uint64_t StateHash() const;
  /// Memory that a step of one vehicle reads and writes, without its model [byte].
  std::size_t StateBytes(int vehicle) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace dbd
