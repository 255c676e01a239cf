#pragma once

#include "flatten.h"
#include "tire_contact.h"
#include "wheel_spin.h"

namespace dbd {

// All tires of a vehicle for one step: laws, then spins, then forces on the bodies.

/// Where a hub is and how its spin axis points.
template <class Real>
struct HubPose {
  Vec3<Real> lever;  // from the body's centre of mass, in W
  Vec3<Real> y_W;    // spin axis, left
};

template <class Real, class Wheel>
HubPose<Real> LocateHub(const Wheel& wheel, const Mat3<Real>& R_WB, const Real& steer_sine) {
  if (!wheel.steers_hub) return {R_WB * Broadcast<Real>(wheel.p_BH), R_WB.y};
  const Real cosine = Sqrt(Real(1) - steer_sine * steer_sine);
  return {R_WB * Broadcast<Real>(wheel.p_BH), cosine * R_WB.y - steer_sine * R_WB.x};
}

template <class Real, class Engine, class Surface>
DBD_STAGE void SampleContacts(const Engine& engine, const Surface& ground,
                              const WheelControls<Real>& controls, const Workspace<Real>& work,
                              EngineState<Real>& state) {
  const auto& wheels = engine.vehicle->wheels;
  for (std::size_t i = 0; i < wheels.size(); ++i) {
    const auto& wheel = wheels[i];
    const auto hub = LocateHub(wheel, work.R_WB[wheel.body], controls.steer_sine[i]);
    SampleContact(engine.patterns[i], ground, state.bodies[wheel.body].p_WB + hub.lever, hub.y_W,
                  state.wheels[i].contact, i);
  }
}

/// Puts one tire's force, the drive and brake reactions and the wheel's gyroscopic moment on the
/// bodies. The contact force is applied without its moment about the spin axis: that moment turns
/// the wheel, not the body that carries it.
template <class Real, class Wheel>
void ApplyTire(const Wheel& wheel, const TireLaw<Real>& law, const HubPose<Real>& hub,
               const Real& traction, const Real& drive_torque, const Real& brake_torque,
               const WheelState<Real>& state, const BodyState<Real>& body, Workspace<Real>& work) {
  const Real along = traction + law.resistance;
  const Vec3<Real> f = law.load * law.normal_W + along * law.forward_W + law.lateral * law.left_W;
  Vec3<Real> moment = Cross(state.contact.p_HC_W, f);
  moment -= Dot(moment, hub.y_W) * hub.y_W;
  Wrench<Real>& wrench = work.wrench[wheel.body];
  wrench.Add(f, hub.lever);
  wrench.t_W += moment;
  wrench.t_W -= brake_torque * hub.y_W;
  const Real spin_momentum = ToLanes<Real>(wheel.gyroscopic_inertia) * state.spin;
  wrench.t_W -= spin_momentum * Cross(body.w_WB, hub.y_W);
  work.wrench[wheel.reaction_body].t_W -= drive_torque * work.R_WB[wheel.reaction_body].y;
}

/// What is known of all tires before their new spins are.
template <class Real>
struct TireStep {
  std::array<HubPose<Real>, kMaxWheels> hubs;
  std::array<TireLaw<Real>, kMaxWheels> laws;
  std::array<CarrierSpin<Real>, kMaxWheels> carriers;
  SpinArray<Real> spin_change, brake_torque;
};

template <class Real, class Engine>
void EvaluateTires(const Engine& engine, const WheelControls<Real>& controls, double step,
                   const Workspace<Real>& work, EngineState<Real>& state, TireStep<Real>& tires) {
  const auto& wheels = engine.vehicle->wheels;
  for (std::size_t i = 0; i < wheels.size(); ++i) {
    const BodyState<Real>& body = state.bodies[wheels[i].body];
    HubPose<Real>& hub = tires.hubs[i];
    hub = LocateHub(wheels[i], work.R_WB[wheels[i].body], controls.steer_sine[i]);
    MeetGround(engine.tires[i], body, hub.lever, hub.y_W, state.wheels[i].contact, tires.laws[i]);
    tires.carriers[i] =
        PredictCarrierSpin(engine, i, body, work.wrench[wheels[i].body], hub.y_W, step);
  }
  for (std::size_t i = 0; i < wheels.size(); ++i) {
    MeetSoil(engine.tires[i], state.wheels[i], tires.laws[i]);
  }
  for (std::size_t i = 0; i < wheels.size(); ++i) {
    SetTraction(engine.tires[i], state.wheels[i], tires.laws[i]);
  }
  for (std::size_t i = 0; i < wheels.size(); ++i) {
    SetLateral(engine.tires[i], state.wheels[i], tires.laws[i]);
  }
}

template <class Real, class Engine>
DBD_STAGE void AddTireForces(const Engine& engine, const WheelControls<Real>& controls, double step,
                             EngineState<Real>& state, Workspace<Real>& work) {
  const auto& model = *engine.vehicle;
  TireStep<Real> tires;
  EvaluateTires(engine, controls, step, work, state, tires);
  AdvanceSpins(engine, controls, step, tires.laws, tires.carriers, state, tires.spin_change,
               tires.brake_torque);
  for (std::size_t i = 0; i < model.wheels.size(); ++i) {
    const auto& wheel = model.wheels[i];
    const TireLaw<Real>& law = tires.laws[i];
    WheelState<Real>& w = state.wheels[i];
    const Real slip = Clamp(law.slip_base + law.slip_gain * w.spin, Real(-1), Real(1));
    w.slip = Select(law.load > Real(0), slip, Real(0));
    const Real traction = Clamp(law.traction0 + law.traction_by_spin * tires.spin_change[i],
                                Real(-1) * law.traction_limit, law.traction_limit);
    ApplyTire(wheel, law, tires.hubs[i], traction, controls.drive_torque[i], tires.brake_torque[i],
              w, state.bodies[wheel.body], work);
    work.tires[i] = {law.load,
                     w.slip,
                     traction + law.resistance,
                     law.traction_limit,
                     law.lateral,
                     law.load * ToLanes<Real>(engine.tires[i].by_stiffness),
                     controls.drive_torque[i] * w.spin};
  }
}

}  // namespace dbd
