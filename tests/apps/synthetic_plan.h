#pragma once

#include <dbd/core/vehicle_model.h>
#include <dbd/planner/plan_types.h>
#include <dbd/terrain/terrain.h>

#include "plan_command.h"
#include "plan_json.h"

namespace dbd {

/// A plan made by hand on a slope of 200 m x 100 m: candidate 0 reaches the goal straight along
/// y = 50, candidate 1 stops half way along y = 60.
struct SyntheticPlan {
  PlanArguments arguments;
  Terrain terrain;
  VehicleModel vehicle;
  PlanRequest request;
  PlanOptions options;
  Plan plan;

  PlanRecord record() const {
    return {arguments, terrain, vehicle, request, options, plan, FilesBehind(arguments)};
  }
};

inline constexpr char kUtm33[] = "EPSG:32633";

inline const Eigen::Vector2d kMapOrigin(500000, 5000000);

inline TraceSample Sample(double s, double y) {
  TraceSample sample;
  sample.t = s / 5;
  sample.s = s;
  sample.x = 20 + s;
  sample.y = y;
  sample.ground_z = 100 + 0.1 * sample.x;
  sample.z = sample.ground_z + 0.8;
  sample.pitch = -0.0997;  // atan(0.1), nose up
  sample.speed = 5;
  sample.clearance = 0.3;
  return sample;
}

inline Rollout Drive(double length, double y, Outcome outcome, const std::string& reason) {
  Rollout rollout;
  rollout.outcome = outcome;
  rollout.reason = reason;
  for (double s = 0; s <= length; s += 0.25) rollout.trace.push_back(Sample(s, y));
  const TraceSample& last = rollout.trace.back();
  rollout.place = {last.x, last.y, last.z};
  rollout.time = last.t;
  rollout.distance = length;
  rollout.energy = 36000;
  rollout.progress = length / 160;
  rollout.margins = {{"roll", 0.5, 0.1, 0.8, 40, {60, y}},
                     {"clearance", 0.02, 0.025, 0.25, 10, {30, y}}};
  return rollout;
}

inline Candidate Straight(const std::string& origin, double y) {
  return {origin, Path({{20, y}, {180, y}}), 32};
}

// `crs`: coordinate system of the map, empty for none. W's origin lies at 500000, 5000000.

/// 201 x 101 cells of 1 m that rise by 1 in 10 to the east.
inline Terrain MakeSlope(const std::string& crs) {
  const HeightMap::Grid grid{201, 101, {0, 0}, {1, 1}};
  std::vector<float> heights;
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      heights.push_back(100 + 0.1f * static_cast<float>(column));
    }
  }
  return Terrain(LocalFrame(crs, kMapOrigin), HeightMap(grid, heights), MaterialMap(Material()),
                 ObstacleMap());
}

inline SyntheticPlan MakePlan(const std::string& crs) {
  SyntheticPlan made{{}, MakeSlope(crs), {}, {}, {}, {}};
  made.vehicle.name = "test-car";
  made.vehicle.outline.height = 1.8;
  made.request = {{20, 50}, 0.0, {180, 50}, std::nullopt};
  Plan& plan = made.plan;
  plan.status = PlanStatus::kRoute;
  plan.reason = "best of 1";
  plan.chosen = 0;
  plan.candidates = {Straight("roadmap", 50), Straight("rrt_connect", 60)};
  plan.rollouts = {Drive(160, 50, Outcome::kReached, ""),
                   Drive(80, 60, Outcome::kImmobilized, "wheels spin")};
  plan.scores = {{true, 42.5, {{"time", 32}, {"energy", 7.2}, {"risk", 3.3}}}, {}};
  plan.timing = {{"candidates", 0.5}, {"rollouts", 0.25}};
  plan.simulated_time = 48;
  plan.digest = 0x00ab'cdef'0123'4567;
  return made;
}

/// The same with no route: both candidates fail.
inline SyntheticPlan MakeNoGoPlan(const std::string& crs) {
  SyntheticPlan made = MakePlan(crs);
  made.plan.status = PlanStatus::kNoGo;
  made.plan.reason = "every candidate stops at the bank";
  made.plan.chosen.reset();
  made.plan.blocked_at = Eigen::Vector3d(100, 60, 110);
  made.plan.rollouts[0] = Drive(75, 50, Outcome::kLimitExceeded, "roll");
  made.plan.scores[0] = {};
  return made;
}

}  // namespace dbd
