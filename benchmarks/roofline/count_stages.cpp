#define DBD_NO_FLATTEN
#include "count_stages.h"

#include <stdexcept>

#include "counted_surface.h"
#include "initial_state.h"
#include "step_stages.h"

namespace dbd {
namespace {

constexpr std::int64_t kSettlingSteps = 500, kDrivingSteps = 2500;  // to x = 9 m, rough from 3 m on

static_assert(std::tuple_size_v<StageCounts> == kStages);

/// Sends each stage's operations to counts of its own.
class CountingMark {
 public:
  explicit CountingMark(StageCounts& counts) : counts_(counts) {}
  ~CountingMark() { OperationTally::counts = nullptr; }

  void Begin() { OperationTally::counts = &counts_[0]; }
  void operator()(Stage stage) {
    const auto next = static_cast<std::size_t>(stage) + 1;
    OperationTally::counts = next < kStages ? &counts_[next] : nullptr;
  }

 private:
  StageCounts& counts_;
};

struct NoMark {
  void Begin() {}
  void operator()(Stage) {}
};

template <class T>
void Register(const std::vector<T>& array) {
  OperationTally::memory.emplace_back(array.data(), array.data() + array.size());
}

template <class Real>
void RegisterMemory(const StageDrive<Real>& drive) {
  OperationTally::memory.clear();
  const EngineState<Real>& state = drive.state;
  Register(state.bodies), Register(state.wheels), Register(state.contacts);
  Register(state.frictions);
  const Workspace<Real>& work = drive.work;
  Register(work.R_WB), Register(work.wrench);
  Register(work.spring_push), Register(work.spring_force), Register(work.link_force);
  Register(work.tires), Register(work.contact_force), Register(work.friction_force);
}

template <int N>
StageCounts Count(const VehicleModel& vehicle, const Ground& ground) {
  StageDrive<Counted<N>> drive(vehicle,
                               InitialState<double>(vehicle, ground, Eigen::Vector2d::Zero(), 0));
  const CountedSurface<N> surface(ground);
  NoMark no_mark;
  Drive(drive, surface, kSettlingSteps, no_mark);
  RegisterMemory(drive);
  StageCounts counts;
  CountingMark mark(counts);
  Drive(drive, surface, kDrivingSteps, mark);
  for (OperationCounts& stage : counts) {
    stage = Expanded(stage);
    stage *= 1.0 / kDrivingSteps;
  }
  return counts;
}

}  // namespace

StageCounts CountStages(const VehicleModel& vehicle, const Ground& ground, int lanes) {
  switch (lanes) {
    case 1:
      return Count<1>(vehicle, ground);
    case 4:
      return Count<4>(vehicle, ground);
    case 8:
      return Count<8>(vehicle, ground);
    case 16:
      return Count<16>(vehicle, ground);
  }
  throw std::invalid_argument("CountStages: 1, 4, 8 or 16 lanes");
}

}  // namespace dbd
