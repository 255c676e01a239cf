#pragma once

#include <dbd/core/ground.h>
#include <dbd/core/units.h>

#include <cmath>

#include "body_motion.h"
#include "elements.h"
#include "point_contact.h"
#include "tire_group.h"

namespace dbd {

/// What is constant for one vehicle and one choice of steps.
struct EngineModel {
  explicit EngineModel(const VehicleModel& vehicle_model)
      : vehicle(&vehicle_model),
        attachments(vehicle_model),
        step(vehicle_model.steps.construction) {
    for (const WheelModel& wheel : vehicle->wheels) {
      patterns.push_back(MakeTirePattern(wheel.tire));
    }
    const auto every = [this](double group) { return static_cast<int>(std::lround(group / step)); };
    spring_every = every(vehicle->steps.spring);
    tire_every = every(vehicle->steps.tire);
    control_every = every(vehicle->steps.control);
  }

  const VehicleModel* vehicle;
  AttachmentPoints attachments;
  std::vector<TirePattern> patterns;
  double gravity = kGravity;
  double step;
  int spring_every = 1;  // construction steps per update of the group
  int tire_every = 1;
  int control_every = 1;
};

template <class Real>
void LocateBodies(const EngineState<Real>& state, Workspace<Real>& work) {
  for (std::size_t i = 0; i < state.bodies.size(); ++i) {
    work.R_WB[i] = RotationMatrix(state.bodies[i].q_WB);
  }
}

/// Forces between bodies, into work.wrench; springs are held between their updates.
template <class Real>
void SetElementForces(const EngineModel& engine, const WheelControls<Real>& controls,
                      const EngineState<Real>& state, Workspace<Real>& work) {
  const VehicleModel& model = *engine.vehicle;
  MovePoints(engine.attachments, state, work);
  std::fill(work.point_force.begin(), work.point_force.end(), Vec3<Real>{});
  if (state.step % engine.spring_every == 0) UpdateSprings(model, engine.attachments, work);
  AddSpringForces(model, engine.attachments, work);
  AddLinkForces(model, engine.attachments, controls, work);
  GatherPointForces(engine.attachments, work);
  AddJointTorques(model, controls, state, work);
}

/// All forces on all bodies at the present time, into work.wrench; spins and slips advance.
template <class Real>
void EvaluateForces(const EngineModel& engine, const Ground& ground,
                    const WheelControls<Real>& controls, EngineState<Real>& state,
                    Workspace<Real>& work) {
  const VehicleModel& model = *engine.vehicle;
  LocateBodies(state, work);
  const bool sample_ground = state.step % engine.tire_every == 0;
  if (sample_ground) SampleContacts(model, engine.patterns, ground, controls, work, state);
  SetElementForces(engine, controls, state, work);
  AddContactsAndLoads(model, ground, engine.step, sample_ground, state, work);
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
