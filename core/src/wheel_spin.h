#pragma once

#include "tire_force.h"

namespace dbd {

// Spin of the wheels, semi-implicit: with the traction linear in the spin, T(w) = T0 + T' (w - w0),
//   (J + dt r T') (w1 - w0) = dt (drive - r T0 - carcass).
// Differentials and brakes are friction couplings: each moves angular momentum across until the
// speeds agree or its largest torque is reached. An open differential moves none, a locked one as
// much as it takes, a limited-slip one up to its bias torque.

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

inline double CouplingTorque(const DifferentialModel& differential) {
  constexpr double kLockedTorque = 1e6;  // [N m] more than any axle carries
  switch (differential.type) {
    case DifferentialType::kOpen:
      return 0;
    case DifferentialType::kLimitedSlip:
      return differential.bias_torque;
    case DifferentialType::kLocked:
      return kLockedTorque;
  }
  return 0;
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
void ApplyDifferentials(const VehicleModel& model, const SpinArray<Real>& inertia, double step,
                        SpinArray<Real>& spin) {
  using S = ScalarOf<Real>;
  const AxleModel* previous = nullptr;
  for (const AxleModel& axle : model.axles) {
    if (!axle.driven) continue;
    const double most = CouplingTorque(axle.differential);
    if (most > 0) {
      CoupleShafts(inertia[axle.left], inertia[axle.right], Real(S(most * step)), spin[axle.left],
                   spin[axle.right]);
    }
    const double centre = CouplingTorque(model.powertrain.centre);
    if (previous != nullptr && centre > 0) {
      CoupleAxles(*previous, axle, Real(S(centre * step)), inertia, spin);
    }
    previous = &axle;
  }
}

/// New spins from the tire laws and controls; leaves the brake's mean torque in `brake_torque`.
template <class Real>
void AdvanceSpins(const VehicleModel& model, const WheelControls<Real>& controls, double step,
                  const std::array<TireLaw<Real>, kMaxWheels>& laws, EngineState<Real>& state,
                  SpinArray<Real>& spin_change, SpinArray<Real>& brake_torque) {
  using S = ScalarOf<Real>;
  const Real dt{S(step)};
  SpinArray<Real> inertia{}, spin{};
  for (std::size_t i = 0; i < model.wheels.size(); ++i) {
    const TireLaw<Real>& law = laws[i];
    inertia[i] =
        Real(S(model.wheels[i].spin_inertia)) + dt * law.rolling_radius * law.traction_by_spin;
    const Real torque =
        controls.drive_torque[i] - law.rolling_radius * law.traction0 - law.carcass_torque;
    spin[i] = state.wheels[i].spin + dt * torque / inertia[i];
  }
  ApplyDifferentials(model, inertia, step, spin);
  for (std::size_t i = 0; i < model.wheels.size(); ++i) {
    const Real most = controls.brake_torque[i] * dt / inertia[i];
    const Real slowed = Real(-1) * Clamp(spin[i], Real(-1) * most, most);
    brake_torque[i] = slowed * inertia[i] / dt;
    spin_change[i] = spin[i] + slowed - state.wheels[i].spin;
    state.wheels[i].spin = spin[i] + slowed;
  }
}

}  // namespace dbd
