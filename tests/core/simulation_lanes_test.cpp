#include <dbd/core/error.h>
#include <dbd/core/scenario.h>
#include <dbd/core/simulation_lanes.h>
#include <dbd/core/units.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "support/core_vehicle.h"
#include "support/lane_kinds.h"

namespace dbd {
namespace {

constexpr LaneKind kAll[] = {LaneKind::kFloat4Plain, LaneKind::kFloat4,  LaneKind::kFloat8,
                             LaneKind::kFloat16,     LaneKind::kDouble2, LaneKind::kDouble4,
                             LaneKind::kDouble8};

std::vector<LaneKind> Available(bool doubles) {
  std::vector<LaneKind> kinds;
  for (const LaneKind kind : kAll) {
    const bool is_double = LaneKindName(kind).starts_with("double");
    if (is_double == doubles && LaneKindAvailable(kind)) kinds.push_back(kind);
  }
  return kinds;
}

/// One way to drive: where, how fast, how long.
struct Task {
  Eigen::Vector2d start;
  double heading = 0;
  double speed = 4;
  double duration = 2;
};

std::vector<Task> Tasks(int count) {
  std::vector<Task> tasks;
  for (int i = 0; i < count; ++i) {
    tasks.push_back({{3.0 * i, 0.7 * i - 2}, 0.4 * i, 2.0 + 0.3 * i, 1.0 + 0.31 * (i % 4)});
  }
  return tasks;
}

/// How a drive ended: everything that the state holds, and what is seen of it.
struct End {
  std::uint64_t hash = 0;
  ChassisView chassis;
  double energy = 0;
};

/// Drives all tasks on these lanes, each taken up as soon as a lane is free.
std::vector<End> DriveAll(const Ground& ground, const std::vector<Task>& tasks, LaneKind kind,
                          const std::vector<int>& order) {
  const VehicleModel& vehicle = Tm27();
  SimulationLanes lanes(vehicle, ground, kind);
  const auto count = static_cast<std::size_t>(lanes.lanes());
  std::vector<int> task_of(count, -1);
  std::vector<DriverState> states(count);
  std::vector<std::unique_ptr<Driver>> drivers(count);
  std::vector<DriverCommand> commands(count);
  std::vector<End> ends(tasks.size());
  std::size_t next = 0, done = 0;
  while (done < tasks.size()) {
    for (std::size_t i = 0; i < count; ++i) {
      const int lane = static_cast<int>(i);
      if (task_of[i] >= 0 && lanes.time(lane) >= tasks[task_of[i]].duration) {
        ends[task_of[i]] = {lanes.StateHash(lane), lanes.Chassis(lane), lanes.drive_energy(lane)};
        task_of[i] = -1;
        ++done;
        lanes.Park(lane);
      }
      if (task_of[i] < 0 && next < order.size()) {
        const Task& task = tasks[task_of[i] = order[next++]];
        drivers[i] =
            std::make_unique<Driver>(vehicle, Path(), DriverOptions{.target_speed = task.speed});
        drivers[i]->SetStart(task.start, task.heading);
        states[i] = {};
        lanes.Place(lane, task.start, task.heading, 0.5);
      }
      if (lanes.driving(lane)) {
        commands[i] =
            drivers[i]->Update(lanes.ViewForDriver(lane), lanes.control_step(), states[i]);
      }
    }
    lanes.Advance(commands);
  }
  return ends;
}

/// The same, one after the other, by the reference.
std::vector<End> DriveAlone(const Ground& ground, const std::vector<Task>& tasks) {
  std::vector<End> ends;
  for (const Task& task : tasks) {
    Simulation simulation(Tm27(), ground);
    simulation.Place(task.start, task.heading, 0.5);
    Driver driver(Tm27(), Path(), {.target_speed = task.speed});
    driver.SetStart(task.start, task.heading);
    DriverState state;
    while (simulation.time() < task.duration) {
      simulation.Advance(
          driver.Update(simulation.ViewForDriver(), simulation.control_step(), state));
    }
    ends.push_back({0, simulation.Chassis(), simulation.drive_energy()});
  }
  return ends;
}

std::vector<int> InOrder(int count) {
  std::vector<int> order;
  for (int i = 0; i < count; ++i) order.push_back(i);
  return order;
}

std::vector<std::uint64_t> Hashes(const std::vector<End>& ends) {
  std::vector<std::uint64_t> hashes;
  for (const End& end : ends) hashes.push_back(end.hash);
  return hashes;
}

TEST(SimulationLanes, OrderPackingAndWidthChangeNoBit) {
  const auto ground = MakeRandomGround(-50, 0.15, 0.5, 3);
  const std::vector<Task> tasks = Tasks(11);
  std::vector<int> backwards = InOrder(11);
  std::reverse(backwards.begin(), backwards.end());
  const auto reference = Hashes(DriveAll(*ground, tasks, LaneKind::kFloat, InOrder(11)));
  for (const LaneKind kind : KindsWithTheSameBits()) {
    EXPECT_EQ(Hashes(DriveAll(*ground, tasks, kind, InOrder(11))), reference) << LaneKindName(kind);
    EXPECT_EQ(Hashes(DriveAll(*ground, tasks, kind, backwards)), reference) << LaneKindName(kind);
  }
  EXPECT_EQ(std::count(reference.begin(), reference.end(), reference[0]), 1);  // they do differ
}

TEST(SimulationLanes, AVehicleTakenToOtherLanesGoesOnToTheBit) {
  const auto ground = MakeRandomGround(-50, 0.15, 0.5, 3);
  const DriverCommand ahead{.steer = 0.1, .engine_torque = 40};
  for (const LaneKind kind : KindsWithTheSameBits()) {
    SimulationLanes stays(Tm27(), *ground, kind), leaves(Tm27(), *ground, kind);
    const std::vector<DriverCommand> commands(static_cast<std::size_t>(stays.lanes()), ahead);
    const auto advance = [&](SimulationLanes& lanes) { lanes.Advance(commands); };
    stays.Place(2, {1e5, 2}, 0.4, 0.5);
    leaves.Place(2, {1e5, 2}, 0.4, 0.5);
    for (int i = 0; i < 301 || !leaves.at_period(); ++i) advance(stays), advance(leaves);
    SimulationLanes narrow(Tm27(), *ground, KindsWithTheSameBits().front());
    narrow.TakeOver(0, leaves, 2);
    EXPECT_FALSE(leaves.driving(2));
    for (int i = 0; i < 200; ++i) advance(stays), narrow.Advance({ahead, ahead, ahead, ahead});
    EXPECT_GT(stays.Chassis(2).forward_speed, 1);
    EXPECT_EQ(narrow.StateHash(0), stays.StateHash(2)) << LaneKindName(kind);
    EXPECT_EQ(narrow.time(0), stays.time(2));
    EXPECT_EQ(narrow.drive_energy(0), stays.drive_energy(2));
  }
}

/// Largest differences from the reference, over the ends of all drives.
struct Differences {
  double position = 0, angle = 0, energy = 0;
};

Differences Compare(const std::vector<End>& ends, const std::vector<End>& reference) {
  Differences most;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const ChassisView &a = ends[i].chassis, &b = reference[i].chassis;
    most.position = std::max(most.position, (a.p_WB - b.p_WB).norm());
    most.angle = std::max(most.angle, a.q_WB.angularDistance(b.q_WB));
    most.energy = std::max(most.energy, std::abs(ends[i].energy / reference[i].energy - 1));
  }
  return most;
}

/// Drives lane 1 while the driver of lane 0 steers by `neighbour_steer`; returns lane 1's end.
End DriveBeside(const Ground& ground, LaneKind kind, double neighbour_steer) {
  SimulationLanes lanes(Tm27(), ground, kind);
  for (const int lane : {0, 1}) lanes.Place(lane, {0, 3.0 * lane}, 0, 0.5);
  std::vector<DriverCommand> commands(static_cast<std::size_t>(lanes.lanes()));
  commands[0] = {.steer = neighbour_steer, .engine_torque = 30};
  commands[1] = {.engine_torque = 30};
  while (lanes.time(1) < 1) lanes.Advance(commands);
  EXPECT_EQ(lanes.IsSane(0), std::isfinite(neighbour_steer));
  EXPECT_TRUE(lanes.IsSane(1));
  return {lanes.StateHash(1), lanes.Chassis(1), lanes.drive_energy(1)};
}

TEST(SimulationLanes, ADivergedNeighbourChangesNoBit) {
  const auto ground = MakeRandomGround(-50, 0.15, 0.5, 3);
  for (const LaneKind kind : kAll) {
    if (!LaneKindAvailable(kind)) continue;
    EXPECT_EQ(DriveBeside(*ground, kind, std::nan("")).hash, DriveBeside(*ground, kind, 0).hash)
        << LaneKindName(kind);
  }
}

TEST(SimulationLanes, DoubleLanesAreTheReferenceToRoundOff) {
  const auto ground = MakeRandomGround(-50, 0.15, 0.5, 3);
  const std::vector<Task> tasks = Tasks(6);
  const std::vector<End> reference = DriveAlone(*ground, tasks);
  for (const LaneKind kind : Available(true)) {
    const Differences d = Compare(DriveAll(*ground, tasks, kind, InOrder(6)), reference);
    EXPECT_LT(d.position, 1e-9) << LaneKindName(kind);
    EXPECT_LT(d.angle, 1e-7) << LaneKindName(kind);
    EXPECT_LT(d.energy, 1e-9) << LaneKindName(kind);
  }
}

TEST(SimulationLanes, FloatLanesFollowTheReferenceToATenthOfAMillimetre) {
  const auto ground = MakeRandomGround(-50, 0.15, 0.5, 3);
  const std::vector<Task> tasks = Tasks(6);
  const Differences d =
      Compare(DriveAll(*ground, tasks, LaneKind::kFloat, InOrder(6)), DriveAlone(*ground, tasks));
  EXPECT_LT(d.position, 1e-4);
  EXPECT_LT(d.angle, 2e-4);  // 0.01 deg
  EXPECT_LT(d.energy, 1e-3);
}

TEST(SimulationLanes, FarFromTheWorldsOriginFloatsAreAsExact) {
  // A plane is the same everywhere, so the drive must be too: 100 km off, 4 mm of one float.
  const auto ground = MakePlaneGround(0, 0);
  std::vector<Task> near = {{{0.1, 0.3}, 0.5, 4, 2}}, far = near;
  far[0].start += Eigen::Vector2d(1e5, -2e5);
  const End a = DriveAll(*ground, near, LaneKind::kFloat, {0})[0];
  const End b = DriveAll(*ground, far, LaneKind::kFloat, {0})[0];
  const Eigen::Vector3d moved = b.chassis.p_WB - a.chassis.p_WB - Eigen::Vector3d(1e5, -2e5, 0);
  EXPECT_GT(a.chassis.p_WB.norm(), 3);
  EXPECT_LT(moved.norm(), 1e-4);
}

TEST(SimulationLanes, SettlesBeforeItDrives) {
  const auto ground = MakePlaneGround(0, 0);
  SimulationLanes lanes(Tm27(), *ground, LaneKind::kFloat4Plain);
  lanes.Place(1, {0, 0}, 0, 0.1);
  std::vector<DriverCommand> commands(4);
  EXPECT_LT(lanes.time(1), 0);
  EXPECT_FALSE(lanes.driving(1));
  for (int i = 0; i < 25; ++i) lanes.Advance(commands);  // of 4 ms
  EXPECT_TRUE(lanes.driving(1));
  EXPECT_EQ(lanes.time(1), 0);
  EXPECT_TRUE(lanes.IsSane(1));
  EXPECT_FALSE(lanes.driving(0));
  // Statics of the TM27: 1440 N on a front wheel, 2239 N on a rear one.
  EXPECT_NEAR(lanes.Wheel(1, 0).load + lanes.Wheel(1, 1).load, 2 * 2238.8, 60);
}

TEST(SimulationLanes, RefusesLanesThatTheProcessorLacks) {
  for (const LaneKind kind : kAll) {
    if (LaneKindAvailable(kind)) continue;
    EXPECT_THROW(SimulationLanes(Tm27(), *MakePlaneGround(0, 0), kind), InputError);
  }
  EXPECT_TRUE(LaneKindAvailable(LaneKind::kFloat4Plain));
  EXPECT_EQ(LaneKindName(LaneKind::kFloat4Plain), "float x 4, plain");
}

/// Height and pitch of the first of a pack's lanes less the reference's, root mean square over a
/// whole scenario.
struct Agreement {
  double height = 0;  // [m]
  double pitch = 0;   // [rad]
};

Agreement AgreementOver(const char* name, LaneKind kind) {
  const Scenario scenario = MakeScenario(name);
  Simulation alone(Tm27(), *scenario.ground);
  alone.Place(Eigen::Vector2d::Zero(), 0, 0.5);
  SimulationLanes lanes(Tm27(), *scenario.ground, kind);
  lanes.Place(0, Eigen::Vector2d::Zero(), 0, 0.5);
  const Driver driver = [&] {
    Driver made(Tm27(), Path(), {.target_speed = scenario.target_speed});
    made.SetStart(Eigen::Vector2d::Zero(), 0);
    return made;
  }();
  DriverState state, lane_state;
  std::vector<DriverCommand> commands(static_cast<std::size_t>(lanes.lanes()));
  while (lanes.time(0) < 0) lanes.Advance(commands);  // settles
  Agreement squares;
  int steps = 0;
  while (alone.time() < scenario.duration) {
    const bool stands = alone.time() < scenario.standing_time;
    const double dt = alone.control_step();
    commands[0] =
        stands ? DriverCommand{.brake = 1} : driver.Update(lanes.ViewForDriver(0), dt, lane_state);
    lanes.Advance(commands);
    alone.Advance(stands ? DriverCommand{.brake = 1}
                         : driver.Update(alone.ViewForDriver(), dt, state));
    const ChassisView a = alone.Chassis(), b = lanes.Chassis(0);
    squares.height += std::pow(a.p_WB.z() - b.p_WB.z(), 2);
    squares.pitch += std::pow(a.pitch - b.pitch, 2);
    ++steps;
  }
  return {std::sqrt(squares.height / steps), std::sqrt(squares.pitch / steps)};
}

TEST(SimulationLanes, AgreeWithTheReferenceOverThePapersScenarios) {
  for (const char* scenario : {"A", "B", "C"}) {
    const Agreement floats = AgreementOver(scenario, LaneKind::kFloat);
    EXPECT_LT(floats.height, 1e-4) << scenario;
    EXPECT_LT(floats.pitch, Degrees(0.01)) << scenario;
    for (const LaneKind kind : Available(true)) {
      const Agreement doubles = AgreementOver(scenario, kind);
      EXPECT_LT(doubles.height, 1e-9) << scenario << " " << LaneKindName(kind);
      EXPECT_LT(doubles.pitch, 1e-9) << scenario << " " << LaneKindName(kind);
    }
    RecordProperty(std::string("height_rms_mm_") + scenario, std::to_string(1e3 * floats.height));
    RecordProperty(std::string("pitch_rms_deg_") + scenario,
                   std::to_string(ToDegrees(floats.pitch)));
  }
}

}  // namespace
}  // namespace dbd
