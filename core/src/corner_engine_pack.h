#pragma once

#include "corner_engine.h"
#include "corner_engine_model.h"
#include "engine.h"
#include "flatten.h"
#include "initial_state.h"
#include "lane_state.h"
#include "lane_surface.h"

namespace dbd {

/// Positions are in the world's axes from the ground's south-west corner, where it is a raster.
template <class Real>
class PackCornerEngine final : public CornerEngine {
 public:
  PackCornerEngine(const EngineModel& engine, const Corners& corners, const Ground& ground)
      : corners_(corners), model_(engine, corners_), surface_(ground), work_(model_.numbers) {
    if (const auto grid = ground.Grid()) origin_ = {grid->x0, grid->y0, 0};
    for (int lane = 0; lane < kCornerLanes; ++lane) surface_.SetOrigin(lane, origin_);
    state_.bodies.resize(corners_.bodies.size());
    state_.wheels.resize(corners_.wheels.size());
    state_.contacts.resize(corners_.contacts.size());
    state_.frictions.assign(corners_.frictions.size(), Real(0));
  }

  void SetState(const EngineState<double>& state) override {
    state_.step = state.step;
    for (int lane = 0; lane < kCornerLanes; ++lane) {
      for (std::size_t row = 0; row < corners_.bodies.size(); ++row) {
        const int body = corners_.bodies[row][lane];
        BodyState<double> b = state.bodies[body == kNobody ? 0 : body];
        Shift(-1, b.p_WB);
        SetLaneOf(state_.bodies[row], lane, b);
      }
      for (std::size_t row = 0; row < corners_.wheels.size(); ++row) {
        const int wheel = corners_.wheels[row].elements[lane];
        WheelState<double> w = state.wheels[wheel == kNobody ? 0 : wheel];
        Shift(-1, w.contact.p_WH);
        SetLaneOf(state_.wheels[row], lane, w);
      }
      for (std::size_t row = 0; row < corners_.contacts.size(); ++row) {
        const int contact = corners_.contacts[row].elements[lane];
        PointContactState<double> c = state.contacts[contact == kNobody ? 0 : contact];
        Shift(-1, c.p_WG);
        SetLaneOf(state_.contacts[row], lane, c);
      }
      for (std::size_t row = 0; row < corners_.frictions.size(); ++row) {
        const int friction = corners_.frictions[row].elements[lane];
        state_.frictions[row].v[lane] = friction == kNobody ? 0 : state.frictions[friction];
      }
    }
  }

  double Advance(const WheelControls<double>& controls, double keep) override {
    LiftIdleBodies();
    TakeControls(controls);
    last_v_WB_ = LaneOf(state_.bodies[0], 0).v_WB;
    Real work{0};
    for (int i = 0; i < model_.whole.control_every; ++i) {
      Step();
      if (keep != 1) DampMotion(Real(keep), state_);
      for (const TireReport<Real>& tire : work_.tires) work += Max(tire.drive_power, Real(0));
    }
    double sum = 0;
    for (int lane = 0; lane < kCornerLanes; ++lane) sum += work.v[lane];
    return sum * model_.step;
  }

  WheelSpins Spins() const override {
    WheelSpins spins{};
    EachElement(corners_.wheels, [&](std::size_t row, int lane, int wheel) {
      spins[static_cast<std::size_t>(wheel)] = state_.wheels[row].spin.v[lane];
    });
    return spins;
  }

  void Read(EngineState<double>& state, Workspace<double>& work,
            Vec3<double>& last_v_WB) const override {
    state.step = state_.step;
    last_v_WB = last_v_WB_;
    state.bodies[0] = LaneOf(state_.bodies[0], 0);
    Shift(1, state.bodies[0].p_WB);
    EachElement(corners_.bodies, [&](std::size_t row, int lane, int body) {
      if (row == 0) return;
      state.bodies[body] = LaneOf(state_.bodies[row], lane);
      Shift(1, state.bodies[body].p_WB);
    });
    EachElement(corners_.wheels, [&](std::size_t row, int lane, int wheel) {
      state.wheels[wheel] = LaneOf(state_.wheels[row], lane);
      Shift(1, state.wheels[wheel].contact.p_WH);
      work.tires[wheel] = LaneOf(work_.tires[row], lane);
    });
    EachElement(corners_.contacts, [&](std::size_t row, int lane, int contact) {
      state.contacts[contact] = LaneOf(state_.contacts[row], lane);
      Shift(1, state.contacts[contact].p_WG);
      work.contact_force[contact] = work_.contact_force[row].v[lane];
    });
    EachElement(corners_.frictions, [&](std::size_t row, int lane, int friction) {
      state.frictions[friction] = state_.frictions[row].v[lane];
      work.friction_force[friction] = work_.friction_force[row].v[lane];
    });
    EachElement(corners_.springs, [&](std::size_t row, int lane, int spring) {
      work.spring_force[spring] = work_.spring_force[row].v[lane];
    });
    EachElement(corners_.links, [&](std::size_t row, int lane, int link) {
      work.link_force[link] = work_.link_force[row].v[lane];
    });
  }

 private:
  static const CornerRow& RowOf(const CornerRow& row) { return row; }
  static const CornerRow& RowOf(const CornerElements& row) { return row.elements; }

  /// Calls visit(row, lane, element) for every element that there is.
  template <class Rows, class Visit>
  static void EachElement(const Rows& rows, const Visit& visit) {
    for (std::size_t row = 0; row < rows.size(); ++row) {
      for (int lane = 0; lane < kCornerLanes; ++lane) {
        const int element = RowOf(rows[row])[lane];
        if (element != kNobody) visit(row, lane, element);
      }
    }
  }

  void Shift(double sign, Vec3<double>& p) const {
    p.x += sign * origin_.x(), p.y += sign * origin_.y();
  }

  /// Flattened, as the step of one vehicle is.
  DBD_FLATTEN void Step() { StepEngine(model_, surface_, controls_, state_, work_); }

  void TakeControls(const WheelControls<double>& controls) {
    EachElement(corners_.wheels, [&](std::size_t row, int lane, int wheel) {
      controls_.steer_sine[row].v[lane] = controls.steer_sine[wheel];
      controls_.drive_torque[row].v[lane] = controls.drive_torque[wheel];
      controls_.brake_torque[row].v[lane] = controls.brake_torque[wheel];
    });
  }

  /// Where a lane has no body, one falls freely: it is put back above the vehicle before it gets
  /// anywhere.
  void LiftIdleBodies() {
    for (std::size_t row = 1; row < corners_.bodies.size(); ++row) {
      for (int lane = 0; lane < kCornerLanes; ++lane) {
        if (corners_.bodies[row][lane] != kNobody) continue;
        BodyState<double> idle{};
        idle.p_WB = LaneOf(state_.bodies[0], lane).p_WB;
        idle.p_WB.z += 2 * kOutOfReach;  // away from the ends of idle elements
        idle.q_WB.w = 1;
        SetLaneOf(state_.bodies[row], lane, idle);
      }
    }
  }

  Corners corners_;
  CornerEngineModel<Real> model_;
  LaneSurface<Real> surface_;
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  EngineState<Real> state_;
  Workspace<Real> work_;
  WheelControls<Real> controls_{};
  Vec3<double> last_v_WB_{};
};

using CornerPack = Pack<double, kCornerLanes>;

}  // namespace dbd
