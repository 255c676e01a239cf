#pragma once

#include <dbd/core/simulation.h>

#include "engine_state.h"

namespace dbd {

/// Adds the forces of a test rig to the chassis, at its centre of mass in world axes: it pulls the
/// vehicle along x at the wanted speed and holds it on the line y = 0 and on its heading.
inline void AddGuideForces(const GuideForces& guide, double time, const EngineState<double>& state,
                           Workspace<double>& work) {
  const BodyState<double>& chassis = state.bodies[0];
  const double since = std::max(0.0, time - guide.standing_time);
  const double wanted = std::min(guide.acceleration * since, guide.target_speed);
  const Vec3<double>& forward = work.R_WB[0].x;
  const double yaw = std::atan2(forward.y, forward.x);
  Wrench<double>& wrench = work.wrench[0];
  wrench.f_W.x += guide.speed_gain * (wanted - chassis.v_WB.x);
  wrench.f_W.y -= guide.side_stiffness * chassis.p_WB.y + guide.side_damping * chassis.v_WB.y;
  wrench.t_W.z -= guide.side_stiffness * yaw + guide.side_damping * chassis.w_WB.z;
}

}  // namespace dbd
