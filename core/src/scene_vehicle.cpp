#include "scene_vehicle.h"

#include <algorithm>

#include "initial_state.h"
#include "time_steps.h"
#include "vehicle_views.h"
#include "wheel_control.h"

namespace dbd {
namespace {

VehicleModel WithConstructionStep(VehicleModel vehicle, double step) {
  vehicle.steps.construction = step;
  vehicle.steps.spring = step;
  SynchroniseSteps(vehicle.steps);
  return vehicle;
}

/// Constant time gap; see GapOptions.
double SpeedBehind(double gap, const GapOptions& options) {
  return std::max(0.0, gap - options.standing_gap) / options.time_gap;
}

void Drive(const SceneKind& kind, std::size_t index, const SceneSurroundings& around,
           SceneMember& member) {
  const SceneVehicle& vehicle = around.vehicles[index];
  const double dt = kind.engine.step * kind.engine.control_every;
  if (vehicle.driver == nullptr) {
    member.command = vehicle.command;
  } else {
    const BodyState<double>& chassis = member.state.bodies[0];
    DriverView view = ViewOfDriver(kind.model, chassis);
    if (member.ahead >= 0) {
      const BodyState<double>& ahead = around.seen[member.ahead].chassis;
      view.speed_limit = SpeedBehind(BumperGap(around.couples[index], ahead, chassis), around.gap);
    }
    member.command = vehicle.driver->Update(view, dt, member.driver);
  }
  SetControls(kind.model, member.command, SpinsOf(member.state), dt, member.powertrain,
              member.controls);
}

/// Steered by its drawbar, braked as the vehicle that tows it was one step ago.
void FollowDrawbar(const SceneKind& kind, std::size_t index, const SceneSurroundings& around,
                   SceneMember& member) {
  const Published& ahead = around.seen[member.ahead];
  const double angle = DrawbarAngle(around.couples[index], ahead.chassis, member.state.bodies[0]);
  double most = 0;
  for (const AxleModel& axle : kind.model.axles) most = std::max(most, axle.max_steer);
  member.command = {.steer = std::clamp(angle, -most, most), .brake = ahead.brake};
  SetSteeringAndBrakes(kind.model, member.command, member.controls);
}

void Control(const SceneKind& kind, std::size_t index, const SceneSurroundings& around,
             SceneMember& member) {
  if (around.settling) {
    SetSteeringAndBrakes(kind.model, {.brake = 1}, member.controls);
  } else if (around.vehicles[index].drawbar) {
    FollowDrawbar(kind, index, around, member);
  } else {
    Drive(kind, index, around, member);
  }
}

void AddWrench(const Wrench<double>& more, Wrench<double>& wrench) {
  wrench.f_W += more.f_W;
  wrench.t_W += more.t_W;
}

/// Adds what the vehicles ahead and behind do to this one's chassis.
void GatherCouples(std::size_t index, const SceneSurroundings& around, SceneMember& member,
                   Wrench<double>& chassis) {
  const auto forces = [&](int follower, int ahead) {
    return EvaluateCouple(around.couples[follower], around.seen[ahead].chassis,
                          around.seen[follower].chassis);
  };
  if (member.ahead >= 0) {
    const CoupleForces c = forces(static_cast<int>(index), member.ahead);
    member.bumper_force = c.bumper;
    member.drawbar_force = c.drawbar;
    if (c.bumper != 0 || c.drawbar != 0) AddWrench(c.on_behind, chassis);
  }
  if (member.behind >= 0) {
    const CoupleForces c = forces(member.behind, static_cast<int>(index));
    if (c.bumper != 0 || c.drawbar != 0) AddWrench(c.on_ahead, chassis);
  }
}

}  // namespace

SceneKind::SceneKind(const VehicleModel& given, double construction_step)
    : model(WithConstructionStep(given, construction_step)), engine(model) {}

/// Flattened like Simulation's step.
DBD_FLATTEN void StepMember(const SceneKind& kind, int index, const SceneSurroundings& around,
                            Workspace<double>& work, SceneMember& member, Published& shown) {
  const auto i = static_cast<std::size_t>(index);
  EngineState<double>& state = member.state;
  const bool controls_now = state.step % kind.engine.control_every == 0;
  if (controls_now) Control(kind, i, around, member);
  EvaluateForces(kind.engine, around.ground, member.controls, state, work);
  GatherCouples(i, around, member, work.wrench[0]);
  IntegrateBodies(kind.model, kind.engine.gravity, kind.engine.step, work, state);
  ++state.step;
  if (around.settling) DampMotion(1 - kSettlingRate * kind.engine.step, state);
  if (controls_now) member.sane = StateIsSane(kind.model, state, work);
  shown = {state.bodies[0], member.command.brake};
}

}  // namespace dbd
