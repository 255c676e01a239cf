#pragma once

#include <cmath>
#include <cstdint>

#include "engine.h"
#include "flatten.h"
#include "initial_state.h"
#include "lane_engine.h"
#include "lane_model.h"
#include "lane_state.h"
#include "lane_surface.h"

namespace dbd {

/// The engine on packs of numbers. Every lane has its own origin near its vehicle, moved on as the
/// vehicle moves.
template <class Real>
class PackEngine final : public LaneEngine {
 public:
  static constexpr int kLanes = LaneTraits<Real>::kLanes;
  using S = ScalarOf<Real>;

  PackEngine(const VehicleModel& vehicle, const Ground& ground)
      : model_(vehicle), surface_(ground), work_(vehicle) {
    state_.bodies.resize(vehicle.bodies.size());
    state_.wheels.resize(vehicle.wheels.size());
    state_.contacts.resize(vehicle.contacts.size());
    state_.frictions.assign(vehicle.frictions.size(), Real(S(0)));
  }

  int lanes() const override { return kLanes; }

  void SetVehicle(int lane, const LaneVehicle& vehicle) override {
    surface_.SetOrigin(lane, vehicle.origin);
    const auto set = [lane](auto& packs, const auto& numbers) {
      for (std::size_t i = 0; i < packs.size(); ++i) SetLaneOf(packs[i], lane, numbers[i]);
    };
    set(state_.bodies, vehicle.state.bodies);
    set(state_.wheels, vehicle.state.wheels);
    set(state_.contacts, vehicle.state.contacts);
    for (std::size_t i = 0; i < state_.frictions.size(); ++i) {
      state_.frictions[i].v[lane] = static_cast<S>(vehicle.state.frictions[i]);
    }
    judged_ = false;
  }

  void CopyVehicle(int lane, LaneVehicle& vehicle) const override {
    vehicle.origin = surface_.origin(lane);
    const auto copy = [lane](const auto& packs, auto& numbers) {
      for (std::size_t i = 0; i < packs.size(); ++i) numbers[i] = LaneOf(packs[i], lane);
    };
    copy(state_.bodies, vehicle.state.bodies);
    copy(state_.wheels, vehicle.state.wheels);
    copy(state_.contacts, vehicle.state.contacts);
    for (std::size_t i = 0; i < state_.frictions.size(); ++i) {
      vehicle.state.frictions[i] = state_.frictions[i].v[lane];
    }
  }

  void Hold(int lane, const WheelControls<double>& controls) override {
    for (std::size_t i = 0; i < state_.wheels.size(); ++i) {
      controls_.steer_sine[i].v[lane] = static_cast<S>(controls.steer_sine[i]);
      controls_.brake_torque[i].v[lane] = static_cast<S>(controls.brake_torque[i]);
    }
  }

  void Advance(const LaneOrders& orders) override {
    MoveOrigins();
    TakeOrders(orders);
    drive_work_ = Real(S(0));
    const Vec3<Real> v_WB = state_.bodies[0].v_WB;
    for (int i = 0; i < model_.control_every; ++i) Step();
    judged_ = false;
    const BodyState<Real>& chassis = state_.bodies[0];
    vertical_acceleration_ = Real(S(1 / (model_.step * model_.control_every))) *
                             Dot(chassis.v_WB - v_WB, RotationMatrix(chassis.q_WB).z);
  }

  void Read(LaneReadings& readings) const override {
    LaneNumbers& spin = readings.driven_spin;
    for (int lane = 0; lane < kLanes; ++lane) spin[lane] = 0;
    for (const int wheel : model_.driven_wheels) {
      for (int lane = 0; lane < kLanes; ++lane) spin[lane] += state_.wheels[wheel].spin.v[lane];
    }
    const auto count = static_cast<double>(model_.driven_wheels.size());
    for (int lane = 0; lane < kLanes; ++lane) {
      spin[lane] /= count;
      readings.drive_work[lane] = drive_work_.v[lane] * model_.step;
      readings.vertical_acceleration[lane] = vertical_acceleration_.v[lane];
    }
  }

