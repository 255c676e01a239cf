#include "simbody_vehicle.h"

#include <dbd/core/error.h>
#include <dbd/core/units.h>

#include <ctime>
#include <memory>

#include "rig_forces.h"
#include "suspension_corner.h"

namespace dbd {
namespace {

using SimTK::MobilizedBody;
using SimTK::Rotation;
using SimTK::State;
using SimTK::Transform;
using SimTK::Vec3;

SimTK::Body::Rigid RigidBody(const BodyModel& body) {
  const Eigen::Vector3d& i = body.inertia;
  return SimTK::Body::Rigid(
      SimTK::MassProperties(body.mass, Vec3(0), SimTK::Inertia(i.x(), i.y(), i.z())));
}

/// A pin's axis is the z axis of its frames.
Rotation AlongPin(const Eigen::Vector3d& axis) {
  return Rotation(SimTK::UnitVec3(ToSimbody(axis)), SimTK::ZAxis);
}

/// The vehicle's bodies and joints, and what acts on them.
class System {
 public:
  System(const VehicleModel& vehicle, const Ground& ground, const GuideForces& guide);

  const SimTK::MultibodySystem& multibody() const { return system_; }
  State DesignPose();
  TrajectoryRow Observe(const State& state) const;
  double FrontLinkTension(const State& state) const { return rods_.front().getRodTension(state); }

 private:
  void AddCorner(const SuspensionCorner& corner);
  MobilizedBody AddOnArm(const SuspensionCorner& corner);
  MobilizedBody AddOnPin(const SuspensionCorner& corner);

