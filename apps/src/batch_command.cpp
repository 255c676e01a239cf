#include "batch_command.h"

#include <dbd/core/error.h>
#include <dbd/core/vehicle_cache.h>
#include <dbd/planner/planning_service.h>
#include <dbd/terrain/terrain_cache.h>

#include <chrono>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <mutex>
#include <optional>
#include <thread>

#include "batch_answer.h"
#include "batch_request.h"
#include "batch_results.h"
#include "batch_tally.h"
#include "cli.h"
#include "console.h"
#include "interrupt.h"
#include "plan_request.h"
#include "text.h"

namespace dbd {
namespace {

/// Which share of the lines is meant: every `count`-th, counted from `index` = 1.
struct Shard {
  std::size_t index = 1;
  std::size_t count = 1;

  bool Has(std::size_t line) const { return (line - 1) % count == index - 1; }
};

Shard ParseShard(const std::string& text) {
  if (text.empty()) return {};
  Shard shard;
  char rest = 0;
  const bool read = std::sscanf(text.c_str(), "%zu/%zu%c", &shard.index, &shard.count, &rest) == 2;
  if (!read || text.find('-') != std::string::npos || shard.index < 1 ||
      shard.index > shard.count) {
    throw InputError("--shard: '" + text + "' is not I/N with I from 1 to N");
  }
  return shard;
}

/// A line of the request file: a request, or the reason why it is none.
struct RequestLine {
  std::size_t number = 0;
  std::string id;  // the number where the request names none
  std::optional<BatchRequest> request;
  std::string error;
};

RequestLine ReadRequestLine(std::size_t number, const std::string& text) {
  RequestLine line;
  line.number = number;
  try {
    line.request = ParseBatchRequest(text, "line " + std::to_string(number));
    line.id = line.request->id;
  } catch (const InputError& error) {
    line.error = error.what();
    line.id = FindRequestId(text);
  }
  if (line.id.empty()) line.id = std::to_string(number);
  return line;
}

/// One run over a request file.
class Batch {
 public:
  Batch(const BatchArguments& arguments, std::stop_token stop)
      : shard_(ParseShard(arguments.shard)),
        stop_(std::move(stop)),
        terrains_(1e9 * arguments.memory_gb),
        results_(arguments.out, arguments.resume),
        service_({.threads = arguments.threads,
                  .queue_limit = 64,
                  .layer_memory = 1e9 * arguments.memory_gb / 8}) {}

  /// Submits every line that is not answered yet, and waits for the answers.
  void Run(std::istream& requests) {
    std::string text;
    for (std::size_t line = 1; !Stopped() && std::getline(requests, text); ++line) {
      if (text.find_first_not_of(" \t\r") == std::string::npos || !shard_.Has(line)) continue;
      RequestLine request = ReadRequestLine(line, text);
      if (!IsAnswered(request)) Submit(std::move(request));
    }
    while (!Stopped() && !Drained()) Rest();
  }

  int Finish() {
    const std::lock_guard lock(mutex_);
    progress_.Clear();
    if (!failure_.empty()) throw InputError(failure_);
    std::fputs(tally_.Summary(skipped_).c_str(), stdout);
    if (tally_.answered() < submitted_) {
      PrintError("stopped; --resume goes on with the rest");
      return kExitStopped;
    }
    return tally_.errors() > 0 ? kExitBadInput : kExitOk;
  }

 private:
  bool Stopped() {
    const std::lock_guard lock(mutex_);
    return stop_.stop_requested() || !failure_.empty();
  }
  bool Drained() {
    const std::lock_guard lock(mutex_);
    return tally_.answered() == submitted_;
  }

  bool IsAnswered(const RequestLine& line) {
    const auto answered = results_.answered().find(line.number);
    if (answered == results_.answered().end()) return false;
    if (answered->second != line.id) {
      throw InputError(Format("--resume: line %zu is request '%s', but its result is of '%s'",
                              line.number, line.id.c_str(), answered->second.c_str()));
    }
    ++skipped_;
    return true;
  }

  void Submit(RequestLine line) {
    {
      const std::lock_guard lock(mutex_);
      ++submitted_;
    }
    PlanJob job;
    if (line.request) job.priority = line.request->priority;
    job.on_end = [this, number = line.number, id = line.id](const JobResult& result) {
      Answer(number, id, result);
    };
    job.prepare = [this, line = std::move(line)] { return Prepare(line); };
    while (!Stopped() && !service_.TrySubmit(std::move(job))) Rest();
  }

  static void Rest() { std::this_thread::sleep_for(std::chrono::milliseconds(5)); }

  PlanInputs Prepare(const RequestLine& line) {
    if (!line.request) throw InputError(line.error);
    const BatchRequest& request = *line.request;
    TerrainFiles files = MakeTerrainFiles(request.plan.terrain);
    const bool map = request.plan.coordinates == Coordinates::kMap;
    (map ? files.places : files.wgs84_places) = {request.start.xy, request.goal.xy};
    PlanInputs inputs;
    inputs.terrain = terrains_.Get(files);
    inputs.vehicle = vehicles_.Get(request.plan.vehicle);
    inputs.options = MakePlanOptions(request.plan);
    inputs.request =
        MakePlanRequest({"start", request.start, request.plan.coordinates},
                        {"goal", request.goal, request.plan.coordinates}, *inputs.terrain);
    return inputs;
  }

  /// Cancelled requests are not answered: the next run does them.
  void Answer(std::size_t line, const std::string& id, const JobResult& result) {
    if (result.state == JobState::kCancelled) return;
    const std::string text = BatchAnswer(line, id, result);
    const std::lock_guard lock(mutex_);
    if (!failure_.empty()) return;
    try {
      results_.Append(text);
    } catch (const InputError& error) {
      failure_ = error.what();
      return;
    }
    tally_.Add(result);
    tally_.Show(submitted_, progress_);
  }

  const Shard shard_;
  const std::stop_token stop_;
  std::mutex mutex_;
  std::string failure_;  // why results can no longer be written
  std::size_t submitted_ = 0;
  std::size_t skipped_ = 0;
  BatchTally tally_{"requests"};
  ProgressLine progress_;
  TerrainCache terrains_;
  VehicleCache vehicles_;
  BatchResults results_;
  PlanningService service_;  // last: it ends before what its jobs use
};

int Answer(const BatchArguments& arguments, std::istream& requests, const std::stop_token& stop) {
  Batch batch(arguments, stop);
  batch.Run(requests);
  return batch.Finish();
}

}  // namespace

int RunBatch(const BatchArguments& arguments) {
  if (arguments.merge) {
    MergeBatchResults(arguments.requests, arguments.out);
    return kExitOk;
  }
  Interrupt interrupt;
  if (arguments.requests.size() != 1) throw InputError("REQUESTS: one file, or - for stdin");
  const std::string& file = arguments.requests.front();
  if (file == "-") return Answer(arguments, std::cin, interrupt.token());
  std::ifstream requests(file);
  if (!requests) throw InputError(file + ": cannot be opened");
  return Answer(arguments, requests, interrupt.token());
}

}  // namespace dbd
