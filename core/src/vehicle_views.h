#pragma once

#include <dbd/core/simulation.h>

#include "engine_state.h"

namespace dbd {

// The engine's state as others see it.

ChassisView ViewOfChassis(const BodyState<double>& body);

/// `body`: the one that carries the hub.
WheelView ViewOfWheel(const WheelModel& wheel, const BodyState<double>& body,
                      const WheelState<double>& state, const TireReport<double>& tire);

/// The same, written where it is wanted.
void ViewWheel(const WheelModel& wheel, const BodyState<double>& body,
               const WheelState<double>& state, const TireReport<double>& tire, WheelView& view);

DriverView ViewOfDriver(const VehicleModel& vehicle, const BodyState<double>& chassis);
/// The same where the vehicle's `SteeringOrigin` is at hand.
DriverView ViewOfDriver(const Eigen::Vector3d& steering_origin, const BodyState<double>& chassis);

/// The point that follows a path.
Eigen::Vector2d PathPoint(const Eigen::Vector3d& steering_origin, const BodyState<double>& chassis);

bool BodyIsFinite(const BodyState<double>& body);

/// Whether a link that pulls or pushes with `force` [N] still holds its bodies together.
bool LinkHolds(const LinkModel& link, double force);

/// Everything finite, no link torn in the last step.
bool StateIsSane(const VehicleModel& vehicle, const EngineState<double>& state,
                 const Workspace<double>& work);

}  // namespace dbd
