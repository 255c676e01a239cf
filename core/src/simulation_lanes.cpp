#include <dbd/core/error.h>
#include <dbd/core/simulation_lanes.h>

#include <cmath>
#include <utility>

#include "initial_state.h"
#include "lane_engine.h"
#include "state_hash.h"
#include "vehicle_views.h"
#include "wheel_control.h"

namespace dbd {
namespace {

/// What belongs to one lane beside the engine's numbers.
struct Lane {
  enum class Phase { kEmpty, kWaiting, kSettling, kDriving };
  Phase phase = Phase::kEmpty;
  LaneVehicle start;                // while waiting
  std::int64_t settling_steps = 0;  // still to come
  std::int64_t steps = 0;           // driven
  double energy = 0;
  DriverCommand command{.brake = 1};  // whose steering and brakes are in force
  PowertrainState powertrain;
};

EngineState<double> DesignState(const VehicleModel& vehicle) {
  EngineState<double> state;
  for (const BodyModel& body : vehicle.bodies) {
    BodyState<double> b{};
    b.p_WB = Broadcast<double>(body.p_RB);
    b.q_WB.w = 1;
    state.bodies.push_back(b);
  }
  state.wheels.assign(vehicle.wheels.size(), {});
  state.contacts.assign(vehicle.contacts.size(), {});
  state.frictions.assign(vehicle.frictions.size(), 0);
  return state;
}

/// From positions in W.
LaneVehicle InLane(EngineState<double> state) {
  LaneVehicle vehicle{std::move(state)};
  const Vec3<double> p = vehicle.state.bodies[0].p_WB;
  vehicle.origin = kOriginShift * (Eigen::Vector3d(p.x, p.y, p.z) / kOriginShift).array().round();
  MoveOrigin(Broadcast<double>(vehicle.origin), vehicle.state);
  return vehicle;
}

}  // namespace

struct SimulationLanes::Impl {
  Impl(const VehicleModel& model, const Ground& surface, LaneKind kind)
      : vehicle(model),
        ground(surface),
        times(model),
        held(HeldByBrakes(model)),
        steering(model),
        steering_origin(SteeringOrigin(model)),
        control_step(times.step * times.control_every),
        engine(MakeLaneEngine(kind, model, surface)) {
    if (!engine) throw InputError("this processor has no lanes of " + LaneKindName(kind));
    lanes.resize(static_cast<std::size_t>(engine->lanes()));
    for (int i = 0; i < engine->lanes(); ++i) {
      engine->SetVehicle(i, InLane(DesignState(model)));
      engine->Hold(i, held);
    }
  }

  const Lane& At(int lane) const { return lanes[static_cast<std::size_t>(lane)]; }

  BodyState<double> Chassis(int lane) const { return engine->Body(lane, 0); }

  void Begin(int index);
  void Steer(int index, const DriverCommand& command);
  void Drive(int index, const DriverCommand& command);
  void GiveOrders(int index, const DriverCommand& command);
  void Account(int index);

