#pragma once

#include <dbd/core/ground.h>
#include <dbd/core/simulation_lanes.h>

#include <memory>
#include <string>

#include "engine_model.h"
#include "engine_state.h"

namespace dbd {

/// What one lane does in the next control interval.
struct LaneOrders {
  WheelControls<double> controls{};
  double keep = 1;  ///< share of all velocities that a step leaves: below 1 while settling
};

/// A pack of vehicles of one kind on one ground: the engine behind `SimulationLanes`, one class
/// per lane type. A virtual call serves a whole control interval of all lanes, or reads one lane.
class LaneEngine {
 public:
  virtual ~LaneEngine();  // in a translation unit for any processor

  virtual int lanes() const = 0;
  /// Puts a vehicle into a lane; its positions are in W.
  virtual void SetLane(int lane, const EngineState<double>& state) = 0;
  /// `orders`: one per lane. Advances by one control interval.
  virtual void Advance(const LaneOrders* orders) = 0;

  virtual BodyState<double> Body(int lane, int body) const = 0;
  virtual WheelState<double> Wheel(int lane, int wheel) const = 0;
  virtual TireReport<double> Tire(int lane, int wheel) const = 0;
  virtual double SpringForce(int lane, int spring) const = 0;
  virtual double LinkForce(int lane, int link) const = 0;
  /// Work of the drive torque, positive part, in the last control interval [J].
  virtual double DriveWork(int lane) const = 0;
  virtual double Spin(int lane, int wheel) const = 0;
  /// Of the chassis along its z axis, without gravity, mean over the last interval [m/s^2].
  virtual double VerticalAcceleration(int lane) const = 0;
};

/// Null where this build or this processor has no such lanes.
std::unique_ptr<LaneEngine> MakeLaneEngine(LaneKind kind, const VehicleModel& vehicle,
                                           const Ground& ground);

// One per instruction set, in translation units of their own.
std::unique_ptr<LaneEngine> MakePortableLanes(bool doubles, const VehicleModel& vehicle,
                                              const Ground& ground);
std::unique_ptr<LaneEngine> MakeAvx2Lanes(bool doubles, const VehicleModel& vehicle,
                                          const Ground& ground);
std::unique_ptr<LaneEngine> MakeAvx512Lanes(bool doubles, const VehicleModel& vehicle,
                                            const Ground& ground);

}  // namespace dbd
