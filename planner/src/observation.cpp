#include "observation.h"

#include <dbd/core/mobility.h>
#include <dbd/core/units.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace dbd {
namespace {

constexpr double kLeastObstacleHeight = 0.3;  // [m] lower things are driven over or are ground

using WheelViews = std::vector<WheelView>;

/// Inclination of the plane through the ground under the outermost wheels, steepest direction.
double GroundSlope(const Terrain& terrain, const VehicleModel& vehicle, const WheelViews& wheels) {
  const auto ground = [&](int wheel) {
    const Eigen::Vector3d& hub = wheels[static_cast<std::size_t>(wheel)].p_WH;
    return Eigen::Vector3d(hub.x(), hub.y(), terrain.Height(hub.x(), hub.y()));
  };
  const auto [rear, front] =
      std::minmax_element(vehicle.axles.begin(), vehicle.axles.end(),
                          [](const auto& a, const auto& b) { return a.x < b.x; });
  const Eigen::Vector3d one = ground(front->left) - ground(rear->right);
  const Eigen::Vector3d other = ground(front->right) - ground(rear->left);
  const Eigen::Vector3d normal = other.cross(one);
  return std::atan2(normal.head<2>().norm(), std::abs(normal.z()));
}

/// Least distance between the belly, a plate between the outermost axles, and the ground.
double BellyClearance(const Terrain& terrain, const VehicleModel& vehicle,
                      const ChassisView& chassis) {
  constexpr int kAlong = 5, kAcross = 3;
  const Eigen::Vector3d p_RB = vehicle.bodies[0].p_RB;
  const double z = vehicle.outline.belly_height - vehicle.reference_height - p_RB.z();
  const double half_width = 0.35 * vehicle.mean_track();  // inside the tires
  double rear = std::numeric_limits<double>::infinity();
  for (const AxleModel& axle : vehicle.axles) rear = std::min(rear, axle.x - p_RB.x());
  const Eigen::Matrix3d R_WB = chassis.q_WB.toRotationMatrix();
  const double spacing = vehicle.wheelbase() / (kAlong - 1);
  std::array<double, kAlong * kAcross> xs, ys, zs, ground;
  for (std::size_t i = 0; i < xs.size(); ++i) {
    const double along = rear + spacing * static_cast<double>(i / kAcross);
    const double across = half_width * (static_cast<double>(i % kAcross) - 1);
    const Eigen::Vector3d p = chassis.p_WB + R_WB * Eigen::Vector3d(along, across, z);
    xs[i] = p.x(), ys[i] = p.y(), zs[i] = p.z();
  }
  terrain.Heights(static_cast<int>(xs.size()), xs.data(), ys.data(), ground.data());
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < xs.size(); ++i) least = std::min(least, zs[i] - ground[i]);
  return least;
}

/// Which wheel of its track it is, counted from the front.
int PassOf(const VehicleModel& vehicle, const WheelModel& wheel) {
  const double x = vehicle.axles[static_cast<std::size_t>(wheel.axle)].x;
  return 1 + static_cast<int>(std::count_if(vehicle.axles.begin(), vehicle.axles.end(),
                                            [x](const AxleModel& axle) { return axle.x > x; }));
}

double DeepestSinkage(const Terrain& terrain, const VehicleModel& vehicle, const WheelViews& wheels,
                      const SinkageOptions& options) {
  double deepest = 0;
  for (std::size_t i = 0; i < wheels.size(); ++i) {
    const WheelView& wheel = wheels[i];
    if (wheel.load <= 0) continue;
    SoilSample soil = terrain.Soil(wheel.contact_W.x(), wheel.contact_W.y());
    soil.cone_index = wheel.cone_index;
    const WheelModel& model = vehicle.wheels[i];
    deepest = std::max(deepest, WheelSinkage(model.tire, soil, wheel.load, wheel.deflection,
                                             wheel.slip, PassOf(vehicle, model), options));
  }
  return deepest;
}

/// |left load - right load| / all: 0 even, 1 a side lifts.
double LoadTransferRatio(const VehicleModel& vehicle, const WheelViews& wheels) {
  double left = 0, right = 0;
  for (const AxleModel& axle : vehicle.axles) {
    left += wheels[static_cast<std::size_t>(axle.left)].load;
    right += wheels[static_cast<std::size_t>(axle.right)].load;
  }
  return left + right > 0 ? std::abs(left - right) / (left + right) : 0;
}

