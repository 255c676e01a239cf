#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "c_handles.h"

namespace dbd {
namespace {

/// Null before the end.
const JobResult* EndOf(const dbd_job& job) {
  return job.handle.WaitFor(std::chrono::seconds(0)) ? &job.handle.Wait() : nullptr;
}

/// Null where the job ended without one.
const Rollout* RouteOf(const JobResult& result) {
  if (result.state != JobState::kDone || !result.plan.chosen) return nullptr;
  return &result.plan.rollouts[static_cast<std::size_t>(*result.plan.chosen)];
}

dbd_plan_status StatusOf(const JobResult& result) {
  if (result.state == JobState::kCancelled) return DBD_PLAN_CANCELLED;
  switch (result.plan.status) {
    case PlanStatus::kRoute:
      return DBD_PLAN_ROUTE;
    case PlanStatus::kNoGo:
      return DBD_PLAN_NO_GO;
    case PlanStatus::kDeadline:
      return DBD_PLAN_DEADLINE;
    case PlanStatus::kCancelled:
      break;
  }
  return DBD_PLAN_CANCELLED;
}

void AddRoute(const Rollout& route, dbd_result& numbers) {
  numbers.has_route = 1;
  numbers.time = route.time;
  numbers.length = route.distance;
  numbers.energy = route.energy;
  numbers.points = route.trace.size();
}

dbd_result NumbersOf(const JobResult& result) {
  dbd_result numbers = {};
  numbers.status = StatusOf(result);
  numbers.p_go = numbers.p_go_low = numbers.p_go_high = std::nan("");
  if (result.state != JobState::kDone) return numbers;
  const Plan& plan = result.plan;
  numbers.digest = plan.digest;
  numbers.candidates = static_cast<int>(plan.rollouts.size());
  for (const Rollout& rollout : plan.rollouts)
    numbers.reached += rollout.outcome == Outcome::kReached;
  const Rollout* route = RouteOf(result);
  if (route == nullptr) return numbers;
  AddRoute(*route, numbers);
  if (plan.success.empty()) return numbers;
  if (const auto& success = plan.success[static_cast<std::size_t>(*plan.chosen)]) {
    numbers.p_go = success->p_go();
    numbers.p_go_low = success->low;
    numbers.p_go_high = success->high;
  }
  return numbers;
}

dbd_point PointOf(const TraceSample& sample, const LocalFrame& frame) {
  const Eigen::Vector2d place = frame.ToSource({sample.x, sample.y});
  return {place.x(),    place.y(),  sample.ground_z, sample.t,   sample.s,
          sample.speed, sample.yaw, sample.pitch,    sample.roll};
}

dbd_limit LimitOf(const LimitMargin& margin) {
  dbd_limit limit = {};
  std::snprintf(limit.name, sizeof limit.name, "%s", margin.name.c_str());
  limit.limit = margin.limit;
  limit.worst = margin.worst;
  limit.margin = margin.margin;
  limit.distance = margin.s;
  return limit;
}

/// Runs `body` with the result of a job that has ended and has not failed.
template <typename Body>
dbd_error WithEnd(const dbd_job& job, Body&& body) {
  const JobResult* result = EndOf(job);
  if (result == nullptr) return Failed(DBD_ERROR_NOT_ENDED, "the job has not ended");
  if (result->state == JobState::kFailed) throw InputError(result->error);
  body(*result);
  return DBD_OK;
}

}  // namespace
}  // namespace dbd

void dbd_job_free(dbd_job* job) { delete job; }

dbd_error dbd_job_get_state(const dbd_job* job, dbd_job_state* state) {
  return dbd::Guarded([&] {
    static_assert(static_cast<int>(dbd::JobState::kCancelled) == DBD_JOB_CANCELLED);
    dbd::RequireAll("dbd_job_get_state", job, state);
    *state = static_cast<dbd_job_state>(job->handle.state());
    return DBD_OK;
  });
}

dbd_error dbd_job_get_progress(const dbd_job* job, dbd_progress* progress) {
  return dbd::Guarded([&] {
    dbd::RequireAll("dbd_job_get_progress", job, progress);
    const dbd::JobProgress now = job->handle.progress();
    std::snprintf(progress->stage, sizeof progress->stage, "%s", now.stage.c_str());
    progress->done = now.done;
    progress->total = now.total;
    return DBD_OK;
  });
}

dbd_error dbd_job_wait(const dbd_job* job, double seconds) {
  return dbd::Guarded([&] {
    constexpr double kLongest = 1e8;  // a clock counts no further than some hundred years
    dbd::RequireAll("dbd_job_wait", job);
    if (std::isnan(seconds)) throw dbd::InputError("dbd_job_wait: seconds is not a number");
    if (seconds < 0) {
      job->handle.Wait();
    } else if (!job->handle.WaitFor(std::chrono::duration<double>(std::min(seconds, kLongest)))) {
      return dbd::Failed(DBD_ERROR_NOT_ENDED, "the job has not ended");
    }
    return DBD_OK;
  });
}

dbd_error dbd_job_cancel(dbd_job* job) {
  return dbd::Guarded([&] {
    dbd::RequireAll("dbd_job_cancel", job);
    job->handle.Cancel();
    return DBD_OK;
  });
}

dbd_error dbd_job_result(const dbd_job* job, dbd_result* result) {
  return dbd::Guarded([&] {
    dbd::RequireAll("dbd_job_result", job, result);
    return dbd::WithEnd(*job, [&](const dbd::JobResult& end) { *result = dbd::NumbersOf(end); });
  });
}

const char* dbd_job_reason(const dbd_job* job) {
  const dbd::JobResult* result = job == nullptr ? nullptr : dbd::EndOf(*job);
  if (result == nullptr) return "";
  return (result->error.empty() ? result->plan.reason : result->error).c_str();
}

dbd_error dbd_job_route(const dbd_job* job, dbd_point* points, size_t capacity) {
  return dbd::Guarded([&] {
    dbd::RequireAll("dbd_job_route", job, points);
    return dbd::WithEnd(*job, [&](const dbd::JobResult& end) {
      const dbd::Rollout* route = dbd::RouteOf(end);
      const std::size_t count = route == nullptr ? 0 : std::min(capacity, route->trace.size());
      for (std::size_t i = 0; i < count; ++i) {
        points[i] = dbd::PointOf(route->trace[i], end.inputs.terrain->frame());
      }
    });
  });
}

dbd_error dbd_job_limits(const dbd_job* job, dbd_limit* limits, size_t capacity, size_t* count) {
  return dbd::Guarded([&] {
    dbd::RequireAll("dbd_job_limits", job, limits, count);
    return dbd::WithEnd(*job, [&](const dbd::JobResult& end) {
      const dbd::Rollout* route = dbd::RouteOf(end);
      *count = route == nullptr ? 0 : route->margins.size();
      for (std::size_t i = 0; i < std::min(*count, capacity); ++i) {
        limits[i] = dbd::LimitOf(route->margins[i]);
      }
    });
  });
}
