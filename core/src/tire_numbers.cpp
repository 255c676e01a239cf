#include "tire_numbers.h"

#include "tire_force.h"

namespace dbd {

TireNumbers<double> MakeTireNumbers(const TireModel& tire, double step) {
  const double diameter = 2 * tire.radius, length = tire.relaxation_length;
  const BrixiusCoefficients& c = tire.traction;
  TireNumbers<double> numbers{};
  numbers.radius = tire.radius;
  numbers.stiffness = tire.stiffness;
  numbers.by_stiffness = 1 / tire.stiffness;
  numbers.damping = tire.damping;
  numbers.area = tire.width * diameter;
  numbers.by_height = 5.0 / tire.section_height;
  numbers.by_shape = 1.0 / (1.0 + 3.0 * tire.width / diameter);
  numbers.step_by_length = step / length;
  numbers.length_by_step = length / step;
  numbers.bristle_damping = kBristleTime / length;
  numbers.lateral_share = tire.lateral_limit / c.traction_max;
  numbers.lateral_rate = tire.lateral_rate;
  numbers.traction = {c.traction_max, c.mobility_rate,       c.slip_rate,
                      c.carcass_loss, c.resistance_mobility, c.resistance_slip};
  return numbers;
}

}  // namespace dbd
