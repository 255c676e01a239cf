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
      : vehicle(model), ground(surface), options(simulation), engine(model), work(model) {
    if (options.wheel_lanes && IsPlain()) corners = MakeCornerEngine(engine, ground);
  }

  const VehicleModel& vehicle;
  const Ground& ground;
  SimulationOptions options;
  EngineModel engine;
  std::unique_ptr<CornerEngine> corners;  // steps in the place of `state`, which it fills
  EngineState<double> state;
  Workspace<double> work;
  HeldWrenches held_tires;
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
    corners->Read(state, work);
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
    corners->Read(state, work);
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
  s.powertrain = {};
  s.controls = HeldByBrakes(s.vehicle);
  s.Settle(s.engine.SettlingSteps(settle_time));
  s.energy = 0;
  s.last_v_WB = s.state.bodies[0].v_WB;
}

void Simulation::Advance(const DriverCommand& command) {
  Impl& s = *impl_;
  SetControls(s.vehicle, command, SpinsOf(s.state), control_step(), s.powertrain, s.controls);
  s.last_v_WB = s.state.bodies[0].v_WB;
  s.DriveInterval();
}

double Simulation::time() const { return impl_->Time(); }
double Simulation::control_step() const { return impl_->engine.step * impl_->engine.control_every; }
const PowertrainState& Simulation::powertrain() const { return impl_->powertrain; }
double Simulation::SpringForce(int index) const { return impl_->work.spring_force[index]; }
double Simulation::LinkForce(int index) const { return impl_->work.link_force[index]; }
double Simulation::drive_energy() const { return impl_->energy; }

ChassisView Simulation::Chassis() const { return ViewOfChassis(impl_->state.bodies[0]); }

WheelView Simulation::Wheel(int index) const {
  const WheelModel& wheel = impl_->vehicle.wheels[index];
  return ViewOfWheel(wheel, impl_->state.bodies[wheel.body], impl_->state.wheels[index],
                     impl_->work.tires[index]);
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
  return ViewOfDriver(impl_->vehicle, impl_->state.bodies[0]);
}

double Simulation::VerticalAcceleration() const {
  const BodyState<double>& body = impl_->state.bodies[0];
  return Dot(body.v_WB - impl_->last_v_WB, RotationMatrix(body.q_WB).z) / control_step();
}

bool Simulation::wheel_lanes() const { return impl_->corners != nullptr; }

bool Simulation::IsSane() const { return StateIsSane(impl_->vehicle, impl_->state, impl_->work); }

std::uint64_t Simulation::StateHash() const { return HashState(impl_->state, impl_->powertrain); }

}  // namespace dbd
