#include <dbd/core/simulation.h>

#include <cmath>
#include <cstring>

#include "engine.h"
#include "flatten.h"
#include "guide_force.h"
#include "held_tire.h"
#include "initial_state.h"
#include "vertical_tire.h"

namespace dbd {
namespace {

Eigen::Vector3d ToEigen(const Vec3<double>& v) { return {v.x, v.y, v.z}; }

constexpr double kTornLink = 0.2;  // [m]

}  // namespace

struct Simulation::Impl {
  Impl(const VehicleModel& model, const Ground& surface, const SimulationOptions& simulation)
      : vehicle(model), ground(surface), options(simulation), engine(model), work(model) {}

  const VehicleModel& vehicle;
  const Ground& ground;
  SimulationOptions options;
  EngineModel engine;
  EngineState<double> state;
  Workspace<double> work;
  HeldWrenches held_tires;
  WheelControls<double> controls;
  PowertrainState powertrain;
  double start_time = 0;
  double energy = 0;
  Vec3<double> last_v_WB{};  // of the chassis, one control step ago

  double Time() const { return static_cast<double>(state.step) * engine.step; }

  /// Flattened: a twentieth fewer instructions.
  DBD_FLATTEN void Step() {
    const bool plain = options.tire == TireKind::kFull && options.tire_scheme == TireScheme::kSplit;
    if (plain && !options.guide) {
      StepEngine(engine, ground, controls, state, work);
    } else {
      StepOnRig();
    }
  }

  void StepOnRig();

  /// Braking by the engine gives nothing back.
  void AddEnergy() {
    for (const TireReport<double>& tire : work.tires) {
      energy += std::max(0.0, tire.drive_power) * engine.step;
    }
  }

  double DrivenWheelSpeed() const {
    double sum = 0;
    int count = 0;
    for (std::size_t i = 0; i < vehicle.wheels.size(); ++i) {
      if (!vehicle.axles[vehicle.wheels[i].axle].driven) continue;
      sum += state.wheels[i].spin;
      ++count;
    }
    return sum / count;
  }

