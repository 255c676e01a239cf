#include <dbd/planner/batch_evaluation.h>
#include <dbd/planner/drive.h>
#include <dbd/planner/thread_count.h>

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <mutex>

namespace dbd {
namespace {

/// No drive takes longer than this many times what its length needs at walking pace and more.
double LongestTime(const Path& path, double max_speed) {
  constexpr double kSlowestShare = 0.15;  // of max_speed, on average over the route
  constexpr double kStartAndStop = 20;    // [s]
  return kStartAndStop + path.length() / (kSlowestShare * max_speed);
}

Rollout DriveCandidate(const Terrain& terrain, const VehicleModel& vehicle,
                       const Candidate& candidate, const PlanOptions& options,
                       std::stop_token stop) {
  DriveOptions drive;
  drive.target_speed = options.max_speed;
  drive.duration = LongestTime(candidate.path, options.max_speed);
  drive.trace_interval = 0;
  drive.goal_tolerance = options.goal_tolerance;
  drive.stop_at_violation = true;
  return DrivePath(terrain, vehicle, candidate.path, candidate.path.Position(0),
                   candidate.path.Heading(0), drive, stop);
}

}  // namespace

std::vector<Rollout> EvaluateRollouts(const Terrain& terrain, const VehicleModel& vehicle,
                                      const std::vector<Candidate>& candidates,
                                      const PlanOptions& options, const ProgressCallback& progress,
                                      std::stop_token stop) {
  std::vector<Rollout> rollouts(candidates.size());
  std::mutex progress_mutex;
  int done = 0;
  const int total = static_cast<int>(candidates.size());
  const auto report = [&] {
    if (!progress) return;
    const std::lock_guard lock(progress_mutex);
    progress("drive", ++done, total);
  };
  tbb::task_arena arena(ThreadCount(options));
  arena.execute([&] {
    tbb::parallel_for(std::size_t{0}, candidates.size(), [&](std::size_t i) {
      rollouts[i] = DriveCandidate(terrain, vehicle, candidates[i], options, stop);
      report();
    });
  });
  return rollouts;
}

}  // namespace dbd
