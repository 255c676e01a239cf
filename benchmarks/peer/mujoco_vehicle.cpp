#include "mujoco_vehicle.h"

#include <array>
#include <cmath>

#include "mujoco_model.h"
#include "suspension_corner.h"
#include "vehicle_views.h"
#include "wheel_control.h"

namespace dbd {

struct MujocoVehicle::Impl {
  Impl(const Scenario& drive, const VehicleModel& model_of_dbd, MujocoContact contact)
      : scenario(drive),
        vehicle(model_of_dbd),
        model(MakeMujocoModel(drive, model_of_dbd, contact)),
        data(mj_makeData(model.get())),
        driver(model_of_dbd, Path(), {.target_speed = drive.target_speed}) {
    for (const WheelModel& wheel : vehicle.wheels) {
      wheels.push_back(FindMujocoWheel(*model, wheel));
      struts.push_back(WheelStrutOf(vehicle, wheel));
    }
    driver.SetStart(Eigen::Vector2d::Zero(), 0);
  }

  BodyState<double> Chassis() const;
  void Apply(const DriverCommand& command);

  const Scenario& scenario;
  const VehicleModel& vehicle;
  MujocoModel model;
  MujocoData data;
  std::vector<MujocoWheelAddress> wheels;
  std::vector<WheelStrut> struts;
  Driver driver;
  DriverState driver_state;
  PowertrainState powertrain;
  WheelControls<double> controls{};
};

BodyState<double> MujocoVehicle::Impl::Chassis() const {
  const mjtNum *q = data->qpos, *v = data->qvel;
  BodyState<double> body{};
  body.p_WB = {q[0], q[1], q[2]};
  body.q_WB = {q[3], q[4], q[5], q[6]};
  body.v_WB = {v[0], v[1], v[2]};
  body.w_WB = RotationMatrix(body.q_WB) * Vec3<double>{v[3], v[4], v[5]};
  return body;
}

/// Torques act between wheel and chassis; a brake is dry friction in the joint.
void MujocoVehicle::Impl::Apply(const DriverCommand& command) {
  WheelSpins spins{};
  for (std::size_t i = 0; i < wheels.size(); ++i) spins[i] = data->qvel[wheels[i].spin_dof];
  SetControls(vehicle, command, spins, vehicle.steps.control, powertrain, controls);
  for (std::size_t i = 0; i < wheels.size(); ++i) {
    const MujocoWheelAddress& wheel = wheels[i];
    data->qfrc_applied[wheel.spin_dof] = controls.drive_torque[i];
    model->dof_frictionloss[wheel.spin_dof] = controls.brake_torque[i];
    if (wheel.steer_q >= 0) model->qpos_spring[wheel.steer_q] = std::asin(controls.steer_sine[i]);
  }
}

MujocoVehicle::MujocoVehicle(const Scenario& scenario, const VehicleModel& vehicle,
                             MujocoContact contact)
    : impl_(std::make_unique<Impl>(scenario, vehicle, contact)) {}
MujocoVehicle::~MujocoVehicle() = default;

void MujocoVehicle::Reset() {
  mj_resetData(impl_->model.get(), impl_->data.get());
  impl_->driver_state = {};
  impl_->powertrain = {};
  impl_->controls = {};
}

void MujocoVehicle::Advance() {
  Impl& s = *impl_;
  DriverCommand command{.brake = 1};
  if (time() >= s.scenario.standing_time - 1e-9) {
    command = s.driver.Update(ViewOfDriver(s.vehicle, s.Chassis()), control_step(), s.driver_state);
  }
  s.Apply(command);
  const auto steps = std::lround(control_step() / s.vehicle.steps.construction);
  for (long i = 0; i < steps; ++i) mj_step(s.model.get(), s.data.get());
}

double MujocoVehicle::time() const { return impl_->data->time; }
double MujocoVehicle::control_step() const { return impl_->vehicle.steps.control; }

double MujocoVehicle::GroundForce() const {
  double sum = 0;
  for (int i = 0; i < impl_->data->ncon; ++i) {
    mjtNum force[6];  // along the axes of the contact's frame, which are the rows of `frame`
    mj_contactForce(impl_->model.get(), impl_->data.get(), i, force);
    const mjtNum* frame = impl_->data->contact[i].frame;
    for (int axis = 0; axis < 3; ++axis) sum += force[axis] * frame[3 * axis + 2];
  }
  return std::abs(sum);
}

TrajectoryRow MujocoVehicle::Observe() const {
  const Impl& s = *impl_;
  TrajectoryRow row = ChassisRow(time(), ViewOfChassis(s.Chassis()), s.vehicle);
  const std::array<int, 4> order = WheelOrder(s.vehicle);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::size_t wheel = order[i];
    row.wheel_height[i] = s.data->xpos[3 * s.wheels[wheel].body + 2];
    row.spring_force[i] = s.struts[wheel].preload +
                          s.struts[wheel].stiffness * s.data->qpos[s.wheels[wheel].travel_q];
  }
  return row;
}

std::vector<TrajectoryRow> RecordMujoco(const Scenario& scenario, MujocoVehicle& vehicle) {
  vehicle.Reset();
  std::vector<TrajectoryRow> rows{vehicle.Observe()};
  while (vehicle.time() < scenario.duration - 1e-9) {
    vehicle.Advance();
    rows.push_back(vehicle.Observe());
  }
  return rows;
}

}  // namespace dbd
