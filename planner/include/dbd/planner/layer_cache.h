#pragma once

#include <dbd/core/vehicle_model.h>
#include <dbd/planner/trafficability.h>
#include <dbd/terrain/terrain.h>

#include <condition_variable>
#include <cstddef>
#include <list>
#include <memory>
#include <mutex>
#include <stop_token>

namespace dbd {

/// Trafficability layers that several plans share: one is made for each terrain, vehicle and speed,
/// also when several ask at the same time. Terrains and vehicles count as the same when they are
/// the same object. Safe to use from many threads.
class LayerCache {
 public:
  /// What is kept stays below `memory_limit` [bytes]; the layer asked for longest ago goes first.
  /// Layers in use live on, those of a terrain or vehicle that is gone do not stay.
  explicit LayerCache(double memory_limit) : memory_limit_(memory_limit) {}

  /// Valid as long as the terrain lives. Throws StopRequested soon after `stop` was asked to; who
  /// waits for the same layer then makes it instead.
  std::shared_ptr<const TrafficabilityLayer> Get(const std::shared_ptr<const Terrain>& terrain,
                                                 const std::shared_ptr<const VehicleModel>& vehicle,
                                                 double max_speed, const std::stop_token& stop);

  std::size_t makes() const;         ///< so far
  std::size_t memory_bytes() const;  ///< of the layers that are kept

 private:
  struct Entry {
    std::weak_ptr<const Terrain> terrain;
    std::weak_ptr<const VehicleModel> vehicle;
    double max_speed = 0;
    std::shared_ptr<const TrafficabilityLayer> layer;  // null while it is being made
  };
  using Entries = std::list<Entry>;

  std::size_t Bytes() const;
  void DropExpired();
  void Keep(Entries::iterator made, std::shared_ptr<const TrafficabilityLayer> layer);

  const double memory_limit_;
  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  Entries entries_;  // latest use first
  std::size_t makes_ = 0;
};

}  // namespace dbd
