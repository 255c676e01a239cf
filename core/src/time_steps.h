#pragma once

#include <dbd/core/vehicle_model.h>
#include <dbd/core/vehicle_report.h>

namespace dbd {

/// Critical time steps [s] of one force element on the lighter of its bodies (paper eq. 8).
struct CriticalStep {
  double translational = 0;  ///< sqrt(m / k)
  double rotational = 0;     ///< sqrt(I / (k r^2)), r the lever arm of the force about the body
};

CriticalStep CriticalStepOf(const VehicleModel& vehicle, const LinkModel& link);

/// The critical steps of all force elements, by kind and body.
std::vector<CriticalGroup> GroupCriticalSteps(const VehicleModel& vehicle);

/// The paper's rule, t_cr / 3 over the force elements of each group, rounded down to half a
/// millisecond. Capped by what was measured to stay accurate: tire geometry 4 ms, control 4 ms.
StepSizes ChooseStepSizes(const VehicleModel& vehicle);

/// Makes the slower groups whole multiples of the construction step, never slower than asked.
void SynchroniseSteps(StepSizes& steps);

}  // namespace dbd
