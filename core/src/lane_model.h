#pragma once

#include "corner_model.h"
#include "engine_model.h"

namespace dbd {

/// The engine's model of a vehicle with the lanes' own numbers, one for all lanes: a constant that
/// need not be converted is a part of the instruction that uses it.
template <class S>
struct LaneModel : EngineModel {
  explicit LaneModel(const VehicleModel& vehicle_model);
  LaneModel(const LaneModel&) = delete;
  ~LaneModel();

  CornerVehicle<S> numbers;
  const CornerVehicle<S>* vehicle = &numbers;
  std::vector<TirePatternOf<S>> patterns;
  std::vector<TireNumbers<S>> tires;
};

// In a translation unit for any processor, as those for wide instructions use them.
extern template struct LaneModel<float>;
extern template struct LaneModel<double>;

}  // namespace dbd