  void SetControls(const DriverCommand& command, double dt);
};

/// The torque is shared evenly among driven wheels: open differentials; what locked and limited-
/// slip ones move across is found with the spins.
void Simulation::Impl::SetControls(const DriverCommand& command, double dt) {
  const double torque = UpdatePowertrain(vehicle.powertrain, command.engine_torque,
                                         DrivenWheelSpeed(), dt, powertrain);
  int driven = 0;
  for (const WheelModel& wheel : vehicle.wheels) driven += vehicle.axles[wheel.axle].driven;
  AckermannSines(vehicle, command.steer, controls.steer_sine.data());
  for (std::size_t i = 0; i < vehicle.wheels.size(); ++i) {
    const WheelModel& wheel = vehicle.wheels[i];
    controls.drive_torque[i] = vehicle.axles[wheel.axle].driven ? torque / driven : 0;
    controls.brake_torque[i] = command.brake * wheel.brake_torque;
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
  s.controls = {};
  s.powertrain = {};
  for (std::size_t i = 0; i < s.vehicle.wheels.size(); ++i) {
    s.controls.brake_torque[i] = s.vehicle.wheels[i].brake_torque;
  }
  const auto steps = static_cast<std::int64_t>(std::ceil(settle_time / s.engine.step));
  for (std::int64_t i = 0; i < steps; ++i) {
    s.Step();
    DampMotion(kSettlingRate * s.engine.step, s.state);
  }
  s.state.step = 0;
  s.energy = 0;
  s.last_v_WB = s.state.bodies[0].v_WB;
}

void Simulation::Advance(const DriverCommand& command) {
  Impl& s = *impl_;
  s.SetControls(command, control_step());
  s.last_v_WB = s.state.bodies[0].v_WB;
  for (int i = 0; i < s.engine.control_every; ++i) {
    s.Step();
    s.AddEnergy();
  }
}

double Simulation::time() const { return impl_->Time(); }
double Simulation::control_step() const { return impl_->engine.step * impl_->engine.control_every; }
const PowertrainState& Simulation::powertrain() const { return impl_->powertrain; }
double Simulation::SpringForce(int index) const { return impl_->work.spring_force[index]; }
double Simulation::LinkForce(int index) const { return impl_->work.link_force[index]; }
double Simulation::drive_energy() const { return impl_->energy; }

ChassisView Simulation::Chassis() const {
  const BodyState<double>& body = impl_->state.bodies[0];
  const Mat3<double> R_WB = RotationMatrix(body.q_WB);
  ChassisView view;
  view.p_WB = ToEigen(body.p_WB);
  view.q_WB = Eigen::Quaterniond(body.q_WB.w, body.q_WB.x, body.q_WB.y, body.q_WB.z);
  view.v_WB = ToEigen(body.v_WB);
  view.w_WB = ToEigen(body.w_WB);
  view.yaw = std::atan2(R_WB.x.y, R_WB.x.x);
  view.pitch = -std::asin(std::clamp(R_WB.x.z, -1.0, 1.0));
  view.roll = std::atan2(R_WB.y.z, R_WB.z.z);
  view.forward_speed = Dot(body.v_WB, R_WB.x);
  return view;
}

WheelView Simulation::Wheel(int index) const {
  const WheelModel& wheel = impl_->vehicle.wheels[index];
  const WheelState<double>& state = impl_->state.wheels[index];
  const TireReport<double>& tire = impl_->work.tires[index];
  const BodyState<double>& body = impl_->state.bodies[wheel.body];
  const Vec3<double> p_WH = body.p_WB + RotationMatrix(body.q_WB) * Broadcast<double>(wheel.p_BH);
  WheelView view;
  view.p_WH = ToEigen(p_WH);
  view.contact_W = ToEigen(state.contact.p_WH + state.contact.p_HC_W);
  view.normal_W = ToEigen(state.contact.normal_W);
  view.load = tire.load;
  view.slip = tire.slip;
  view.spin = state.spin;
  view.net_traction = tire.net_traction;
  view.traction_capacity = tire.capacity;
  view.lateral = tire.lateral;
  view.deflection = tire.deflection;
  view.cone_index = state.contact.cone_index;
  view.drive_power = tire.drive_power;
  return view;
}

DriverView Simulation::ViewForDriver() const {
  const ChassisView chassis = Chassis();
  const Eigen::Vector3d rear = chassis.p_WB + chassis.q_WB * SteeringOrigin(impl_->vehicle);
  return {rear.head<2>(), chassis.yaw, chassis.forward_speed};
}

double Simulation::VerticalAcceleration() const {
  const BodyState<double>& body = impl_->state.bodies[0];
  return Dot(body.v_WB - impl_->last_v_WB, RotationMatrix(body.q_WB).z) / control_step();
}

bool Simulation::IsSane() const {
  const Impl& s = *impl_;
  for (const BodyState<double>& body : s.state.bodies) {
    const double sum = body.p_WB.x + body.p_WB.y + body.p_WB.z + body.v_WB.x + body.v_WB.y +
                       body.v_WB.z + body.q_WB.w + body.w_WB.x + body.w_WB.y + body.w_WB.z;
    if (!std::isfinite(sum)) return false;
  }
  for (std::size_t i = 0; i < s.vehicle.links.size(); ++i) {
    const LinkModel& link = s.vehicle.links[i];
    if (!(std::abs(s.work.link_force[i]) < kTornLink * link.stiffness)) return false;
  }
  return true;
}

std::uint64_t Simulation::StateHash() const {
  std::uint64_t hash = 1469598103934665603ull;  // FNV-1a
  const auto add = [&hash](const auto& plain) {
    unsigned char bytes[sizeof(plain)];
    std::memcpy(bytes, &plain, sizeof(plain));
    for (const unsigned char byte : bytes) hash = (hash ^ byte) * 1099511628211ull;
  };
  for (const BodyState<double>& body : impl_->state.bodies) add(body);
  for (const WheelState<double>& wheel : impl_->state.wheels) add(wheel);
  for (const PointContactState<double>& contact : impl_->state.contacts) add(contact);
  for (const double friction : impl_->state.frictions) add(friction);
  const PowertrainState& powertrain = impl_->powertrain;
  add(powertrain.gear);
  add(powertrain.time_in_gear);
  add(powertrain.engine_torque);
  return hash;
}

}  // namespace dbd
