#include <dbd/core/simulation.h>

#include <cmath>

#include "corner_engine.h"
#include "engine.h"
#include "flatten.h"
#include "guide_force.h"
#include "held_tire.h"
#include "initial_state.h"
#include "state_hash.h"
#include "vehicle_views.h"
#include "vertical_tire.h"
#include "wheel_control.h"

namespace dbd {

struct Simulation::Impl {
  Impl(const VehicleModel& model, const Ground& surface, const SimulationOptions& simulation)
      : vehicle(model),
        ground(surface),
        options(simulation),
        engine(model),
        work(model),
        steering(model) {
    if (options.wheel_lanes && IsPlain()) corners = MakeCornerEngine(engine, ground);
  }

  const VehicleModel& vehicle;
  const Ground& ground;
  SimulationOptions options;
  EngineModel engine;
  std::unique_ptr<CornerEngine> corners;  // steps in the place of `state`
  bool ahead = false;                     // it has stepped since it last filled these
  EngineState<double> state;
  Workspace<double> work;
  HeldWrenches held_tires;
  AckermannGeometry steering;
  DriverCommand command;  // whose steering and brakes are in force
  WheelControls<double> controls;
  PowertrainState powertrain;
  double energy = 0;
  Vec3<double> last_v_WB{};  // of the chassis, one control step ago

  bool IsPlain() const {
    return options.tire == TireKind::kFull && options.tire_scheme == TireScheme::kSplit &&
           !options.guide;
  }

  double Time() const { return static_cast<double>(state.step) * engine.step; }

  /// Flattened: a twentieth fewer instructions.
  DBD_FLATTEN void Step() {
    if (IsPlain()) {
      StepEngine(engine, ground, controls, state, work);
    } else {
      StepOnRig();
    }
  }

  /// State and forces as they are now: reading them out of lanes takes a fifth of a step's time.
  Impl& Present() {
    if (ahead) corners->Read(state, work, last_v_WB);
    ahead = false;
    return *this;
  }

  WheelSpins Spins() const { return ahead ? corners->Spins() : SpinsOf(state); }

  void Hold(const DriverCommand& held) {
    SetSteeringAndBrakes(vehicle, steering, held, controls);
    command = held;
  }

  void StepOnRig();
  void Settle(std::int64_t steps);
  void DriveInterval();

  /// Braking by the engine gives nothing back.
  void AddEnergy() {
    for (const TireReport<double>& tire : work.tires) {
      energy += std::max(0.0, tire.drive_power) * engine.step;
    }
  }
};

void Simulation::Impl::Settle(std::int64_t steps) {
  const double keep = 1 - kSettlingRate * engine.step;
  if (corners) {
    corners->SetState(state);
    for (std::int64_t i = 0; i < steps; i += engine.control_every) corners->Advance(controls, keep);
    corners->Read(state, work, last_v_WB);
    state.step = 0;
    corners->SetState(state);
    return;
  }
  for (std::int64_t i = 0; i < steps; ++i) {
    Step();
    DampMotion(keep, state);
  }
  state.step = 0;
}

void Simulation::Impl::DriveInterval() {
  if (corners) {
    energy += corners->Advance(controls, 1);
    state.step += engine.control_every;
    ahead = true;
    return;
  }
  for (int i = 0; i < engine.control_every; ++i) {
    Step();
    AddEnergy();
  }
}

/// The step of comparisons: another tire or scheme, or forces of a test rig.
void Simulation::Impl::StepOnRig() {
  if (options.tire == TireKind::kVerticalDisc) {
    LocateBodies(state, work);
    SetElementForces(engine, controls, state, work);
    AddContactsAndLoads(vehicle, ground, engine.step, state.step % engine.tire_every == 0, state,
                        work);
    AddDiscForces(vehicle, ground, state, work);
  } else if (options.tire_scheme == TireScheme::kHold) {
    EvaluateForcesHeld(engine, ground, controls, state, work, held_tires);
  } else {
    EvaluateForces(engine, ground, controls, state, work);
  }
  if (options.guide) AddGuideForces(*options.guide, Time(), state, work);
  IntegrateBodies(vehicle, engine.gravity, engine.step, work, state);
  ++state.step;
}

Simulation::Simulation(const VehicleModel& vehicle, const Ground& ground,
                       const SimulationOptions& options)
    : impl_(std::make_unique<Impl>(vehicle, ground, options)) {}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;

void Simulation::Place(const Eigen::Vector2d& position, double heading, double settle_time) {
  Impl& s = *impl_;
  s.state = InitialState<double>(s.vehicle, s.ground, position, heading);
  s.ahead = false;
  s.powertrain = {};
  s.controls = {};
  s.Hold({.brake = 1});
  s.Settle(s.engine.SettlingSteps(settle_time));
  s.energy = 0;
  s.last_v_WB = s.state.bodies[0].v_WB;
}

void Simulation::Advance(const DriverCommand& command) {
  Impl& s = *impl_;
  if (!SteersAndBrakesAlike(command, s.command)) s.Hold(command);
  SetDriveTorques(s.vehicle, command, s.Spins(), control_step(), s.powertrain, s.controls);
  s.last_v_WB = s.state.bodies[0].v_WB;
  s.DriveInterval();
}

double Simulation::time() const { return impl_->Time(); }
double Simulation::control_step() const { return impl_->engine.step * impl_->engine.control_every; }
const PowertrainState& Simulation::powertrain() const { return impl_->powertrain; }
double Simulation::SpringForce(int index) const {
  return impl_->Present().work.spring_force[index];
}
double Simulation::LinkForce(int index) const { return impl_->Present().work.link_force[index]; }
double Simulation::drive_energy() const { return impl_->energy; }

ChassisView Simulation::Chassis() const { return ViewOfChassis(impl_->Present().state.bodies[0]); }

WheelView Simulation::Wheel(int index) const {
  const Impl& s = impl_->Present();
  const WheelModel& wheel = s.vehicle.wheels[index];
  return ViewOfWheel(wheel, s.state.bodies[wheel.body], s.state.wheels[index], s.work.tires[index]);
}

void Simulation::Observe(VehicleSnapshot& snapshot) const {
  snapshot.time = time();
  snapshot.chassis = Chassis();
  snapshot.path_point = ViewForDriver().position;
  snapshot.wheels.resize(impl_->vehicle.wheels.size());
  for (std::size_t i = 0; i < snapshot.wheels.size(); ++i) {
    snapshot.wheels[i] = Wheel(static_cast<int>(i));
  }
}

DriverView Simulation::ViewForDriver() const {
  return ViewOfDriver(impl_->vehicle, impl_->Present().state.bodies[0]);
}

double Simulation::VerticalAcceleration() const {
  const Impl& s = impl_->Present();
  const BodyState<double>& body = s.state.bodies[0];
  return Dot(body.v_WB - s.last_v_WB, RotationMatrix(body.q_WB).z) / control_step();
}

bool Simulation::wheel_lanes() const { return impl_->corners != nullptr; }

bool Simulation::IsSane() const {
  const Impl& s = impl_->Present();
  return StateIsSane(s.vehicle, s.state, s.work);
}

std::uint64_t Simulation::StateHash() const {
  const Impl& s = impl_->Present();
  return HashState(s.state, s.powertrain);
}

}  // namespace dbd
