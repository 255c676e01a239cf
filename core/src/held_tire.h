#pragma once

#include "engine.h"

namespace dbd {

// Plain holding of the tire force, the multi-rate scheme as the paper writes it (section 3): the
// tires' forces are evaluated at their own rate and stay constant in between, spins advance with
// them. For comparison only: over a tire step T of several construction steps h the force is
// (T - h)/2 old on average, which acts like a damper of -k (T - h)/2. The engine's own scheme,
// SPLIT, holds only the contact's geometry.

/// What the tires do to the bodies, kept between tire updates.
using HeldWrenches = std::vector<Wrench<double>>;

/// Adds the tires' forces to the others in work.wrench, and keeps them.
inline void UpdateHeldTires(const EngineModel& engine, const Ground& ground,
                            const WheelControls<double>& controls, EngineState<double>& state,
                            Workspace<double>& work, HeldWrenches& held) {
  SampleContacts(engine, ground, controls, work, state);
  held = work.wrench;
  AddTireForces(engine, controls, engine.step * engine.tire_every, state, work);
  for (std::size_t i = 0; i < held.size(); ++i) {
    held[i].f_W = work.wrench[i].f_W - held[i].f_W;
    held[i].t_W = work.wrench[i].t_W - held[i].t_W;
  }
}

/// Like EvaluateForces, with held tire forces.
inline void EvaluateForcesHeld(const EngineModel& engine, const Ground& ground,
                               const WheelControls<double>& controls, EngineState<double>& state,
                               Workspace<double>& work, HeldWrenches& held) {
  LocateBodies(state, work);
  const bool sample_ground = state.step % engine.tire_every == 0;
  SetElementForces(engine, controls, state, work);
  AddContactsAndLoads(*engine.vehicle, ground, engine.step, sample_ground, state, work);
  if (sample_ground) {
    UpdateHeldTires(engine, ground, controls, state, work, held);
    return;
  }
  for (std::size_t i = 0; i < held.size(); ++i) {
    work.wrench[i].f_W += held[i].f_W;
    work.wrench[i].t_W += held[i].t_W;
  }
}

}  // namespace dbd