  const VehicleModel& vehicle;
  const Ground& ground;
  EngineModel times;  // steps and their groups
  WheelControls<double> held;
  AckermannGeometry steering;
  Eigen::Vector3d steering_origin;
  double control_step;
  std::unique_ptr<LaneEngine> engine;
  std::vector<Lane> lanes;
  WheelControls<double> controls;  // of the lane that is given orders
  LaneOrders orders;
  LaneReadings readings;
  std::int64_t step = 0;
};

SimulationLanes::SimulationLanes(const VehicleModel& vehicle, const Ground& ground, LaneKind kind)
    : impl_(std::make_unique<Impl>(vehicle, ground, kind)) {}
SimulationLanes::~SimulationLanes() = default;
SimulationLanes::SimulationLanes(SimulationLanes&&) noexcept = default;
SimulationLanes& SimulationLanes::operator=(SimulationLanes&&) noexcept = default;

int SimulationLanes::lanes() const { return static_cast<int>(impl_->lanes.size()); }
double SimulationLanes::control_step() const { return impl_->control_step; }

/// The vehicle waits until all groups of forces begin together, as they do for one alone.
void SimulationLanes::Place(int index, const Eigen::Vector2d& position, double heading,
                            double settle_time) {
  Lane& lane = impl_->lanes[static_cast<std::size_t>(index)];
  lane = Lane();
  lane.phase = Lane::Phase::kWaiting;
  lane.start = InLane(InitialState<double>(impl_->vehicle, impl_->ground, position, heading));
  lane.settling_steps = impl_->times.SettlingSteps(settle_time);
  impl_->engine->Hold(index, impl_->held);
}

void SimulationLanes::Park(int index) {
  impl_->lanes[static_cast<std::size_t>(index)].phase = Lane::Phase::kEmpty;
  impl_->engine->Hold(index, impl_->held);
}

bool SimulationLanes::at_period() const { return impl_->step % impl_->times.period == 0; }

void SimulationLanes::TakeOver(int index, SimulationLanes& from, int from_index) {
  DBD_ASSERT(at_period() && from.at_period());
  Lane& lane = impl_->lanes[static_cast<std::size_t>(index)];
  lane = from.impl_->At(from_index);
  LaneVehicle vehicle{DesignState(impl_->vehicle)};
  from.impl_->engine->CopyVehicle(from_index, vehicle);
  impl_->engine->SetVehicle(index, vehicle);
  impl_->engine->Read(impl_->readings);
  impl_->Steer(index, lane.command);
  from.Park(from_index);
}

bool SimulationLanes::driving(int lane) const {
  return impl_->At(lane).phase == Lane::Phase::kDriving;
}

void SimulationLanes::Impl::Begin(int index) {
  Lane& lane = lanes[static_cast<std::size_t>(index)];
  engine->SetVehicle(index, lane.start);
  engine->Read(readings);
  lane.phase = lane.settling_steps > 0 ? Lane::Phase::kSettling : Lane::Phase::kDriving;
}

void SimulationLanes::Impl::Steer(int index, const DriverCommand& command) {
  SetSteeringAndBrakes(vehicle, steering, command, controls);
  engine->Hold(index, controls);
  lanes[static_cast<std::size_t>(index)].command = command;
}

void SimulationLanes::Impl::Drive(int index, const DriverCommand& command) {
  Lane& lane = lanes[static_cast<std::size_t>(index)];
  const auto i = static_cast<std::size_t>(index);
  if (!SteersAndBrakesAlike(command, lane.command)) Steer(index, command);
  orders.keep[i] = 1;
  const auto driven = static_cast<int>(times.driven_wheels.size());
  if (driven == 0) return;
  orders.drive_torque[i] = DriveTorquePerWheel(vehicle.powertrain, command, readings.driven_spin[i],
                                               driven, control_step, lane.powertrain);
}

/// Empty and waiting lanes are kept from moving, settling ones are damped.
void SimulationLanes::Impl::GiveOrders(int index, const DriverCommand& command) {
  const Lane& lane = At(index);
  if (lane.phase == Lane::Phase::kWaiting && step % times.period == 0) Begin(index);
  if (lane.phase == Lane::Phase::kDriving) return Drive(index, command);
  const auto i = static_cast<std::size_t>(index);
  orders.drive_torque[i] = 0;
  orders.keep[i] = lane.phase == Lane::Phase::kSettling ? 1 - kSettlingRate * times.step : 0;
}

void SimulationLanes::Impl::Account(int index) {
  Lane& lane = lanes[static_cast<std::size_t>(index)];
  if (lane.phase == Lane::Phase::kDriving) {
    lane.steps += times.control_every;
    lane.energy += readings.drive_work[static_cast<std::size_t>(index)];
  }
  if (lane.phase == Lane::Phase::kSettling) {
    lane.settling_steps -= times.control_every;
    if (lane.settling_steps <= 0) lane.phase = Lane::Phase::kDriving;
  }
}

void SimulationLanes::Advance(const std::vector<DriverCommand>& commands) {
  Impl& s = *impl_;
  DBD_ASSERT(commands.size() == s.lanes.size());
  for (int i = 0; i < lanes(); ++i) s.GiveOrders(i, commands[static_cast<std::size_t>(i)]);
  s.engine->Advance(s.orders);
  s.engine->Read(s.readings);
  s.step += s.times.control_every;
  for (int i = 0; i < lanes(); ++i) s.Account(i);
}

double SimulationLanes::time(int lane) const {
  const Lane& l = impl_->At(lane);
  return static_cast<double>(l.steps - l.settling_steps) * impl_->times.step;
}

ChassisView SimulationLanes::Chassis(int lane) const { return ViewOfChassis(impl_->Chassis(lane)); }

WheelView SimulationLanes::Wheel(int lane, int index) const {
  LaneWheel wheel{};
  impl_->engine->ReadWheel(lane, index, wheel);
  return ViewOfWheel(impl_->vehicle.wheels[static_cast<std::size_t>(index)], wheel.carrier,
                     wheel.state, wheel.tire);
}

DriverView SimulationLanes::ViewForDriver(int lane) const {
  return ViewOfDriver(impl_->steering_origin, impl_->Chassis(lane));
}

double SimulationLanes::VerticalAcceleration(int lane) const {
  return impl_->readings.vertical_acceleration[static_cast<std::size_t>(lane)];
}

const PowertrainState& SimulationLanes::powertrain(int lane) const {
  return impl_->At(lane).powertrain;
}
double SimulationLanes::SpringForce(int lane, int index) const {
  return impl_->engine->SpringForce(lane, index);
}
double SimulationLanes::LinkForce(int lane, int index) const {
  return impl_->engine->LinkForce(lane, index);
}
double SimulationLanes::drive_energy(int lane) const { return impl_->At(lane).energy; }

bool SimulationLanes::IsSane(int lane) const { return impl_->engine->IsSane(lane); }

void SimulationLanes::Observe(int lane, VehicleSnapshot& snapshot) const {
  const BodyState<double> chassis = impl_->Chassis(lane);
  LaneWheel wheel{};
  snapshot.time = time(lane);
  snapshot.chassis = ViewOfChassis(chassis);
  snapshot.path_point = PathPoint(impl_->steering_origin, chassis);
  snapshot.wheels.resize(impl_->vehicle.wheels.size());
  for (std::size_t i = 0; i < snapshot.wheels.size(); ++i) {
    impl_->engine->ReadWheel(lane, static_cast<int>(i), wheel);
    ViewWheel(impl_->vehicle.wheels[i], wheel.carrier, wheel.state, wheel.tire, snapshot.wheels[i]);
  }
}

std::uint64_t SimulationLanes::StateHash(int lane) const {
  StateHasher hasher;
  for (std::size_t i = 0; i < impl_->vehicle.bodies.size(); ++i) {
    hasher.Add(impl_->engine->Body(lane, static_cast<int>(i)));
  }
  for (std::size_t i = 0; i < impl_->vehicle.wheels.size(); ++i) {
    hasher.Add(impl_->engine->Wheel(lane, static_cast<int>(i)));
  }
  hasher.Add(impl_->At(lane).powertrain);
  return hasher.value();
}

}  // namespace dbd
