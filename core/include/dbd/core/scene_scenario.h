#pragma once

#include <dbd/core/scene.h>
#include <dbd/core/trailer.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace dbd {

// Drives of many vehicles together, as data: a convoy and a road train that wind their way over
// uneven ground and stop.

struct SceneScenario {
  std::string name;
  std::string description;
  std::shared_ptr<const Ground> ground;
  std::vector<SceneVehicle> vehicles;
  SceneOptions options = {};
  double duration = 0;  ///< time for all to drive the way and stop [s]
};

struct SceneScenarioOptions {
  double target_speed = 5;  ///< [m/s]
  GapOptions gap = {};
  std::shared_ptr<const Ground> ground = {};  ///< absent: random heights up to 50 mm
};

/// `count` vehicles of one kind, standing a standing gap apart. Throws InputError when there are
/// fewer than one, or an option makes no sense.
SceneScenario MakeConvoyScenario(const std::shared_ptr<const VehicleModel>& vehicle, int count,
                                 const SceneScenarioOptions& options = {});

/// One vehicle with `trailers` trailers of one kind, none or more.
SceneScenario MakeRoadTrainScenario(const std::shared_ptr<const VehicleModel>& tractor,
                                    const TrailerModel& trailer, int trailers,
                                    const SceneScenarioOptions& options = {});

/// One vehicle at one time.
struct SceneRow {
  double t = 0;
  int vehicle = 0;
  Eigen::Vector3d p_WB = Eigen::Vector3d::Zero();  ///< centre of mass of the chassis
  double yaw = 0;
  double pitch = 0;  ///< nose down
  double roll = 0;   ///< left side up
  double speed = 0;  ///< forward
  double gap = 0;    ///< to the vehicle ahead, as Scene::Gap; 0 for the first
  double bumper_force = 0;
  double drawbar_force = 0;
  double drawbar_stretch = 0;
};

struct SceneRecord {
  std::vector<SceneRow> rows;          ///< every 0.1 s, all vehicles in turn
  double largest_bumper_force = 0;     ///< of these rows [N]
  double largest_drawbar_force = 0;    ///< magnitude [N]
  double largest_drawbar_stretch = 0;  ///< magnitude [m]
  double seconds = 0;                  ///< simulated
  int bodies = 0;
  double step = 0;         ///< construction step [s]
  bool arrived = false;    ///< the first vehicle stands at the end of the way, and all others stand
  std::uint64_t hash = 0;  ///< of the state at the end, Scene::StateHash
};

/// Drives a scenario to its end; ends early when the simulation becomes unstable.
SceneRecord RecordScene(const SceneScenario& scenario, LockstepExecutor& executor);

/// CSV with a header, SI units. Throws InputError that names the file.
void WriteSceneRows(const std::string& file, const std::vector<SceneRow>& rows);

}  // namespace dbd
