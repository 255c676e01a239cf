#pragma once

#include "corner_elements.h"
#include "lane_state.h"

namespace dbd {

// The numbers of a vehicle's wheels and tires, brought into lanes.

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
          InLanes<Real>(four, &WheelModel::gyroscopic_inertia)};
}

template <class Real>
TireNumbers<Real> MakeCornerTire(const CornerElements& row, const EngineModel& engine) {
  const auto four = Pick<Real>(row.elements, engine.tires, engine.tires[0]);
  TireNumbers<Real> tire{};
  for (int lane = 0; lane < kCornerLanes; ++lane) SetLaneOf(tire, lane, *four[lane]);
  return tire;
}

/// All tires have the same number of points.
template <class Real>
TirePatternOf<Real> MakeCornerPattern(const CornerElements& row, const EngineModel& engine) {
  const auto four = Pick<Real>(row.elements, engine.patterns, engine.patterns[0]);
  TirePatternOf<Real> pattern{};
  pattern.count = engine.patterns[0].count;
  for (int lane = 0; lane < kCornerLanes; ++lane) {
    pattern.reach = std::max(pattern.reach, four[lane]->reach);
    SetLaneOf(pattern.size, lane, four[lane]->size);
    for (int i = 0; i < pattern.count; ++i) {
      SetLaneOf(pattern.points[i], lane, four[lane]->points[i]);
    }
  }
  return pattern;
}

}  // namespace dbd
