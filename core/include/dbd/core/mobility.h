#pragma once

#include <dbd/core/ground.h>
#include <dbd/core/sinkage.h>
#include <dbd/core/vehicle_model.h>

namespace dbd {

// Steady-state mobility of a whole vehicle on uniform soil, from the same tire-soil relations that
// the engine integrates: what the trafficability layer needs per material.

/// Largest net traction of the driven wheels, less the motion resistance of the others, divided by
/// the weight, on level ground under static loads. Negative = cannot move. The steepest grade that
/// traction allows is atan of this value.
double MaxNetTractionRatio(const VehicleModel& vehicle, const SoilSample& soil);

/// Sinkage [m] of one wheel on a soil: `OperatingSinkage`, or Bekker's wheel where the soil asks
/// for it. `pass`: how many wheels of the track there were, this one included; counts only with the
/// multipass option.
double WheelSinkage(const TireModel& tire, const SoilSample& soil, double load, double deflection,
                    double slip, int pass = 1, const SinkageOptions& options = {});

/// Deepest sinkage [m] of any wheel under its static load, without more slip than it needs to move.
double StaticSinkage(const VehicleModel& vehicle, const SoilSample& soil);

/// Steepest side slope on which the vehicle, taken as rigid, does not tip over [rad]:
/// atan(track / 2 h); with two axles of which one swings on a pivot, over the line from the other
/// axle's lower contact to the pivot. Springs and tires that give way cost a few degrees.
double StaticStabilityAngle(const VehicleModel& vehicle);

}  // namespace dbd