  BodyState<double> Body(int lane, int body) const override {
    BodyState<double> b = LaneOf(state_.bodies[static_cast<std::size_t>(body)], lane);
    ToWorld(lane, b.p_WB);
    return b;
  }
  WheelState<double> Wheel(int lane, int wheel) const override {
    WheelState<double> w = LaneOf(state_.wheels[static_cast<std::size_t>(wheel)], lane);
    ToWorld(lane, w.contact.p_WH);
    return w;
  }
  /// Number by number: a struct that is put together and copied at once waits for its parts.
  void ReadWheel(int lane, int wheel, LaneWheel& out) const override {
    const auto i = static_cast<std::size_t>(wheel);
    const auto body = static_cast<std::size_t>(model_.vehicle->wheels[i].body);
    const BodyState<Real>& carrier = state_.bodies[body];
    const WheelState<Real>& state = state_.wheels[i];
    const TireReport<Real>& tire = work_.tires[i];
    const auto set = [lane](double& number, const Real& pack) { number = pack.v[lane]; };
    const auto set_vector = [&set](Vec3<double>& vector, const Vec3<Real>& pack) {
      set(vector.x, pack.x), set(vector.y, pack.y), set(vector.z, pack.z);
    };
    set_vector(out.carrier.p_WB, carrier.p_WB);
    set(out.carrier.q_WB.w, carrier.q_WB.w), set(out.carrier.q_WB.x, carrier.q_WB.x);
    set(out.carrier.q_WB.y, carrier.q_WB.y), set(out.carrier.q_WB.z, carrier.q_WB.z);
    ToWorld(lane, out.carrier.p_WB);
    set(out.state.spin, state.spin);
    set_vector(out.state.contact.p_WH, state.contact.p_WH);
    set_vector(out.state.contact.p_HC_W, state.contact.p_HC_W);
    set_vector(out.state.contact.normal_W, state.contact.normal_W);
    set(out.state.contact.cone_index, state.contact.cone_index);
    ToWorld(lane, out.state.contact.p_WH);
    set(out.tire.load, tire.load), set(out.tire.slip, tire.slip);
    set(out.tire.net_traction, tire.net_traction), set(out.tire.capacity, tire.capacity);
    set(out.tire.lateral, tire.lateral), set(out.tire.deflection, tire.deflection);
    set(out.tire.drive_power, tire.drive_power);
  }
  double SpringForce(int lane, int spring) const override {
    return work_.spring_force[static_cast<std::size_t>(spring)].v[lane];
  }
  double LinkForce(int lane, int link) const override {
    return work_.link_force[static_cast<std::size_t>(link)].v[lane];
  }

  /// Looks at the whole pack at once: a lane's numbers lie far apart.
  bool IsSane(int lane) const override {
    if (!judged_) {
      FindSane();
      judged_ = true;
    }
    return sane_[lane];
  }

 private:
  void ToWorld(int lane, Vec3<double>& p) const {
    const Eigen::Vector3d& origin = surface_.origin(lane);
    p.x += origin.x(), p.y += origin.y(), p.z += origin.z();
  }

  /// Flattened, as the step of one vehicle is.
  DBD_FLATTEN void Step() {
    StepEngine(model_, surface_, controls_, state_, work_);
    for (const TireReport<Real>& tire : work_.tires) {
      drive_work_ += Max(tire.drive_power, Real(S(0)));
    }
    if (damped_) DampMotion(keep_, state_);
  }

  void TakeOrders(const LaneOrders& orders) {
    damped_ = false;
    Real torque;
    for (int lane = 0; lane < kLanes; ++lane) {
      torque.v[lane] = static_cast<S>(orders.drive_torque[lane]);
      keep_.v[lane] = static_cast<S>(orders.keep[lane]);
      damped_ = damped_ || orders.keep[lane] != 1;
    }
    for (const int wheel : model_.driven_wheels) controls_.drive_torque[wheel] = torque;
  }

  /// Zero times a number is zero unless that is infinite or none.
  void FindSane() const {
    Real faults{S(0)};
    const auto look_at = [&faults](const Vec3<Real>& v) { faults += S(0) * (v.x + v.y + v.z); };
    for (const BodyState<Real>& body : state_.bodies) {
      look_at(body.p_WB);
      look_at(body.v_WB);
      look_at(body.w_WB);
      faults += S(0) * body.q_WB.w;
    }
    for (std::size_t i = 0; i < model_.torn_force.size(); ++i) {
      const auto holds = Abs(work_.link_force[i]) < Real(static_cast<S>(model_.torn_force[i]));
      faults += Select(holds, Real(S(0)), Real(S(1)));
    }
    for (int lane = 0; lane < kLanes; ++lane) sane_[lane] = faults.v[lane] == S(0);
  }

  void MoveOrigins() {
    const Vec3<Real>& p = state_.bodies[0].p_WB;
    const Real shift{S(kOriginShift)};
    if (!AnyOf(Abs(p.x) > shift) && !AnyOf(Abs(p.y) > shift) && !AnyOf(Abs(p.z) > shift)) return;
    const auto of = [&](const Real& x) {
      return Select(x > shift, shift,
                    Select(x < Real(S(-kOriginShift)), Real(S(-kOriginShift)), Real(S(0))));
    };
    const Vec3<Real> move{of(p.x), of(p.y), of(p.z)};
    MoveOrigin(move, state_);
    for (int lane = 0; lane < kLanes; ++lane) {
      const Eigen::Vector3d by(move.x.v[lane], move.y.v[lane], move.z.v[lane]);
      if (!by.isZero()) surface_.SetOrigin(lane, surface_.origin(lane) + by);
    }
  }

  LaneModel<S> model_;
  LaneSurface<Real> surface_;
  EngineState<Real> state_;
  Workspace<Real> work_;
  WheelControls<Real> controls_{};
  Real keep_{S(1)};
  Real vertical_acceleration_{S(0)};
  Real drive_work_{S(0)};  // [J] per step length
  mutable bool sane_[kLanes] = {};
  mutable bool judged_ = false;  // whether `sane_` is of now
  bool damped_ = false;
};

}  // namespace dbd
