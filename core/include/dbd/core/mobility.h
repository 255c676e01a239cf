#pragma once

#include <dbd/core/ground.h>
#include <dbd/core/vehicle_model.h>

namespace dbd {

// Steady-state mobility of a whole vehicle on uniform soil, from the same tire-soil relations that
// the engine integrates: what the trafficability layer needs per material.

/// Largest net traction of the driven wheels, less the motion resistance of the others, divided by
/// the weight, on level ground under static loads. Negative = cannot move. The steepest grade that
/// traction allows is atan of this value.
double MaxNetTractionRatio(const VehicleModel& vehicle, const SoilSample& soil);

/// Deepest static sinkage of any wheel [m], fine-grained soil (terramechanics 6.1 calibrated form).
double StaticSinkage(const VehicleModel& vehicle, const SoilSample& soil);

/// Steepest side slope on which the vehicle does not tip over, atan(track / 2 h) [rad].
double StaticStabilityAngle(const VehicleModel& vehicle);

}  // namespace dbd
