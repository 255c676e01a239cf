#pragma once

#include <dbd/core/ground.h>
#include <dbd/core/simulation_lanes.h>

#include <array>
#include <memory>
#include <string>

#include "engine_model.h"
#include "engine_state.h"

namespace dbd {

/// Most lanes of a pack.
inline constexpr int kMostLanes = 16;

/// A number for each lane.
using LaneNumbers = std::array<double, kMostLanes>;

/// What all lanes do in the next control interval, but for steering and brakes.
struct LaneOrders {
  LaneNumbers drive_torque{};  ///< on each driven wheel [N m]
  LaneNumbers keep{};          ///< share of all velocities that a step leaves: below 1 settling
};

/// What is asked of all lanes in every control interval.
struct LaneReadings {
  LaneNumbers driven_spin{};  ///< mean of the driven wheels [rad/s]
  LaneNumbers drive_work{};   ///< of the drive torque, positive part, in the last interval [J]
  /// Of the chassis along its z axis, without gravity, mean over the last interval [m/s^2].
  LaneNumbers vertical_acceleration{};
};

/// A wheel of one lane, with the body that carries it.
struct LaneWheel {
  BodyState<double> carrier;
  WheelState<double> state;
  TireReport<double> tire;
};

/// A vehicle as its lane has it: float lanes hold these very numbers.
struct LaneVehicle {
  EngineState<double> state;  // positions in W, less the origin
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
};

/// Positions are seen from an origin that lies `by` from the one before.
template <class Real>
void MoveOrigin(const Vec3<Real>& by, EngineState<Real>& state) {
  for (BodyState<Real>& body : state.bodies) body.p_WB -= by;
  for (WheelState<Real>& wheel : state.wheels) wheel.contact.p_WH -= by;
  for (PointContactState<Real>& contact : state.contacts) contact.p_WG -= by;
}

/// Origins move by whole multiples of this [m]: subtracting those is exact.
inline constexpr double kOriginShift = 8;

/// A pack of vehicles of one kind on one ground: the engine behind `SimulationLanes`, one class
/// per lane type. A virtual call serves a whole control interval of all lanes, or reads one lane.
class LaneEngine {
 public:
  virtual ~LaneEngine();  // in a translation unit for any processor

  virtual int lanes() const = 0;
  /// Puts a vehicle into a lane, whose origin must be near it.
  virtual void SetVehicle(int lane, const LaneVehicle& vehicle) = 0;
  /// Writes the lane's numbers over those of a vehicle of the same kind. As forces may be held
  /// from step to step, they are all of it only where all groups begin together.
  virtual void CopyVehicle(int lane, LaneVehicle& vehicle) const = 0;
  /// Steering and brakes, in force until the next call: they change less often than they act.
  virtual void Hold(int lane, const WheelControls<double>& controls) = 0;
  /// Advances by one control interval.
  virtual void Advance(const LaneOrders& orders) = 0;

  virtual void Read(LaneReadings& readings) const = 0;
  virtual BodyState<double> Body(int lane, int body) const = 0;
  virtual WheelState<double> Wheel(int lane, int wheel) const = 0;
  /// Sets what a `WheelView` shows: the carrier's pose, spin and contact point, the tire. Every
  /// number of a lane lies in a cache line of its own, so that only those are read.
  virtual void ReadWheel(int lane, int wheel, LaneWheel& out) const = 0;
  virtual double SpringForce(int lane, int spring) const = 0;
  virtual double LinkForce(int lane, int link) const = 0;
  /// Everything finite, no link torn in the last step.
  virtual bool IsSane(int lane) const = 0;
};

/// Null where this build or this processor has no such lanes.
std::unique_ptr<LaneEngine> MakeLaneEngine(LaneKind kind, const VehicleModel& vehicle,
                                           const Ground& ground);

// One per instruction set, in translation units of their own.
std::unique_ptr<LaneEngine> MakePortableLanes(LaneKind kind, const VehicleModel& vehicle,
                                              const Ground& ground);
std::unique_ptr<LaneEngine> MakeAvx2Lanes(LaneKind kind, const VehicleModel& vehicle,
                                          const Ground& ground);
std::unique_ptr<LaneEngine> MakeAvx512Lanes(LaneKind kind, const VehicleModel& vehicle,
                                            const Ground& ground);

}  // namespace dbd
