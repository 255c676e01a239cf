#pragma once

#include "engine_model.h"
#include "tire_force.h"

namespace dbd {

// Spin of the wheels, semi-implicit: with the traction linear in the spin, T(w) = T0 + T' (w - w0),
//   (J + dt r T') (w1 - w0) = dt (drive - r T0 - carcass).
// Differentials and brakes are friction couplings: each moves angular momentum across until the
// speeds agree or its largest torque is reached. An open differential moves none, a locked one as
// much as it takes, a limited-slip one up to its bias torque. A brake holds the wheel to the body
// that carries it, not to the world: braked to rest against the world, the wheels of a rocking
// vehicle would do work on it.

template <class Real>
using SpinArray = std::array<Real, kMaxWheels>;

/// Takes both shafts towards one speed; `most` is the largest angular impulse.
template <class Real>
void CoupleShafts(const Real& inertia_a, const Real& inertia_b, const Real& most, Real& spin_a,
                  Real& spin_b) {
  const Real wanted = (spin_a - spin_b) * inertia_a * inertia_b / (inertia_a + inertia_b);
  const Real impulse = Clamp(wanted, Real(-1) * most, most);
  spin_a = spin_a - impulse / inertia_a;
  spin_b = spin_b + impulse / inertia_b;
}

/// Between neighbouring driven axles, through the mean of their wheels.
template <class Real>
void CoupleAxles(const AxleModel& a, const AxleModel& b, const Real& most,
                 const SpinArray<Real>& inertia, SpinArray<Real>& spin) {
  const Real half(0.5);
  const Real before_a = half * (spin[a.left] + spin[a.right]);
  const Real before_b = half * (spin[b.left] + spin[b.right]);
  Real mean_a = before_a, mean_b = before_b;
  CoupleShafts(inertia[a.left] + inertia[a.right], inertia[b.left] + inertia[b.right], most, mean_a,
               mean_b);
  spin[a.left] = spin[a.left] + (mean_a - before_a);
  spin[a.right] = spin[a.right] + (mean_a - before_a);
  spin[b.left] = spin[b.left] + (mean_b - before_b);
  spin[b.right] = spin[b.right] + (mean_b - before_b);
}

template <class Real>
void ApplyDifferentials(const EngineModel& engine, const SpinArray<Real>& inertia, double step,
                        SpinArray<Real>& spin) {
  const VehicleModel& model = *engine.vehicle;
  const AxleModel* previous = nullptr;
  for (std::size_t i = 0; i < model.axles.size(); ++i) {
    const AxleModel& axle = model.axles[i];
    if (!axle.driven) continue;
    const double most = engine.axle_coupling[i];
    if (most > 0) {
      CoupleShafts(inertia[axle.left], inertia[axle.right], ToLanes<Real>(most * step),
                   spin[axle.left], spin[axle.right]);
    }
    if (previous != nullptr && engine.centre_coupling > 0) {
      CoupleAxles(*previous, axle, ToLanes<Real>(engine.centre_coupling * step), inertia, spin);
    }
    previous = &axle;
  }
}

/// The body that carries a wheel, turning about the spin axis.
template <class Real>
struct CarrierSpin {
  Real rate;     // after this step, without the brake [rad/s]
  Real inertia;  // shared among the wheels that it carries
};

template <class Real, class Engine>
CarrierSpin<Real> PredictCarrierSpin(const Engine& engine, std::size_t wheel,
                                     const BodyState<Real>& body, const Wrench<Real>& wrench,
                                     const Vec3<Real>& y_W, double step) {
  const auto& carrier = engine.vehicle->bodies[engine.vehicle->wheels[wheel].body];
  const Real gain = ToLanes<Real>(step / carrier.inertia.y());
  return {Dot(body.w_WB, y_W) + gain * Dot(wrench.t_W, y_W),
          ToLanes<Real>(engine.carrier_inertia[wheel])};
}

/// Friction between wheel and carrier takes the wheel towards `rate`, as far as the brake can;
/// returns the torque on the wheel.
template <class Real>
Real BrakeTowards(const Real& rate, const Real& brake_torque, const Real& inertia, const Real& dt,
                  Real& spin) {
  const Real most = brake_torque * dt;
  const Real impulse = Clamp((rate - spin) * inertia, Real(-1) * most, most);
  spin = spin + impulse / inertia;
  return impulse / dt;
}

/// Wheels and carrier end with one rate, that keeps their angular momentum, where the brakes can
/// hold it. On a solid axle both wheels and the axle do.
template <class Real>
void ApplyBrakes(const VehicleModel& model, const AxleModel& axle,
                 const WheelControls<Real>& controls,
                 const std::array<CarrierSpin<Real>, kMaxWheels>& carriers, const Real& dt,
                 const SpinArray<Real>& inertia, SpinArray<Real>& spin,
                 SpinArray<Real>& brake_torque) {
  const int l = axle.left, r = axle.right;
  const auto momentum = [&](int i) {
    return inertia[i] * spin[i] + carriers[i].inertia * carriers[i].rate;
  };
  const auto whole = [&](int i) { return inertia[i] + carriers[i].inertia; };
  Real left_rate = momentum(l) / whole(l), right_rate = momentum(r) / whole(r);
  if (model.wheels[l].body == model.wheels[r].body) {
    left_rate = right_rate = (momentum(l) + momentum(r)) / (whole(l) + whole(r));
  }
  brake_torque[l] = BrakeTowards(left_rate, controls.brake_torque[l], inertia[l], dt, spin[l]);
  brake_torque[r] = BrakeTowards(right_rate, controls.brake_torque[r], inertia[r], dt, spin[r]);
}

/// What differentials and brakes make of spins that tires and drive torques would give; leaves the
/// brakes' torques on the wheels in `brake_torque`.
template <class Real>
void CoupleSpins(const EngineModel& engine, const WheelControls<Real>& controls, double step,
                 const std::array<CarrierSpin<Real>, kMaxWheels>& carriers,
                 const SpinArray<Real>& inertia, SpinArray<Real>& spin,
                 SpinArray<Real>& brake_torque) {
  using S = ScalarOf<Real>;
  const VehicleModel& model = *engine.vehicle;
  ApplyDifferentials(engine, inertia, step, spin);
  for (const AxleModel& axle : model.axles) {
    const Real free(0);
    if (!AnyOf(controls.brake_torque[axle.left] + controls.brake_torque[axle.right] > free)) {
      brake_torque[axle.left] = brake_torque[axle.right] = free;
      continue;
    }
    ApplyBrakes(model, axle, controls, carriers, Real(S(step)), inertia, spin, brake_torque);
  }
}

/// New spins from the tire laws and controls; leaves the brakes' torques on the wheels in
/// `brake_torque`.
template <class Real, class Engine>
void AdvanceSpins(const Engine& engine, const WheelControls<Real>& controls, double step,
                  const std::array<TireLaw<Real>, kMaxWheels>& laws,
                  const std::array<CarrierSpin<Real>, kMaxWheels>& carriers,
                  EngineState<Real>& state, SpinArray<Real>& spin_change,
                  SpinArray<Real>& brake_torque) {
  using S = ScalarOf<Real>;
  const Real dt{S(step)};
  SpinArray<Real> inertia, spin;
  for (std::size_t i = 0; i < state.wheels.size(); ++i) {
    const TireLaw<Real>& law = laws[i];
    inertia[i] = ToLanes<Real>(engine.vehicle->wheels[i].spin_inertia) +
                 dt * law.rolling_radius * law.traction_by_spin;
    const Real torque =
        controls.drive_torque[i] - law.rolling_radius * law.traction0 - law.carcass_torque;
    spin[i] = state.wheels[i].spin + dt * torque / inertia[i];
  }
  CoupleSpins(engine, controls, step, carriers, inertia, spin, brake_torque);
  for (std::size_t i = 0; i < state.wheels.size(); ++i) {
    spin_change[i] = spin[i] - state.wheels[i].spin;
    state.wheels[i].spin = spin[i];
  }
}

}  // namespace dbd
