#pragma once

#include "tire_force.h"

namespace dbd {

/// All stages of the force law for one wheel whose hub is its body's centre of mass and whose spin
/// axis is y.
inline TireLaw<double> EvaluateTire(const TireModel& model, const BodyState<double>& body,
                                    double step, WheelState<double>& wheel) {
  const TireNumbers<double> tire = MakeTireNumbers(model, step);
  TireLaw<double> law;
  MeetGround(tire, body, {0, 0, 0}, {0, 1, 0}, wheel.contact, law);
  MeetSoil(tire, wheel, law);
  SetTraction(tire, wheel, law);
  SetLateral(tire, wheel, law);
  return law;
}

/// The engine's own, of a tire.
inline double MobilityNumberOf(const TireModel& model, double cone_index, double load,
                               double deflection) {
  const TireNumbers<double> tire = MakeTireNumbers(model, 1);
  return MobilityNumber(cone_index, load, deflection, tire.area, tire.by_height, tire.by_shape);
}

}  // namespace dbd
