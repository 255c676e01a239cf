#include <dbd/core/error.h>
#include <dbd/core/scenario.h>
#include <dbd/core/scene_scenario.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dbd {
namespace {

constexpr double kRoughness = 0.05;   // [m]
constexpr double kRoughBegin = 3.0;   // [m]
constexpr double kNodeSpacing = 0.5;  // [m]
constexpr double kStopTime = 15.0;    // [s] to start and to come to rest
constexpr double kStanding = 0.05;    // [m/s]

// The way: straight, then two windings, then straight.
constexpr double kBegin = 10, kWindings = 100, kEnd = 120, kAmplitude = 2.5;  // [m]

/// `behind`: how far the way reaches back from the origin, so that every vehicle stands on it.
Path MakeWay(double behind) {
  std::vector<Eigen::Vector2d> points{{-behind - 10, 0}};
  const double wave = 4 * std::numbers::pi / kWindings;
  for (double x = kBegin; x <= kBegin + kWindings; x += 0.5) {
    // Begins and ends without a bend in the way.
    points.push_back({x, 0.5 * kAmplitude * (1 - std::cos(wave * (x - kBegin)))});
  }
  points.push_back({kEnd, 0});
  return Path(points);
}

SceneScenario Begin(const std::string& name, const VehicleModel& first,
                    const SceneScenarioOptions& options) {
  if (!(options.target_speed > 0)) throw InputError(name + ": target speed must be above 0");
  SceneScenario scenario;
  const double speed = std::min(options.target_speed, first.limits.max_speed);
  scenario.name = name;
  scenario.ground = options.ground != nullptr
                        ? options.ground
                        : MakeRandomGround(kRoughBegin, kRoughness, kNodeSpacing, 1);
  scenario.options.gap = options.gap;
  scenario.duration = kEnd / speed + kStopTime;
  return scenario;
}

std::shared_ptr<const Driver> MakeDriver(const VehicleModel& vehicle, double behind, double speed) {
  DriverOptions driver;
  driver.target_speed = speed;
  return std::make_shared<const Driver>(vehicle, MakeWay(behind), driver);
}

SceneRow Observe(const Scene& scene, int vehicle) {
  const ChassisView chassis = scene.Chassis(vehicle);
  SceneRow row;
  row.t = scene.time();
  row.vehicle = vehicle;
  row.p_WB = chassis.p_WB;
  row.yaw = chassis.yaw;
  row.pitch = chassis.pitch;
  row.roll = chassis.roll;
  row.speed = chassis.forward_speed;
  row.gap = vehicle > 0 ? scene.Gap(vehicle) : 0;
  row.bumper_force = scene.BumperForce(vehicle);
  row.drawbar_force = scene.DrawbarForce(vehicle);
  row.drawbar_stretch = scene.DrawbarStretch(vehicle);
  return row;
}

void KeepRows(const Scene& scene, SceneRecord& record) {
  const auto keep_largest = [](double& largest, double value) {
    largest = std::max(largest, std::abs(value));
  };
  for (int vehicle = 0; vehicle < scene.vehicle_count(); ++vehicle) {
    const SceneRow row = Observe(scene, vehicle);
    keep_largest(record.largest_bumper_force, row.bumper_force);
    keep_largest(record.largest_drawbar_force, row.drawbar_force);
    keep_largest(record.largest_drawbar_stretch, row.drawbar_stretch);
    record.rows.push_back(row);
  }
}

bool AllStand(const Scene& scene) {
  for (int vehicle = 0; vehicle < scene.vehicle_count(); ++vehicle) {
    if (std::abs(scene.Chassis(vehicle).forward_speed) > kStanding) return false;
  }
  return true;
}

}  // namespace

SceneScenario MakeConvoyScenario(const std::shared_ptr<const VehicleModel>& vehicle, int count,
                                 const SceneScenarioOptions& options) {
  if (count < 1) throw InputError("convoy: needs at least one vehicle");
  SceneScenario scenario = Begin("convoy", *vehicle, options);
  scenario.description = "vehicles that keep their distance over random heights up to 50 mm";
  if (options.ground != nullptr) scenario.description = "vehicles that keep their distance";
  const double spacing = vehicle->outline.front + vehicle->outline.rear + options.gap.standing_gap;
  const auto driver = MakeDriver(*vehicle, spacing * count, options.target_speed);
  for (int i = 0; i < count; ++i) {
    scenario.vehicles.push_back(
        {.model = vehicle, .position = {-spacing * i, 0}, .driver = driver, .ahead = i - 1});
  }
  scenario.duration += count * options.gap.time_gap;
  return scenario;
}

SceneScenario MakeRoadTrainScenario(const std::shared_ptr<const VehicleModel>& tractor,
                                    const TrailerModel& trailer, int trailers,
                                    const SceneScenarioOptions& options) {
  if (trailers < 0) throw InputError("road train: the number of trailers must not be negative");
  SceneScenario scenario = Begin("road-train", *tractor, options);
  scenario.description = "trailers coupled by stiff links over random heights up to 50 mm";
  if (options.ground != nullptr) scenario.description = "trailers coupled by stiff links";
  SceneVehicle first;
  first.model = tractor;
  first.driver = MakeDriver(*tractor, tractor->outline.rear, options.target_speed);
  scenario.vehicles = MakeRoadTrain(first, trailer, trailers);
  return scenario;
}

SceneRecord RecordScene(const SceneScenario& scenario, LockstepExecutor& executor) {
  constexpr double kInterval = 0.1;  // [s]
  Scene scene(scenario.vehicles, *scenario.ground, scenario.options);
  SceneRecord record;
  KeepRows(scene, record);
  while (scene.time() < scenario.duration && scene.IsSane()) {
    scene.Advance(kInterval, executor);
    KeepRows(scene, record);
  }
  record.seconds = scene.time();
  record.bodies = scene.body_count();
  record.step = scene.step();
  record.arrived = scene.IsSane() && scene.Arrived(0) && AllStand(scene);
  record.hash = scene.StateHash();
  return record;
}

}  // namespace dbd
