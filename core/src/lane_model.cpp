#include "lane_model.h"

#include "corner_engine_model.h"
#include "lane_state.h"

namespace dbd {

template <class S>
LaneModel<S>::LaneModel(const VehicleModel& vehicle_model)
    : EngineModel(vehicle_model),
      numbers(MakeCornerVehicle<S>(vehicle_model, OneLane(vehicle_model))) {
  for (const TirePattern& pattern : EngineModel::patterns) {
    TirePatternOf<S>& own = patterns.emplace_back();
    own.reach = pattern.reach;
    own.count = pattern.count;
    own.size = NumbersAs<S>(pattern.size);
    for (int i = 0; i < pattern.count; ++i) own.points[i] = NumbersAs<S>(pattern.points[i]);
  }
  for (const TireNumbers<double>& tire : EngineModel::tires) tires.push_back(NumbersAs<S>(tire));
}

template <class S>
LaneModel<S>::~LaneModel() = default;

template struct LaneModel<float>;
template struct LaneModel<double>;

}  // namespace dbd
