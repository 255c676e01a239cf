#pragma once

#include <dbd/core/powertrain.h>
#include <dbd/core/scene.h>

#include <vector>

#include "couple.h"
#include "engine.h"
#include "flatten.h"

namespace dbd {

/// A vehicle model with the scene's steps, shared by all vehicles of its kind. Springs are updated
/// at every step: held ones would need memory for each vehicle.
struct SceneKind {
  SceneKind(const VehicleModel& given, double construction_step);

  VehicleModel model;
  EngineModel engine;
};

/// What a vehicle shows the others, of the beginning of a step.
struct Published {
  BodyState<double> chassis;
  double brake = 0;  // commanded share
};

/// One vehicle's own changing part, compact: the lists of its state are copied once to their final
/// size, vehicle after vehicle, and so lie one after another in memory.
struct alignas(64) SceneMember {
  int kind = 0;
  int ahead = -1;
  int behind = -1;
  EngineState<double> state;
  WheelControls<double> controls;
  PowertrainState powertrain;
  DriverCommand command;
  DriverState driver;
  double bumper_force = 0;
  double drawbar_force = 0;
  bool sane = true;
};

/// What a member needs of its scene during a step.
struct SceneSurroundings {
  const Ground& ground;
  const std::vector<SceneVehicle>& vehicles;
  const std::vector<Couple>& couples;  // to the vehicle ahead, by vehicle
  const std::vector<Published>& seen;  // at the beginning of the step, by vehicle
  GapOptions gap;
  bool settling = false;
};

/// One construction step of vehicle `index`; `shown` becomes what the others see in the next.
void StepMember(const SceneKind& kind, int index, const SceneSurroundings& around,
                Workspace<double>& work, SceneMember& member, Published& shown);

}  // namespace dbd
