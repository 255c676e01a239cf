#include <dbd/planner/batch_evaluation.h>
#include <dbd/planner/drive.h>

#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>

#include <cmath>
#include <mutex>

#include "lane_batch.h"
#include "work_arena.h"

namespace dbd {
namespace {

/// No drive takes longer than this many times what its length needs at walking pace and more.
double LongestTime(const Path& path, double max_speed) {
  constexpr double kSlowestShare = 0.15;  // of max_speed, on average over the route
  constexpr double kStartAndStop = 20;    // [s]
  const auto stops = static_cast<double>(path.stretches().size());
  return kStartAndStop * stops + path.length() / (kSlowestShare * max_speed);
}

DriveTask TaskOf(const Candidate& candidate, const PlanOptions& options) {
  return {&candidate.path, candidate.path.Position(0), candidate.path.VehicleHeading(0),
          DriveOptionsFor(candidate, options)};
}

void DriveInLanes(const Terrain& terrain, const VehicleModel& vehicle, int threads, bool best_first,
                  DriveQueue& queue) {
  const auto workers = static_cast<std::size_t>(threads);
  const std::size_t drives = (queue.tasks.size() + workers - 1) / workers;
  const LaneKind kind = LanesFor(drives);
  queue.order = StartingOrder(queue.tasks, workers * LaneCount(kind), best_first);
  tbb::parallel_for(
      std::size_t{0}, workers, [&](std::size_t) { LaneBatch(terrain, vehicle, kind).Run(queue); },
      tbb::simple_partitioner());
}

void DriveOneByOne(const Terrain& terrain, const VehicleModel& vehicle, DriveQueue& queue) {
  tbb::parallel_for(std::size_t{0}, queue.tasks.size(), [&](std::size_t i) {
    const DriveTask& task = queue.tasks[i];
    queue.rollouts[i] =
        DrivePath(terrain, vehicle, *task.path, task.start, task.heading, task.options, queue.stop);
    queue.on_done(queue.rollouts[i]);
  });
}

}  // namespace

DriveOptions DriveOptionsFor(const Candidate& candidate, const PlanOptions& options) {
  DriveOptions drive;
  drive.target_speed = options.max_speed;
  drive.duration = LongestTime(candidate.path, options.max_speed);
  drive.trace_interval = 0;
  drive.goal_tolerance = options.goal_tolerance;
  drive.speed_caps = candidate.speed_caps;
  drive.stop_at_violation = true;
  return drive;
}

std::vector<Rollout> EvaluateRollouts(const Terrain& terrain, const VehicleModel& vehicle,
                                      const std::vector<Candidate>& candidates,
                                      const PlanOptions& options, const RolloutCallback& on_done,
                                      std::stop_token stop) {
  std::vector<Rollout> rollouts(candidates.size());
  std::vector<DriveTask> tasks;
  for (const Candidate& candidate : candidates) tasks.push_back(TaskOf(candidate, options));
  std::mutex report_mutex;
  const auto report = [&](const Rollout& rollout) {
    if (!on_done) return;
    const std::lock_guard lock(report_mutex);
    on_done(rollout);
  };
  DriveQueue queue{tasks, {}, rollouts, report, stop};
  WorkArena arena(options.threads);
  arena.Execute([&] {
    if (options.engine == RolloutEngine::kLanes) {
      DriveInLanes(terrain, vehicle, arena.threads(), std::isfinite(options.deadline), queue);
    } else {
      DriveOneByOne(terrain, vehicle, queue);
    }
  });
  return rollouts;
}

}  // namespace dbd
