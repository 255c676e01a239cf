#pragma once

#include <dbd/core/ground.h>

#include "body_motion.h"
#include "elements.h"
#include "engine_model.h"
#include "flatten.h"
#include "point_contact.h"
#include "tire_group.h"

namespace dbd {

template <class Real>
DBD_STAGE void LocateBodies(const EngineState<Real>& state, Workspace<Real>& work) {
  for (std::size_t i = 0; i < state.bodies.size(); ++i) {
    work.R_WB[i] = RotationMatrix(state.bodies[i].q_WB);
  }
}

/// Forces between bodies, into work.wrench; springs are held between their updates.
template <class Real, class Engine>
void SetElementForces(const Engine& engine, const WheelControls<Real>& controls,
                      const EngineState<Real>& state, Workspace<Real>& work) {
  SetJoiningForces(*engine.vehicle, engine.joined, controls, state.step % engine.spring_every == 0,
                   state, work);
}

/// All forces on all bodies at the present time, into work.wrench; spins and slips advance.
template <class Real, class Engine, class Surface>
void EvaluateForces(const Engine& engine, const Surface& ground,
                    const WheelControls<Real>& controls, EngineState<Real>& state,
                    Workspace<Real>& work) {
  const auto& model = *engine.vehicle;
  LocateBodies(state, work);
  const bool sample_ground = state.step % engine.tire_every == 0;
  if (sample_ground) SampleContacts(engine, ground, controls, work, state);
  SetElementForces(engine, controls, state, work);
  AddContactsAndLoads(model, ground, engine.step, sample_ground, state, work);
  AddTireForces(engine, controls, engine.step, state, work);
}

/// The numbers of one vehicle stand in one lane: nothing to bring together.
template <class Real>
void JoinLanes(const EngineModel& /*engine*/, Workspace<Real>& /*work*/) {}

/// One construction step of one vehicle, or of one pack of vehicles.
template <class Real, class Engine, class Surface>
void StepEngine(const Engine& engine, const Surface& ground, const WheelControls<Real>& controls,
                EngineState<Real>& state, Workspace<Real>& work) {
  EvaluateForces(engine, ground, controls, state, work);
  JoinLanes(engine, work);
  IntegrateBodies(*engine.vehicle, engine.gravity, engine.step, work, state);
  ++state.step;
}

}  // namespace dbd
