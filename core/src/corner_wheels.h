#pragma once

#include "corner_elements.h"

namespace dbd {

// The numbers of a vehicle's wheels and tires, brought into lanes.

template <class Real, class Four>
CornerTire<Real> MakeCornerTire(const Four& four) {
  const auto lanes = [&](double TireModel::*field) {
    return InLanes<Real>(four, [field](const WheelModel& wheel) { return wheel.tire.*field; });
  };
  const auto brixius = [&](double BrixiusCoefficients::*field) {
    return InLanes<Real>(four,
                         [field](const WheelModel& wheel) { return wheel.tire.traction.*field; });
  };
  return {
      lanes(&TireModel::radius),
      lanes(&TireModel::width),
      lanes(&TireModel::section_height),
      lanes(&TireModel::stiffness),
      lanes(&TireModel::damping),
      lanes(&TireModel::lateral_limit),
      lanes(&TireModel::lateral_rate),
      lanes(&TireModel::relaxation_length),
      {brixius(&BrixiusCoefficients::traction_max), brixius(&BrixiusCoefficients::mobility_rate),
       brixius(&BrixiusCoefficients::slip_rate), brixius(&BrixiusCoefficients::carcass_loss),
       brixius(&BrixiusCoefficients::resistance_mobility),
       brixius(&BrixiusCoefficients::resistance_slip)}};
}

/// A wheel that is not there: like the first, out of reach of the ground.
inline WheelModel IdleWheel(const VehicleModel& vehicle) {
  WheelModel idle = vehicle.wheels[0];
  idle.p_BH = {0, 0, kOutOfReach};
  idle.gyroscopic_inertia = 0;
  return idle;
}

template <class Real>
CornerWheel<Real> MakeCornerWheel(const CornerElements& row, const VehicleModel& vehicle) {
  const WheelModel idle = IdleWheel(vehicle);
  const auto four = Pick<Real>(row.elements, vehicle.wheels, idle);
  const bool on_hub =
      std::any_of(four.begin(), four.end(), [](const WheelModel* w) { return w->steers_hub; });
  return {row.body_b,
          row.body_a,
          VectorsInLanes<Real>(four, &WheelModel::p_BH),
          on_hub,
          InLanes<Real>(four, &WheelModel::spin_inertia),
          InLanes<Real>(four, &WheelModel::gyroscopic_inertia),
          MakeCornerTire<Real>(four)};
}

template <class Real>
CornerPattern<Real> MakeCornerPattern(const CornerElements& row, const EngineModel& engine) {
  const auto four = Pick<Real>(row.elements, engine.patterns, engine.patterns[0]);
  CornerPattern<Real> pattern{};
  pattern.radius = InLanes<Real>(four, &TirePattern::radius);
  pattern.half_span = InLanes<Real>(four, &TirePattern::half_span);
  pattern.width = InLanes<Real>(four, &TirePattern::width);
  pattern.stiffness = InLanes<Real>(four, &TirePattern::stiffness);
  pattern.count = engine.patterns[0].count;
  for (const TirePattern* p : four) pattern.reach = std::max(pattern.reach, p->reach);
  for (int i = 0; i < pattern.count; ++i) {
    const auto lanes = [&](auto field) {
      return InLanes<Real>(four, [&](const TirePattern& p) { return (p.*field)[i]; });
    };
    pattern.x[i] = lanes(&TirePattern::x);
    pattern.z[i] = lanes(&TirePattern::z);
    pattern.bulge[i] = lanes(&TirePattern::bulge);
    pattern.half_by_bulge[i] = lanes(&TirePattern::half_by_bulge);
    pattern.length[i] = lanes(&TirePattern::length);
    pattern.by_length[i] = lanes(&TirePattern::by_length);
  }
  return pattern;
}

}  // namespace dbd