void AddDrivenWheels(const VehicleModel& vehicle, const WheelViews& wheels, TraceSample& sample) {
  double reserve = 0;
  for (std::size_t i = 0; i < wheels.size(); ++i) {
    if (!vehicle.axles[static_cast<std::size_t>(vehicle.wheels[i].axle)].driven) continue;
    reserve += wheels[i].traction_capacity - std::abs(wheels[i].net_traction);
    sample.power += wheels[i].drive_power;
    if (std::abs(wheels[i].slip) > std::abs(sample.slip)) sample.slip = wheels[i].slip;
  }
  sample.net_traction_reserve = reserve / (vehicle.total_mass() * kGravity);
}

/// All of its print, taken as a square as wide as the tire, along the vehicle's heading.
bool StandsOnKnownGround(const Terrain& terrain, const WheelView& wheel, double width, double yaw) {
  const Eigen::Vector2d corner = 0.5 * width * Eigen::Vector2d(std::cos(yaw), std::sin(yaw));
  const Eigen::Vector2d diagonal(corner.x() - corner.y(), corner.y() + corner.x());
  const Eigen::Vector2d other(-diagonal.y(), diagonal.x());
  const Eigen::Vector2d hub = wheel.p_WH.head<2>();
  for (const Eigen::Vector2d& place :
       {hub, Eigen::Vector2d(hub + diagonal), Eigen::Vector2d(hub - diagonal),
        Eigen::Vector2d(hub + other), Eigen::Vector2d(hub - other)}) {
    if (!terrain.IsKnown(place.x(), place.y())) return false;
  }
  return true;
}

void LookAtGround(const Terrain& terrain, const VehicleModel& vehicle, double yaw,
                  const WheelViews& wheels, Observation& observation) {
  for (std::size_t i = 0; i < wheels.size(); ++i) {
    if (!StandsOnKnownGround(terrain, wheels[i], vehicle.wheels[i].tire.width, yaw)) {
      observation.on_known_ground = false;
    }
    const Material* material = terrain.materials().At(wheels[i].p_WH.x(), wheels[i].p_WH.y());
    if (material == nullptr) observation.on_known_ground = false;
    if (material != nullptr && !material->passable) observation.impassable = material;
  }
}

bool HitsObstacle(const Terrain& terrain, const VehicleModel& vehicle, const ChassisView& chassis) {
  if (terrain.obstacles().empty()) return false;
  const VehicleOutline& box = vehicle.outline;
  const Eigen::Vector2d ahead(std::cos(chassis.yaw), std::sin(chassis.yaw));
  const Eigen::Vector2d center = chassis.p_WB.head<2>() + 0.5 * (box.front - box.rear) * ahead;
  return terrain.obstacles().BlocksBox(center, chassis.yaw,
                                       {0.5 * (box.front + box.rear), box.half_width},
                                       std::max(box.height, kLeastObstacleHeight));
}

}  // namespace

Observation Observe(const VehicleSnapshot& snapshot, const Terrain& terrain,
                    const VehicleModel& vehicle, const SinkageOptions& sinkage) {
  const ChassisView& chassis = snapshot.chassis;
  const WheelViews& wheels = snapshot.wheels;
  Observation observation;
  TraceSample& sample = observation.sample;
  sample.t = snapshot.time;
  sample.x = chassis.p_WB.x();
  sample.y = chassis.p_WB.y();
  sample.z = chassis.p_WB.z();
  sample.ground_z = terrain.Height(sample.x, sample.y);
  sample.yaw = chassis.yaw;
  sample.pitch = chassis.pitch;
  sample.roll = chassis.roll;
  sample.speed = chassis.forward_speed;
  sample.sinkage = DeepestSinkage(terrain, vehicle, wheels, sinkage);
  sample.clearance = BellyClearance(terrain, vehicle, chassis);
  sample.load_transfer_ratio = LoadTransferRatio(vehicle, wheels);
  sample.ground_slope = GroundSlope(terrain, vehicle, wheels);
  AddDrivenWheels(vehicle, wheels, sample);
  LookAtGround(terrain, vehicle, chassis.yaw, wheels, observation);
  observation.hits_obstacle = HitsObstacle(terrain, vehicle, chassis);
  observation.up = (chassis.q_WB * Eigen::Vector3d::UnitZ()).z();
  return observation;
}

}  // namespace dbd