  const VehicleModel& vehicle_;
  SimTK::MultibodySystem system_;
  SimTK::SimbodyMatterSubsystem matter_{system_};
  SimTK::GeneralForceSubsystem forces_{system_};
  SimTK::Force::Gravity gravity_{forces_, matter_, Vec3(0, 0, -kGravity)};
  MobilizedBody::Free chassis_;
  std::vector<MobilizedBody> bodies_;
  std::vector<SimTK::Constraint::Rod> rods_;  // the front left wheel's first
  RigForces* rig_ = nullptr;                  // owned by the system
  std::array<int, 4> wheels_{};
};

System::System(const VehicleModel& vehicle, const Ground& ground, const GuideForces& guide)
    : vehicle_(vehicle),
      chassis_(matter_.Ground(), RigidBody(vehicle.bodies[0])),
      bodies_(vehicle.bodies.size()),
      wheels_(WheelOrder(vehicle)) {
  bodies_[0] = chassis_;
  for (const int wheel : wheels_) AddCorner(FindCorner(vehicle, wheel));
  rig_ = new RigForces(vehicle, ground, guide, bodies_);
  SimTK::Force::Custom(forces_, rig_);
}

void System::AddCorner(const SuspensionCorner& corner) {
  bodies_[corner.carrier] = corner.upper_links.empty() ? AddOnPin(corner) : AddOnArm(corner);
  for (const int index : corner.upper_links) {
    const LinkModel& link = vehicle_.links[index];
    rods_.emplace_back(chassis_, ToSimbody(link.p_A), bodies_[corner.carrier], ToSimbody(link.p_B),
                       DesignLength(vehicle_, link));
  }
}

/// A massless lower arm on its pin; the carrier sits on it with a ball.
MobilizedBody System::AddOnArm(const SuspensionCorner& corner) {
  const Rotation along = AlongPin(corner.axis);
  const MobilizedBody::Pin arm(chassis_, Transform(along, ToSimbody(corner.p_pivot)),
                               SimTK::Body::Massless(), Transform(along, Vec3(0)));
  const BodyModel& carrier = vehicle_.bodies[corner.carrier];
  const Eigen::Vector3d p_RP = vehicle_.bodies[0].p_RB + corner.p_pivot;
  MobilizedBody arm_handle = arm;
  return MobilizedBody::Ball(arm_handle, ToSimbody(carrier.p_RB + corner.p_ball - p_RP),
                             RigidBody(carrier), ToSimbody(corner.p_ball));
}

/// A trailing arm: the carrier itself turns on the pin.
MobilizedBody System::AddOnPin(const SuspensionCorner& corner) {
  const Rotation along = AlongPin(corner.axis);
  const BodyModel& carrier = vehicle_.bodies[corner.carrier];
  const Eigen::Vector3d p_RP = vehicle_.bodies[0].p_RB + corner.p_pivot;
  return MobilizedBody::Pin(chassis_, Transform(along, ToSimbody(corner.p_pivot)),
                            RigidBody(carrier), Transform(along, ToSimbody(p_RP - carrier.p_RB)));
}

State System::DesignPose() {
  State state = system_.realizeTopology();
  const Eigen::Vector3d& p_RB = vehicle_.bodies[0].p_RB;
  chassis_.setQToFitTranslation(state, Vec3(p_RB.x(), 0, vehicle_.reference_height + p_RB.z()));
  return state;
}

TrajectoryRow System::Observe(const State& state) const {
  const Rotation& R_WB = chassis_.getBodyRotation(state);
  const Vec3& p_WB = chassis_.getBodyOriginLocation(state);
  TrajectoryRow row;
  row.t = state.getTime();
  row.x_cg = p_WB[0];
  row.z_cg = p_WB[2];
  row.z_ref = (p_WB - R_WB * ToSimbody(vehicle_.bodies[0].p_RB))[2];
  row.pitch = -std::asin(R_WB[2][0]);
  row.roll = std::atan2(R_WB[2][1], R_WB[2][2]);
  row.vx = chassis_.getBodyOriginVelocity(state)[0];
  for (std::size_t i = 0; i < 4; ++i) {
    const WheelModel& wheel = vehicle_.wheels[wheels_[i]];
    row.spring_force[i] = rig_->SpringForce(state, wheels_[i]);
    row.tire_force[i] = rig_->TireForce(state, wheels_[i]);
    row.wheel_height[i] =
        bodies_[wheel.body].findStationLocationInGround(state, ToSimbody(wheel.p_BH))[2];
  }
  return row;
}

std::unique_ptr<SimTK::Integrator> MakeIntegrator(const std::string& name,
                                                  const SimTK::MultibodySystem& system) {
  if (name == "merson") return std::make_unique<SimTK::RungeKuttaMersonIntegrator>(system);
  if (name == "runge-kutta-3") return std::make_unique<SimTK::RungeKutta3Integrator>(system);
  if (name == "cpodes") return std::make_unique<SimTK::CPodesIntegrator>(system);
  throw InputError("integrator \"" + name +
                   "\" is not known; there are merson, runge-kutta-3 and cpodes");
}

}  // namespace

std::vector<std::string> PeerIntegrators() { return {"merson", "runge-kutta-3", "cpodes"}; }

PeerDrive DriveWithSimbody(const Scenario& scenario, const VehicleModel& vehicle,
                           const GuideForces& guide, const PeerOptions& options) {
  System system(vehicle, *scenario.ground, guide);
  const auto integrator = MakeIntegrator(options.integrator, system.multibody());
  integrator->setAccuracy(options.accuracy);
  integrator->setConstraintTolerance(options.constraint_tolerance);
  integrator->setProjectInterpolatedStates(false);  // saves half of the time, changes nothing
  integrator->initialize(system.DesignPose());
  PeerDrive drive;
  const std::clock_t begin = std::clock();
  const int last = static_cast<int>(std::lround(scenario.duration / options.row_interval));
  for (int i = 0; i <= last; ++i) {
    integrator->stepTo(i * options.row_interval);
    const State& state = integrator->getState();
    system.multibody().realize(state, SimTK::Stage::Velocity);
    drive.rows.push_back(system.Observe(state));
    if (options.link_forces) {
      system.multibody().realize(state, SimTK::Stage::Acceleration);
      drive.front_link_force.push_back(system.FrontLinkTension(state));
    }
  }
  drive.cpu_seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  drive.steps = integrator->getNumStepsTaken();
  drive.attempts = integrator->getNumStepsAttempted();
  return drive;
}

}  // namespace dbd
