#pragma once

#include <dbd/core/ground.h>

#include <memory>

#include "corners.h"
#include "engine_model.h"
#include "engine_state.h"
#include "wheel_control.h"

namespace dbd {

/// One vehicle whose wheels, with their suspensions, are the lanes of a pack: the step of a single
/// vehicle at its fastest. A virtual call serves a whole control interval.
class CornerEngine {
 public:
  virtual ~CornerEngine();  // in a translation unit for any processor

  virtual void SetState(const EngineState<double>& state) = 0;
  /// Advances by one control interval; `keep`: share of all velocities that a step leaves.
  /// Returns the work of the drive torque, positive part [J].
  virtual double Advance(const WheelControls<double>& controls, double keep) = 0;
  virtual WheelSpins Spins() const = 0;
  /// State, forces of the last step, and the chassis' velocity before the last control interval.
  virtual void Read(EngineState<double>& state, Workspace<double>& work,
                    Vec3<double>& last_v_WB) const = 0;
};

/// All must outlive it. Null where the vehicle has no corners, see FindCorners.
std::unique_ptr<CornerEngine> MakeCornerEngine(const EngineModel& engine, const Ground& ground);

// One per instruction set, in translation units of their own; null where the build has none.
std::unique_ptr<CornerEngine> MakePortableCorners(const EngineModel& engine, const Corners& corners,
                                                  const Ground& ground);
std::unique_ptr<CornerEngine> MakeAvx2Corners(const EngineModel& engine, const Corners& corners,
                                              const Ground& ground);
std::unique_ptr<CornerEngine> MakeAvx512Corners(const EngineModel& engine, const Corners& corners,
                                                const Ground& ground);

}  // namespace dbd
