#pragma once

#include "engine.h"
#include "stages.h"

namespace dbd {

// A step of the engine in its stages, and a drive made of them, for any number type: what is timed
// with packs is counted with `Counted`.

/// StepEngine, with `mark(stage)` called at the end of each stage.
template <class Real, class Engine, class Surface, class Mark>
void StepInStages(const Engine& engine, const Surface& ground, const WheelControls<Real>& controls,
                  EngineState<Real>& state, Workspace<Real>& work, Mark& mark) {
  const auto& model = *engine.vehicle;
  const bool sample_ground = state.step % engine.tire_every == 0;
  LocateBodies(state, work);
  mark(Stage::kFrames);
  if (sample_ground) SampleContacts(engine, ground, controls, work, state);
  mark(Stage::kTireContact);
  SetElementForces(engine, controls, state, work);
  mark(Stage::kLinksAndSprings);
  AddContactsAndLoads(model, ground, engine.step, sample_ground, state, work);
  mark(Stage::kPointContacts);
  AddTireForces(engine, controls, engine.step, state, work);
  mark(Stage::kTireForce);
  IntegrateBodies(model, engine.gravity, engine.step, work, state);
  ++state.step;
  mark(Stage::kMotion);
}

/// The same numbers in all lanes: these structs hold nothing but numbers.
template <class Real, template <class> class Struct>
Struct<Real> InAllLanes(const Struct<double>& values) {
  constexpr std::size_t kNumbers = sizeof(Struct<double>) / sizeof(double);
  static_assert(sizeof(Struct<Real>) == kNumbers * sizeof(Real));
  Struct<Real> lanes;
  for (std::size_t k = 0; k < kNumbers; ++k) {
    reinterpret_cast<Real*>(&lanes)[k] =
        Real(static_cast<ScalarOf<Real>>(reinterpret_cast<const double*>(&values)[k]));
  }
  return lanes;
}

/// Vehicles side by side, one per lane, that drive straight ahead at about 2 m/s under their own
/// torque, without driver and powertrain: the engine alone.
template <class Real, class Engine = EngineModel>
struct StageDrive {
  StageDrive(const VehicleModel& vehicle, const EngineState<double>& start)
      : engine(vehicle), work(vehicle) {
    constexpr int kLanes = LaneTraits<Real>::kLanes;
    ScalarOf<Real> y[kLanes];
    for (int i = 0; i < kLanes; ++i) y[i] = static_cast<ScalarOf<Real>>(0.25 * i - 2);
    const Real track = LaneTraits<Real>::Load(y);
    for (const BodyState<double>& body : start.bodies) {
      state.bodies.push_back(InAllLanes<Real>(body));
      state.bodies.back().p_WB.y = state.bodies.back().p_WB.y + track;
    }
    for (const WheelState<double>& wheel : start.wheels) {
      state.wheels.push_back(InAllLanes<Real>(wheel));
    }
    for (const PointContactState<double>& contact : start.contacts) {
      state.contacts.push_back(InAllLanes<Real>(contact));
    }
    state.frictions.assign(start.frictions.size(), Real(0));
  }

  /// Controls of the next control interval.
  void HoldSpeed() {
    using S = ScalarOf<Real>;
    const Real most{S(300)};  // [N m] per wheel
    const Real torque =
        Clamp(Real(S(400)) * (Real(S(2)) - state.bodies[0].v_WB.x), Real(S(-1)) * most, most);
    const VehicleModel& vehicle = *engine.EngineModel::vehicle;
    for (std::size_t i = 0; i < vehicle.wheels.size(); ++i) {
      if (vehicle.axles[vehicle.wheels[i].axle].driven) controls.drive_torque[i] = torque;
    }
  }

  Engine engine;
  EngineState<Real> state;
  Workspace<Real> work;
  WheelControls<Real> controls{};
};

/// `steps` of it; `mark.Begin()` before each.
template <class Real, class Surface, class Engine, class Mark>
void Drive(StageDrive<Real, Engine>& drive, const Surface& ground, std::int64_t steps, Mark& mark) {
  for (std::int64_t i = 0; i < steps; ++i) {
    if (drive.state.step % drive.engine.control_every == 0) drive.HoldSpeed();
    mark.Begin();
    StepInStages(drive.engine, ground, drive.controls, drive.state, drive.work, mark);
  }
}

}  // namespace dbd
