#pragma once

#include <dbd/core/simulation_lanes.h>
#include <dbd/planner/drive.h>

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "drive_session.h"

namespace dbd {

/// One drive of a batch.
struct DriveTask {
  const Path* path = nullptr;
  Eigen::Vector2d start = Eigen::Vector2d::Zero();
  double heading = 0;
  DriveOptions options;
};

/// Drives that several workers share: each takes the next one when a lane of its own is free.
struct DriveQueue {
  const std::vector<DriveTask>& tasks;
  std::vector<std::size_t> order;               ///< in which the tasks begin: `StartingOrder`
  std::vector<Rollout>& rollouts;               ///< slot i is task i
  std::function<void(const Rollout&)> on_done;  ///< may be called from any worker
  std::stop_token stop;
  std::atomic<std::size_t> next = 0;

  /// The next drive that nobody has taken, if any is left.
  std::optional<std::size_t> TakeNext();
  bool empty() const { return next >= order.size(); }
};

/// In which order tasks begin on so many lanes, in all threads together: the longest first, so that
/// short ones are left when lanes run out of work: a pack takes its time for one vehicle as for
/// all. `best_first`: as they come, for who may have to stop early; only the last on each lane,
/// which would end the latest, begin with the longest.
std::vector<std::size_t> StartingOrder(const std::vector<DriveTask>& tasks, std::size_t lanes,
                                       bool best_first);

/// A pack of vehicles and what drives and judges each of them. Which lane takes which drive, and
/// beside which neighbours, changes no bit of the drive.
class LaneBatch {
 public:
  LaneBatch(const Terrain& terrain, const VehicleModel& vehicle, LaneKind kind);

  /// Drives until the queue is empty and all lanes are done, or the queue's stop is asked for:
  /// what is then on its way or not begun ends with kCancelled.
  void Run(DriveQueue& queue);

 private:
  struct Slot {
    std::size_t task = 0;
    std::unique_ptr<DriveSession> session;  // null: free
    int steps_to_look = 0;
  };

  bool Refill(DriveQueue& queue);
  void Begin(int lane, std::size_t task, const DriveQueue& queue);
  void Serve(int lane, DriveQueue& queue);
  void Narrow(const DriveQueue& queue);
  void CancelAll(DriveQueue& queue);
  void Finish(Slot& slot, DriveQueue& queue);

  const Terrain& terrain_;
  const VehicleModel& vehicle_;
  SimulationLanes lanes_;
  std::vector<Slot> slots_;
  std::vector<DriverCommand> commands_;
  VehicleSnapshot snapshot_;
};

/// The narrowest lanes that take `drives` at once: fewer vehicles step faster.
LaneKind LanesFor(std::size_t drives);
/// Of a kind that `LanesFor` returns.
std::size_t LaneCount(LaneKind kind);

}  // namespace dbd
