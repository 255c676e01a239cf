#include <dbd/planner/layer_cache.h>

#include <algorithm>
#include <utility>

#include <tbb/task_arena.h>

namespace dbd {

std::shared_ptr<const TrafficabilityLayer> LayerCache::Get(
    const std::shared_ptr<const Terrain>& terrain,
    const std::shared_ptr<const VehicleModel>& vehicle, double max_speed,
    const std::stop_token& stop) {
  const auto is_meant = [&](const Entry& entry) {
    return entry.terrain.lock() == terrain && entry.vehicle.lock() == vehicle &&
           entry.max_speed == max_speed;
  };
  std::unique_lock lock(mutex_);
  DropExpired();
  auto entry = entries_.end();
  const auto nobody_makes_it = [&] {
    entry = std::find_if(entries_.begin(), entries_.end(), is_meant);
    return entry == entries_.end() || entry->layer;
  };
  if (!changed_.wait(lock, stop, nobody_makes_it)) throw StopRequested();
  if (entry != entries_.end()) {
    entries_.splice(entries_.begin(), entries_, entry);
    return entry->layer;
  }
  ++makes_;
  entry = entries_.insert(entries_.begin(), Entry{terrain, vehicle, max_speed, nullptr});
  lock.unlock();
  try {
    // Alone with its own tasks: another of the caller's might wait for this very layer.
    auto layer = tbb::this_task_arena::isolate([&] {
      return std::make_shared<const TrafficabilityLayer>(*terrain, *vehicle, max_speed,
                                                         TrafficabilityOptions(), stop);
    });
    lock.lock();
    Keep(entry, layer);
    return layer;
  } catch (...) {
    if (!lock.owns_lock()) lock.lock();
    entries_.erase(entry);
    changed_.notify_all();
    throw;
  }
}

/// Makes room for it, or gives it up when it does not fit at all.
void LayerCache::Keep(Entries::iterator made, std::shared_ptr<const TrafficabilityLayer> layer) {
  made->layer = std::move(layer);
  for (auto at = entries_.end();
       at != entries_.begin() && static_cast<double>(Bytes()) > memory_limit_;) {
    --at;
    if (at->layer) at = entries_.erase(at);
  }
  changed_.notify_all();
}

void LayerCache::DropExpired() {
  std::erase_if(entries_, [](const Entry& entry) {
    return entry.layer && (entry.terrain.expired() || entry.vehicle.expired());
  });
}

std::size_t LayerCache::Bytes() const {
  std::size_t bytes = 0;
  for (const Entry& entry : entries_) bytes += entry.layer ? entry.layer->memory_bytes() : 0;
  return bytes;
}

std::size_t LayerCache::makes() const {
  const std::lock_guard lock(mutex_);
  return makes_;
}

std::size_t LayerCache::memory_bytes() const {
  const std::lock_guard lock(mutex_);
  return Bytes();
}

}  // namespace dbd
