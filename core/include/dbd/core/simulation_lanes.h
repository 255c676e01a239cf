#pragma once

#include <dbd/core/simulation.h>

#include <memory>
#include <string>
#include <vector>

namespace dbd {

/// What a pack of vehicles is computed with.
enum class LaneKind {
  kFloat,        ///< the widest float lanes that the processor has: 16, 8 or 4 vehicles
  kDouble,       ///< the widest double lanes: 8, 4 or 2
  kFloat16,      ///< AVX-512
  kFloat8,       ///< AVX2
  kFloat4,       ///< AVX2
  kFloat4Plain,  ///< any x86-64, without fused multiply-adds
  kDouble8,      ///< AVX-512
  kDouble4,      ///< AVX2
  kDouble2,      ///< any x86-64, without fused multiply-adds
};

/// As text: "float x 16".
std::string LaneKindName(LaneKind kind);
/// Whether this build and this processor have such lanes.
bool LaneKindAvailable(LaneKind kind);

/// A pack of vehicles of one kind on one ground, each driving its own way: the same engine and the
/// same physics as `Simulation`, many at once. What a lane does depends neither on its neighbours
/// nor on its place nor on the width of the pack: float lanes give the same bits on every
/// processor with AVX2 (2013 and later; on older ones the same to round-off), and double lanes give
/// `Simulation`'s to round-off. A lane that has come to its end
/// takes the next vehicle at once. Not safe to share between threads; vehicle and ground are only
/// read.
class SimulationLanes {
 public:
  /// Both must outlive the lanes. Throws InputError where the processor has no such lanes.
  SimulationLanes(const VehicleModel& vehicle, const Ground& ground,
                  LaneKind kind = LaneKind::kFloat);
  ~SimulationLanes();
  SimulationLanes(SimulationLanes&&) noexcept;
  SimulationLanes& operator=(SimulationLanes&&) noexcept;

  int lanes() const;
  double control_step() const;

  /// Like `Simulation::Place`; the lane then settles for `settle_time` [s] while its neighbours
  /// drive. Its time counts up to 0 meanwhile.
  void Place(int lane, const Eigen::Vector2d& position, double heading, double settle_time = 1.0);
  /// Takes the vehicle out of a lane.
  void Park(int lane);
  /// Whether vehicles can be taken to other lanes now: all groups of forces begin together.
  bool at_period() const;
  /// Takes a vehicle over from lanes of the same number type with the same vehicle and ground, of
  /// any width. It goes on as it would have there, to the bit, but can only be observed after the
  /// next Advance. Both must be `at_period`.
  void TakeOver(int lane, SimulationLanes& from, int from_lane);
  /// Whether a vehicle is there and has settled: its command counts.
  bool driving(int lane) const;

  /// Advances all lanes by one control interval; one command for each lane, unread where a lane is
  /// not driving.
  void Advance(const std::vector<DriverCommand>& commands);

  double time(int lane) const;
  ChassisView Chassis(int lane) const;
  WheelView Wheel(int lane, int index) const;
  void Observe(int lane, VehicleSnapshot& snapshot) const;
  DriverView ViewForDriver(int lane) const;
  double VerticalAcceleration(int lane) const;
  const PowertrainState& powertrain(int lane) const;
  double SpringForce(int lane, int index) const;
  double LinkForce(int lane, int index) const;
  double drive_energy(int lane) const;
  bool IsSane(int lane) const;
  /// Hash of the lane's bodies and wheels as they are seen from outside, in W.
  std::uint64_t StateHash(int lane) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace dbd
