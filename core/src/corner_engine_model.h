#pragma once

#include "corner_wheels.h"
#include "wheel_spin.h"

namespace dbd {

// EngineModel in lanes, and the two places where lanes of one vehicle meet: at the chassis, which
// all corners push, and in the drive shafts.

template <class Real>
bool SamePoint(const Vec3<Real>& a, const Vec3<Real>& b) {
  return !AnyOf(Abs(a.x - b.x) + Abs(a.y - b.y) + Abs(a.z - b.z) > Real(0));
}

template <class Real>
struct CornerEngineModel {
  CornerEngineModel(const EngineModel& engine, const Corners& found);
  CornerEngineModel(const CornerEngineModel&) = delete;

  const EngineModel& whole;
  const Corners& corners;
  CornerVehicle<Real> numbers;
  const CornerVehicle<Real>* vehicle = &numbers;
  JoinedBodies joined;
  std::vector<TirePatternOf<Real>> patterns;
  std::vector<TireNumbers<Real>> tires;
  std::vector<Real> carrier_inertia;
  bool couples_shafts = whole.CouplesShafts();
  double gravity = whole.gravity;
  double step = whole.step;
  int spring_every = whole.spring_every;
  int tire_every = whole.tire_every;
};

template <class Real>
CornerVehicle<Real> MakeCornerVehicle(const VehicleModel& vehicle, const Corners& corners) {
  CornerVehicle<Real> made;
  for (const CornerRow& row : corners.bodies) {
    made.bodies.push_back(MakeCornerBody<Real>(row, vehicle));
  }
  const auto make = [&](const std::vector<CornerElements>& rows, const auto& one, auto& all) {
    for (const CornerElements& row : rows) all.push_back(one(row, vehicle));
  };
  make(corners.links, MakeCornerLink<Real>, made.links);
  make(corners.springs, MakeCornerSpring<Real>, made.springs);
  make(corners.joints, MakeCornerJoint<Real>, made.joints);
  make(corners.contacts, MakeCornerContact<Real>, made.contacts);
  make(corners.frictions, MakeCornerFriction<Real>, made.frictions);
  make(corners.loads, MakeCornerLoad<Real>, made.loads);
  make(corners.wheels, MakeCornerWheel<Real>, made.wheels);
  return made;
}

template <class Real>
CornerEngineModel<Real>::CornerEngineModel(const EngineModel& engine, const Corners& found)
    : whole(engine),
      corners(found),
      numbers(MakeCornerVehicle<Real>(*engine.vehicle, found)),
      joined(FindJoinedBodies(numbers, SamePoint<Real>)) {
  for (const CornerElements& row : found.wheels) {
    patterns.push_back(MakeCornerPattern<Real>(row, engine));
    tires.push_back(MakeCornerTire<Real>(row, engine));
    Real inertia{1};
    for (int lane = 0; lane < kCornerLanes; ++lane) {
      const int wheel = row.elements[lane];
      if (wheel != kNobody) inertia.v[lane] = engine.carrier_inertia[wheel];
    }
    carrier_inertia.push_back(inertia);
  }
}

/// The chassis stands in every lane, pushed by the corner there: all lanes get the sum.
template <class Real>
void JoinLanes(const CornerEngineModel<Real>& /*engine*/, Workspace<Real>& work) {
  const auto sum = [](Real& x) {
    x = Real((NumberOf(x, 0) + NumberOf(x, 1)) + (NumberOf(x, 2) + NumberOf(x, 3)));
  };
  Wrench<Real>& chassis = work.wrench[0];
  for (Vec3<Real>* v : {&chassis.f_W, &chassis.t_W}) {
    sum(v->x);
    sum(v->y);
    sum(v->z);
  }
}

template <class Real>
bool AnyBrake(const CornerEngineModel<Real>& engine, const WheelControls<Real>& controls) {
  Real most(0);
  for (std::size_t row = 0; row < engine.numbers.wheels.size(); ++row) {
    most = Max(most, controls.brake_torque[row]);
  }
  return AnyOf(most > Real(0));
}

/// Differentials and brakes join wheels of different lanes: they are evaluated wheel by wheel.
template <class Real>
void CoupleSpins(const CornerEngineModel<Real>& engine, const WheelControls<Real>& controls,
                 double step, const std::array<CarrierSpin<Real>, kMaxWheels>& carriers,
                 const SpinArray<Real>& inertia, SpinArray<Real>& spin,
                 SpinArray<Real>& brake_torque) {
  for (std::size_t row = 0; row < engine.numbers.wheels.size(); ++row) brake_torque[row] = Real(0);
  if (!engine.couples_shafts && !AnyBrake(engine, controls)) return;
  WheelControls<double> of_wheels;
  std::array<CarrierSpin<double>, kMaxWheels> wheel_carriers;
  SpinArray<double> wheel_inertia, wheel_spin, wheel_brake;
  const std::vector<CornerPlace>& places = engine.corners.wheel_places;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto [row, lane] = places[i];
    of_wheels.brake_torque[i] = NumberOf(controls.brake_torque[row], lane);
    wheel_carriers[i] = {NumberOf(carriers[row].rate, lane), NumberOf(carriers[row].inertia, lane)};
    wheel_inertia[i] = NumberOf(inertia[row], lane);
    wheel_spin[i] = NumberOf(spin[row], lane);
  }
  CoupleSpins(engine.whole, of_wheels, step, wheel_carriers, wheel_inertia, wheel_spin,
              wheel_brake);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto [row, lane] = places[i];
    spin[row].v[lane] = wheel_spin[i];
    brake_torque[row].v[lane] = wheel_brake[i];
  }
}

}  // namespace dbd
