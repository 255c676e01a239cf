#include <dbd/planner/ompl_planners.h>

#include <dbd/core/error.h>
#include <dbd/planner/candidate_curve.h>
#include <dbd/planner/ompl_random.h>
#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/planners/informedtrees/ABITstar.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>

#include <algorithm>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "dubins_space.h"
#include "ompl_pose.h"
#include "reeds_shepp.h"
#include "route_objective.h"

namespace dbd {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

std::mutex silence_mutex;
int silence_count = 0;
ompl::msg::OutputHandler* silenced_handler = nullptr;

// OMPL 1.5 keeps settings of all spaces in one map, and a planner's setup deletes those of spaces
// that are gone without having synchronised with the threads that they were of: setups and ends of
// spaces come one at a time.
std::mutex settings_mutex;

template <class Space, class Validator>
ob::SpaceInformationPtr MakeSpaceOf(const TrafficabilityLayer& layer, const OmplQuery& query) {
  const auto space =
      std::make_shared<Space>(query.turning_radius, query.min_corner, query.max_corner);
  // The default, 1 % of the extent, steps over whole ditches.
  space->setLongestValidSegmentFraction(kPoseStep / space->getMaximumExtent());
  auto si = std::make_shared<ob::SpaceInformation>(space);
  si->setStateValidityChecker([&layer](const ob::State* state) {
    const Pose2 pose = ToPose(state);
    return layer.Evaluate(pose.x, pose.y, pose.heading).go();
  });
  si->setMotionValidator(std::make_shared<Validator>(si, layer));
  si->setup();
  return si;
}

ob::SpaceInformationPtr MakeSpace(const TrafficabilityLayer& layer, const OmplQuery& query) {
  if (query.reversing) return MakeSpaceOf<ReedsSheppSpace, ReedsSheppMotionValidator>(layer, query);
  return MakeSpaceOf<DubinsSpace, RouteMotionValidator>(layer, query);
}

ob::ProblemDefinitionPtr MakeProblem(const ob::SpaceInformationPtr& si,
                                     const TrafficabilityLayer& layer, const OmplQuery& query) {
  auto problem = std::make_shared<ob::ProblemDefinition>(si);
  ob::ScopedState<> state(si);
  for (const Pose2& start : query.starts) {
    SetPose(start, state.get());
    problem->addStartState(state);
  }
  auto goals = std::make_shared<ob::GoalStates>(si);
  std::vector<Eigen::Vector2d> places;
  for (const Pose2& goal : query.goals) {
    SetPose(goal, state.get());
    goals->addState(state);
    places.push_back(goal.position());
  }
  problem->setGoal(goals);
  if (!query.reversing) {
    problem->setOptimizationObjective(
        std::make_shared<RouteObjective>(si, layer, std::move(places)));
  }
  return problem;
}

// Of ABIT*. Its own 100 reached over a kilometre only after 1000 iterations what lies beside the
// straight curve; with 50, 700 find better routes in less time than 2000 did.
constexpr unsigned kSamplesPerBatch = 50;

std::shared_ptr<ob::Planner> MakePlanner(OmplPlanner planner, const ob::SpaceInformationPtr& si) {
  if (planner == OmplPlanner::kRrtConnect) return std::make_shared<og::RRTConnect>(si);
  auto abit_star = std::make_shared<og::ABITstar>(si);
  abit_star->setSamplesPerBatch(kSamplesPerBatch);
  return abit_star;
}

/// A planner with its space and its problem.
class Solver {
 public:
  Solver(OmplPlanner planner, const TrafficabilityLayer& layer, const OmplQuery& query)
      : space_(MakeSpace(layer, query)),
        problem_(MakeProblem(space_, layer, query)),
        planner_(MakePlanner(planner, space_)) {
    planner_->setProblemDefinition(problem_);
    const std::lock_guard lock(settings_mutex);
    planner_->setup();
  }
  ~Solver() {
    planner_.reset();
    problem_.reset();
    const std::lock_guard lock(settings_mutex);
    space_.reset();
  }
  Solver(const Solver&) = delete;

  const ob::ProblemDefinition& problem() const { return *problem_; }
  bool Solve(const ob::PlannerTerminationCondition& enough) {
    return planner_->solve(enough) == ob::PlannerStatus::EXACT_SOLUTION;
  }

 private:
  ob::SpaceInformationPtr space_;
  ob::ProblemDefinitionPtr problem_;
  std::shared_ptr<ob::Planner> planner_;
};

std::vector<Pose2> Waypoints(const ob::ProblemDefinition& problem, bool reversing) {
  const auto path = std::dynamic_pointer_cast<og::PathGeometric>(problem.getSolutionPath());
  if (path == nullptr) return {};
  const ob::StateSpace& space = *problem.getSpaceInformation()->getStateSpace();
  const std::vector<ob::State*>& states = path->getStates();
  std::vector<Pose2> waypoints{ToPose(states.front())};
  for (std::size_t i = 1; i < states.size(); ++i) {
    if (!reversing) {
      waypoints.push_back(ToPose(states[i]));
      continue;
    }
    const std::vector<Pose2> pieces =
        space.as<ReedsSheppSpace>()->Waypoints(states[i - 1], states[i]);
    waypoints.insert(waypoints.end(), pieces.begin(), pieces.end());
  }
  return waypoints;
}

}  // namespace

const char* OmplPlannerName(OmplPlanner planner) {
  return planner == OmplPlanner::kRrtConnect ? "rrt-connect" : "abit-star";
}

std::vector<Pose2> SolveWithOmpl(OmplPlanner planner, const TrafficabilityLayer& layer,
                                 const OmplQuery& query, std::uint64_t seed, int iterations,
                                 const std::stop_token& stop) {
  static const bool seeds_are_ours = OmplSeedsAreOurs();
  DBD_ASSERT(seeds_are_ours);
  const OmplSilence silence;
  const OmplSeedScope scope(seed);
  Solver solver(planner, layer, query);
  int calls = 0;
  const ob::PlannerTerminationCondition enough(
      [&] { return ++calls > iterations || stop.stop_requested(); });
  const bool solved = solver.Solve(enough);
  ThrowIfStopped(stop);
  if (!solved) return {};
  // Not every planner of OMPL 1.5 respects that a Dubins curve has a direction.
  const std::vector<Pose2> waypoints = Waypoints(solver.problem(), query.reversing);
  if (!AllGo(layer, DensePoses(waypoints, query.turning_radius))) return {};
  return waypoints;
}

OmplSilence::OmplSilence() {
  const std::lock_guard lock(silence_mutex);
  if (silence_count++ > 0) return;
  silenced_handler = ompl::msg::getOutputHandler();
  ompl::msg::noOutputHandler();
}

OmplSilence::~OmplSilence() {
  const std::lock_guard lock(silence_mutex);
  if (--silence_count == 0) ompl::msg::useOutputHandler(silenced_handler);
}

}  // namespace dbd
