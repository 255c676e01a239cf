#include <dbd/planner/planning_service.h>
#include <dbd/planner/thread_count.h>

#include <algorithm>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <map>
#include <mutex>

namespace dbd {

const char* JobStateName(JobState state) {
  switch (state) {
    case JobState::kQueued:
      return "queued";
    case JobState::kRunning:
      return "running";
    case JobState::kDone:
      return "done";
    case JobState::kFailed:
      return "failed";
    case JobState::kCancelled:
      return "cancelled";
  }
  return "";
}

struct PlanningService::Job {
  explicit Job(PlanJob job) : what(std::move(job)) {}

  PlanJob what;
  std::stop_source stop;
  // Below: guarded by the board's mutex until `ended`, constant from then on.
  JobResult result;
  JobProgress progress;
  bool ended = false;
};

/// Where jobs wait, shared by the service, its workers and all handles.
struct PlanningService::Board {
  using Key = std::pair<int, std::uint64_t>;  // minus priority, order of arrival

  std::mutex mutex;
  std::condition_variable_any changed;
  std::map<Key, std::shared_ptr<Job>> queue;
  std::vector<std::shared_ptr<Job>> running;
  std::uint64_t arrivals = 0;

  void Add(std::shared_ptr<Job> job) {
    const int rank = -job->what.priority;
    queue.emplace(Key(rank, arrivals++), std::move(job));
    changed.notify_all();
  }

  /// The next job, once there is one; null when the service ends.
  std::shared_ptr<Job> TakeNext(const std::stop_token& stop) {
    std::unique_lock lock(mutex);
    if (!changed.wait(lock, stop, [this] { return !queue.empty(); })) return nullptr;
    std::shared_ptr<Job> job = std::move(queue.begin()->second);
    queue.erase(queue.begin());
    job->result.state = JobState::kRunning;
    running.push_back(job);
    changed.notify_all();
    return job;
  }

  /// Removes a job that still waits; returns whether it did.
  bool Withdraw(const std::shared_ptr<Job>& job) {
    const std::lock_guard lock(mutex);
    const auto waits = [&](const auto& entry) { return entry.second == job; };
    const auto found = std::find_if(queue.begin(), queue.end(), waits);
    if (found == queue.end()) return false;
    queue.erase(found);
    running.push_back(job);  // until it has been announced
    job->result.state = JobState::kCancelled;
    changed.notify_all();
    return true;
  }

  /// Tells whoever wants to know, first by its callback, that the job has ended.
  void Announce(const std::shared_ptr<Job>& job) {
    if (job->what.on_end) job->what.on_end(job->result);
    job->what = {};  // what the callbacks hold is no longer needed
    const std::lock_guard lock(mutex);
    job->ended = true;
    std::erase(running, job);
    changed.notify_all();
  }

  void Cancel(const std::shared_ptr<Job>& job) {
    job->stop.request_stop();
    if (Withdraw(job)) Announce(job);
  }
};

PlanningService::Handle::Handle(std::shared_ptr<Board> board, std::shared_ptr<Job> job)
    : board_(std::move(board)), job_(std::move(job)) {}

JobState PlanningService::Handle::state() const {
  const std::lock_guard lock(board_->mutex);
  return job_->result.state;
}

JobProgress PlanningService::Handle::progress() const {
  const std::lock_guard lock(board_->mutex);
  return job_->progress;
}

void PlanningService::Handle::Cancel() { board_->Cancel(job_); }

const JobResult& PlanningService::Handle::Wait() const {
  std::unique_lock lock(board_->mutex);
  board_->changed.wait(lock, [this] { return job_->ended; });
  return job_->result;
}

bool PlanningService::Handle::WaitFor(std::chrono::duration<double> longest) const {
  std::unique_lock lock(board_->mutex);
  return board_->changed.wait_for(lock, longest, [this] { return job_->ended; });
}

PlanningService::PlanningService(const Options& options)
    : threads_(ThreadCount(options.threads)),
      queue_limit_(std::max<std::size_t>(options.queue_limit, 1)),
      layers_(options.layer_memory),
      board_(std::make_shared<Board>()) {
  for (int i = 0; i < threads_; ++i) {
    workers_.emplace_back([this](const std::stop_token& stop) { Work(stop); });
  }
}

PlanningService::~PlanningService() {
  std::vector<std::shared_ptr<Job>> open;
  {
    const std::lock_guard lock(board_->mutex);
    for (const auto& [key, job] : board_->queue) open.push_back(job);
    open.insert(open.end(), board_->running.begin(), board_->running.end());
  }
  for (const auto& job : open) board_->Cancel(job);
  for (std::jthread& worker : workers_) worker.request_stop();
}

PlanningService::Handle PlanningService::Submit(PlanJob job) {
  auto shared = std::make_shared<Job>(std::move(job));
  std::unique_lock lock(board_->mutex);
  board_->changed.wait(lock, [this] { return board_->queue.size() < queue_limit_; });
  board_->Add(shared);
  return {board_, std::move(shared)};
}

std::optional<PlanningService::Handle> PlanningService::TrySubmit(PlanJob&& job) {
  const std::lock_guard lock(board_->mutex);
  if (board_->queue.size() >= queue_limit_) return std::nullopt;
  auto shared = std::make_shared<Job>(std::move(job));
  board_->Add(shared);
  return Handle(board_, std::move(shared));
}

void PlanningService::Drain() {
  std::unique_lock lock(board_->mutex);
  board_->changed.wait(lock, [this] { return board_->queue.empty() && board_->running.empty(); });
}

void PlanningService::Work(const std::stop_token& stop) {
  while (const std::shared_ptr<Job> job = board_->TakeNext(stop)) {
    Run(*job);
    board_->Announce(job);
  }
}

void PlanningService::Run(Job& job) {
  JobResult result;
  const auto show = [&](const std::string& stage, int done, int total) {
    const std::lock_guard lock(board_->mutex);
    job.progress = {stage, done, total};
  };
  try {
    result.inputs = job.what.prepare();
    result.inputs.options.threads = threads_;
    result.plan = PlanRoute(result.inputs.terrain, result.inputs.vehicle, result.inputs.request,
                            result.inputs.options, show, job.stop.get_token(), &layers_);
    const bool cancelled = result.plan.status == PlanStatus::kCancelled;
    result.state = cancelled ? JobState::kCancelled : JobState::kDone;
  } catch (const std::exception& error) {
    result.state = JobState::kFailed;
    result.error = error.what();
  } catch (...) {
    result.state = JobState::kFailed;
    result.error = "an exception that is no std::exception";
  }
  const std::lock_guard lock(board_->mutex);
  job.result = std::move(result);
}

}  // namespace dbd
