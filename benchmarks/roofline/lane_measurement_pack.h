#pragma once

#include <type_traits>

#include "flatten.h"
#include "lane_measurement.h"
#include "lane_model.h"
#include "lane_surface.h"
#include "machine_peaks_pack.h"
#include "step_stages.h"
#include "timing_mark.h"

namespace dbd {

/// Flattened, as the engine's own step is.
template <class Real, class Engine, class Surface>
DBD_FLATTEN void DriveFlattened(StageDrive<Real, Engine>& drive, const Surface& ground,
                                std::int64_t steps, TimingMark& mark) {
  Drive(drive, ground, steps, mark);
}

template <class Real>
LaneMeasurement MeasureReal(const VehicleModel& vehicle, const Ground& ground,
                            const EngineState<double>& start) {
  constexpr std::int64_t kSettlingSteps = 500, kDrivingSteps = 2500;
  using Surface =
      std::conditional_t<LaneTraits<Real>::kLanes == 1, const Ground&, LaneSurface<Real>>;
  LaneMeasurement measurement;
  measurement.lanes = LaneTraits<Real>::kLanes;
  measurement.lane_bytes = sizeof(ScalarOf<Real>);
  using Engine =
      std::conditional_t<LaneTraits<Real>::kLanes == 1, EngineModel, LaneModel<ScalarOf<Real>>>;
  StageDrive<Real, Engine> drive(vehicle, start);
  const Surface surface(ground);
  TimingMark settling, driving;
  DriveFlattened(drive, surface, kSettlingSteps, settling);
  const MachinePeaks before = PeakMeter<Real>::Measure();
  const double begin = ThreadSeconds();
  DriveFlattened(drive, surface, kDrivingSteps, driving);
  const double seconds = ThreadSeconds() - begin;
  measurement.peaks = Mean(before, PeakMeter<Real>::Measure());
  measurement.step_seconds = seconds / static_cast<double>(kDrivingSteps * measurement.lanes);
  measurement.stage_share = driving.Shares();
  return measurement;
}

}  // namespace dbd
