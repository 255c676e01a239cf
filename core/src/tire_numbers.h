#pragma once

#include <dbd/core/vehicle_model.h>

namespace dbd {

// What the force law of a tire needs to know of it, worked out once. Structs of nothing but
// numbers, of any kind: doubles as made, what lanes compute with, or a number for each lane.

template <class Number>
struct BrixiusNumbers {
  Number traction_max, mobility_rate, slip_rate, carcass_loss;
  Number resistance_mobility, resistance_slip;
};

template <class Number>
struct TireNumbers {
  Number radius, stiffness, by_stiffness, damping;
  Number area;            // width times diameter
  Number by_height;       // 5 / section height, see MobilityNumber
  Number by_shape;        // 1 / (1 + 3 width / diameter)
  Number step_by_length;  // step / relaxation length
  Number length_by_step;
  Number bristle_damping;  // per speed, at rest
  Number lateral_share;    // limit of the lateral force / of traction
  Number lateral_rate;
  BrixiusNumbers<Number> traction;
};

/// For construction steps of `step` [s].
TireNumbers<double> MakeTireNumbers(const TireModel& tire, double step);

}  // namespace dbd
