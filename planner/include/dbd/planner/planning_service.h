#pragma once

#include <dbd/planner/layer_cache.h>
#include <dbd/planner/plan_route.h>

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

namespace dbd {

/// Everything that one plan rests on. `options.threads` is the service's matter and not read.
struct PlanInputs {
  std::shared_ptr<const Terrain> terrain;
  std::shared_ptr<const VehicleModel> vehicle;
  PlanRequest request;
  PlanOptions options;
};

enum class JobState {
  kQueued,
  kRunning,
  kDone,       ///< there is a plan: a route, or the answer that there is none
  kFailed,     ///< an input broke a rule; `error` says which
  kCancelled,  ///< by its handle or by the end of the service
};
const char* JobStateName(JobState state);

/// What became of a job.
struct JobResult {
  JobState state = JobState::kQueued;
  std::string error;  ///< one line, when kFailed
  PlanInputs inputs;  ///< when kDone
  Plan plan;          ///< when kDone
};

/// How far a running job is.
struct JobProgress {
  std::string stage;  ///< empty before it runs
  int done = 0;
  int total = 0;
};

/// One request to the service.
struct PlanJob {
  /// Called once, on a worker of the service: loads or finds what the plan needs. What it throws
  /// makes this job fail and harms no other.
  std::function<PlanInputs()> prepare;
  int priority = 0;  ///< higher ones first; among equals first come, first served
  /// Called once when the job has ended, whatever its end, before `Handle::Wait` returns: from a
  /// worker, or from the thread that cancels it while it waits. Must not throw, nor wait for a job.
  /// May be empty.
  std::function<void(const JobResult&)> on_end = {};
};

/// Answers plans for many callers: bounded queue, shared workers, one bad request harms nobody.
///
/// Each worker takes one job at a time, so that many small requests fill the processors side by
/// side; within a job the drives are shared by threads, so that a single large one fills them too.
/// A plan is bit-identical to `PlanRoute` with the same inputs, whatever runs beside it. Jobs of
/// one terrain, vehicle and speed (the same objects: see `TerrainCache`, `VehicleCache`) share
/// their trafficability layer.
///
/// All functions are safe to call from many threads at once. The service prints nothing.
class PlanningService {
  struct Board;
  struct Job;

 public:
  struct Options {
    int threads = 0;                ///< of all jobs together; 0 = all processors
    std::size_t queue_limit = 256;  ///< jobs that wait; more make `Submit` wait
    double layer_memory = 5e8;      ///< of trafficability layers that are kept [bytes]
  };

  /// A share in one job. Copies are the same job; it may outlive the service.
  class Handle {
   public:
    JobState state() const;
    JobProgress progress() const;
    /// Asks for its end. A job that waits ends at once, one that runs as soon as it notices.
    void Cancel();
    /// Waits for the end.
    const JobResult& Wait() const;
    /// Waits for the end, but no longer than this; returns whether it has come.
    bool WaitFor(std::chrono::duration<double> longest) const;

   private:
    friend class PlanningService;
    Handle(std::shared_ptr<Board> board, std::shared_ptr<Job> job);
    std::shared_ptr<Board> board_;
    std::shared_ptr<Job> job_;
  };

  explicit PlanningService(const Options& options);
  /// Cancels every job and waits for the running ones to notice.
  ~PlanningService();
  PlanningService(const PlanningService&) = delete;
  PlanningService& operator=(const PlanningService&) = delete;

  /// Waits while the queue is full.
  Handle Submit(PlanJob job);
  /// Nothing when the queue is full; the job is then left as it was.
  std::optional<Handle> TrySubmit(PlanJob&& job);

  /// Waits until no job is waiting or running.
  void Drain();

  /// What jobs share.
  const LayerCache& layers() const { return layers_; }

 private:
  void Work(const std::stop_token& stop);
  void Run(Job& job);

  const int threads_;
  const std::size_t queue_limit_;
  LayerCache layers_;
  std::shared_ptr<Board> board_;
  std::vector<std::jthread> workers_;
};

}  // namespace dbd
