#include "lane_batch.h"

#include <algorithm>
#include <numeric>

namespace dbd {

/// Looks before it counts, so that asking again and again at the end never overflows the counter.
std::optional<std::size_t> DriveQueue::TakeNext() {
  if (empty()) return std::nullopt;
  const std::size_t taken = next++;
  return taken < order.size() ? std::optional(order[taken]) : std::nullopt;
}

std::vector<std::size_t> StartingOrder(const std::vector<DriveTask>& tasks, std::size_t lanes,
                                       bool best_first) {
  std::vector<std::size_t> order(tasks.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const std::size_t waiting = tasks.size() - std::min(lanes, tasks.size());
  const std::size_t sorted = best_first ? std::min(lanes, waiting) : tasks.size();
  std::stable_sort(order.end() - static_cast<std::ptrdiff_t>(sorted), order.end(),
                   [&](std::size_t a, std::size_t b) {
                     return tasks[a].path->length() > tasks[b].path->length();
                   });
  return order;
}

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
    Narrow(queue);
    lanes_.Advance(commands_);
  }
}

/// Free lanes take the next drives; returns whether any lane has one.
bool LaneBatch::Refill(DriveQueue& queue) {
  bool any = false;
  for (int lane = 0; lane < lanes_.lanes(); ++lane) {
    Slot& slot = slots_[static_cast<std::size_t>(lane)];
    if (!slot.session) {
      if (const std::optional<std::size_t> task = queue.TakeNext()) Begin(lane, *task, queue);
    }
    any = any || slot.session;
  }
  return any;
}

void LaneBatch::Begin(int lane, std::size_t task_index, const DriveQueue& queue) {
  const DriveTask& task = queue.tasks[task_index];
  Slot& slot = slots_[static_cast<std::size_t>(lane)];
  slot.task = task_index;
  slot.session = std::make_unique<DriveSession>(terrain_, vehicle_, *task.path, task.start,
                                                task.heading, task.options, lanes_.control_step());
  slot.steps_to_look = 0;
  lanes_.Place(lane, task.start, task.heading);
}

/// Looks at the vehicle where that is due, and asks its driver; in between the command holds.
void LaneBatch::Serve(int lane, DriveQueue& queue) {
  Slot& slot = slots_[static_cast<std::size_t>(lane)];
  if (!slot.session || !lanes_.driving(lane)) return;
  if (lanes_.time(lane) > 0) slot.session->Feel(lanes_.VerticalAcceleration(lane));
  if (slot.steps_to_look == 0) {
    lanes_.Observe(lane, snapshot_);
    if (slot.session->Look(snapshot_, lanes_.IsSane(lane), lanes_.drive_energy(lane))) {
      lanes_.Park(lane);
      Finish(slot, queue);
      return;
    }
    commands_[static_cast<std::size_t>(lane)] = slot.session->Decide(snapshot_);
    slot.steps_to_look = slot.session->steps_to_look();
  }
  --slot.steps_to_look;
}

/// The last drives go on in a narrower pack as soon as one takes them all: it steps faster.
void LaneBatch::Narrow(const DriveQueue& queue) {
  if (!queue.empty() || !lanes_.at_period()) return;
  const auto drives = static_cast<std::size_t>(std::count_if(
      slots_.begin(), slots_.end(), [](const Slot& slot) { return slot.session != nullptr; }));
  const LaneKind kind = LanesFor(drives);
  if (drives == 0 || LaneCount(kind) >= slots_.size()) return;
  LaneBatch narrow(terrain_, vehicle_, kind);
  std::size_t to = 0;
  for (std::size_t from = 0; from < slots_.size(); ++from) {
    if (!slots_[from].session) continue;
    narrow.lanes_.TakeOver(static_cast<int>(to), lanes_, static_cast<int>(from));
    narrow.slots_[to] = std::move(slots_[from]);
    narrow.commands_[to++] = commands_[from];
  }
  lanes_ = std::move(narrow.lanes_);
  slots_ = std::move(narrow.slots_);
  commands_ = std::move(narrow.commands_);
}

void LaneBatch::Finish(Slot& slot, DriveQueue& queue) {
  queue.rollouts[slot.task] = slot.session->TakeRollout();
  slot.session.reset();
  queue.on_done(queue.rollouts[slot.task]);
}

void LaneBatch::CancelAll(DriveQueue& queue) {
  for (Slot& slot : slots_) {
    if (!slot.session) continue;
    slot.session->Cancel();
    Finish(slot, queue);
  }
  while (const std::optional<std::size_t> task = queue.TakeNext()) {
    queue.rollouts[*task].outcome = Outcome::kCancelled;
    queue.rollouts[*task].reason = "cancelled";
    queue.on_done(queue.rollouts[*task]);
  }
}

LaneKind LanesFor(std::size_t drives) {
  if (!LaneKindAvailable(LaneKind::kFloat4)) return LaneKind::kFloat4Plain;
  if (drives <= 4) return LaneKind::kFloat4;
  if (drives <= 8 || !LaneKindAvailable(LaneKind::kFloat16)) return LaneKind::kFloat8;
  return LaneKind::kFloat16;
}

std::size_t LaneCount(LaneKind kind) {
  if (kind == LaneKind::kFloat16) return 16;
  return kind == LaneKind::kFloat8 ? 8 : 4;
}

}  // namespace dbd
