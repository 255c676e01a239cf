#pragma once

#include <dbd/core/ground.h>
#include <dbd/core/units.h>

#include <cmath>

#include "body_motion.h"
#include "elements.h"
#include "tire_group.h"

namespace dbd {

/// What is constant for one vehicle and one choice of steps.
struct EngineModel {
  explicit EngineModel(const VehicleModel& vehicle_model)
      : vehicle(&vehicle_model), step(vehicle_model.steps.construction) {
    for (const WheelModel& wheel : vehicle->wheels) {
      patterns.push_back(MakeTirePattern(wheel.tire));
    }
    const auto every = [this](double group) { return static_cast<int>(std::lround(group / step)); };
    spring_every = every(vehicle->steps.spring);
    tire_every = every(vehicle->steps.tire);
    control_every = every(vehicle->steps.control);
  }

  const VehicleModel* vehicle;
  std::vector<TirePattern> patterns;
  double gravity = kGravity;
  double step;
  int spring_every = 1;  // construction steps per update of the group
  int tire_every = 1;
  int control_every = 1;
};

/// All forces on all bodies at the present time, into work.wrench; spins and slips advance.
template <class Real>
void EvaluateForces(const EngineModel& engine, const Ground& ground,
                    const WheelControls<Real>& controls, EngineState<Real>& state,
                    Workspace<Real>& work) {
  const VehicleModel& model = *engine.vehicle;
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    work.R_WB[i] = RotationMatrix(state.bodies[i].q_WB);
  }
  if (state.step % engine.tire_every == 0) {
    SampleContacts(model, engine.patterns, ground, controls, work, state);
  }
  if (state.step % engine.spring_every == 0) {
    for (Wrench<Real>& wrench : work.spring_wrench) wrench.Clear();
    AddSpringForces(model, state, work, work.spring_wrench);
  }
  work.wrench = work.spring_wrench;
  AddLinkForces(model, state, work);
  AddJointTorques(model, controls, state, work);
  AddTireForces(model, controls, engine.step, state, work);
}

/// One construction step of one vehicle, or of one pack of vehicles.
template <class Real>
void StepEngine(const EngineModel& engine, const Ground& ground,
                const WheelControls<Real>& controls, EngineState<Real>& state,
                Workspace<Real>& work) {
  EvaluateForces(engine, ground, controls, state, work);
  IntegrateBodies(*engine.vehicle, engine.gravity, engine.step, work, state);
  ++state.step;
}

}  // namespace dbd
