#pragma once

#include <dbd/core/scenario.h>
#include <dbd/core/vehicle_model.h>
#include <mujoco/mujoco.h>

#include <memory>

#include "mujoco_vehicle.h"

namespace dbd {

struct MujocoDeleter {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
  void operator()(mjData* data) const { mj_deleteData(data); }
};
using MujocoModel = std::unique_ptr<mjModel, MujocoDeleter>;
using MujocoData = std::unique_ptr<mjData, MujocoDeleter>;

/// Addresses of a wheel's joints in MuJoCo's arrays; `steer_*` -1 where the wheel does not steer.
struct MujocoWheelAddress {
  int body = 0;
  int travel_q = 0;
  int steer_q = -1;
  int spin_dof = 0;
};

/// The vehicle in its design pose over the scenario's ground. Throws std::runtime_error with
/// MuJoCo's message.
MujocoModel MakeMujocoModel(const Scenario& scenario, const VehicleModel& vehicle,
                            MujocoContact contact);

MujocoWheelAddress FindMujocoWheel(const mjModel& model, const WheelModel& wheel);

/// Rate and damping at the wheel that an equivalent vertical strut has, from the lever between
/// spring and wheel at rest: what a wheel carries without its own weight, over its spring's force.
struct WheelStrut {
  double stiffness = 0;
  double damping = 0;
  double preload = 0;  ///< in the design pose [N]
};
WheelStrut WheelStrutOf(const VehicleModel& vehicle, const WheelModel& wheel);

}  // namespace dbd
