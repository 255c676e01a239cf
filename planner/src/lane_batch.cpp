#include "lane_batch.h"

namespace dbd {

LaneBatch::LaneBatch(const Terrain& terrain, const VehicleModel& vehicle, LaneKind kind)
    : terrain_(terrain), vehicle_(vehicle), lanes_(vehicle, terrain, kind) {
  slots_.resize(static_cast<std::size_t>(lanes_.lanes()));
  commands_.resize(slots_.size());
}

void LaneBatch::Run(DriveQueue& queue) {
  while (Refill(queue)) {
    if (queue.stop.stop_requested()) {
      CancelAll(queue);
      return;
    }
    for (int lane = 0; lane < lanes_.lanes(); ++lane) Serve(lane, queue);
    lanes_.Advance(commands_);
  }
}

/// Free lanes take the next drives; returns whether any lane has one.
bool LaneBatch::Refill(DriveQueue& queue) {
  bool any = false;
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    Slot& slot = slots_[i];
    if (!slot.session && queue.next < queue.tasks.size()) {
      const std::size_t task_index = queue.next++;
      if (task_index < queue.tasks.size()) {
        const DriveTask& task = queue.tasks[task_index];
        slot.task = task_index;
        slot.session =
            std::make_unique<DriveSession>(terrain_, vehicle_, *task.path, task.start, task.heading,
                                           task.options, lanes_.control_step());
        slot.steps_to_look = 0;
        lanes_.Place(static_cast<int>(i), task.start, task.heading);
      }
    }
    any = any || slot.session;
  }
  return any;
}

/// Looks at the vehicle where that is due, and asks its driver.
void LaneBatch::Serve(int lane, DriveQueue& queue) {
  Slot& slot = slots_[static_cast<std::size_t>(lane)];
  if (!slot.session || !lanes_.driving(lane)) return;
  if (slot.steps_to_look == 0) {
    slot.steps_to_look = slot.session->look_every();
    lanes_.Observe(lane, snapshot_);
    if (slot.session->Look(snapshot_, lanes_.IsSane(lane), lanes_.drive_energy(lane))) {
      lanes_.Park(lane);
      Finish(slot, queue);
      return;
    }
  }
  --slot.steps_to_look;
  commands_[static_cast<std::size_t>(lane)] =
      slot.session->Command(lanes_.ViewForDriver(lane), lanes_.VerticalAcceleration(lane));
}

void LaneBatch::Finish(Slot& slot, DriveQueue& queue) {
  queue.rollouts[slot.task] = slot.session->TakeRollout();
  slot.session.reset();
  queue.on_done();
}

void LaneBatch::CancelAll(DriveQueue& queue) {
  for (Slot& slot : slots_) {
    if (!slot.session) continue;
    slot.session->Cancel();
    Finish(slot, queue);
  }
  while (queue.next < queue.tasks.size()) {
    const std::size_t task = queue.next++;
    if (task >= queue.tasks.size()) return;
    queue.rollouts[task].outcome = Outcome::kCancelled;
    queue.rollouts[task].reason = "cancelled";
    queue.on_done();
  }
}

LaneKind LanesFor(std::size_t drives) {
  if (drives <= 4 || !LaneKindAvailable(LaneKind::kFloat8)) return LaneKind::kFloat4;
  if (drives <= 8 || !LaneKindAvailable(LaneKind::kFloat16)) return LaneKind::kFloat8;
  return LaneKind::kFloat16;
}

}  // namespace dbd
