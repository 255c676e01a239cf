#include "observation.h"

#include <dbd/core/units.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace dbd {
namespace {

constexpr double kLeastObstacleHeight = 0.3;  // [m] lower things are driven over or are ground

/// Of the belly, a plate between the outermost axles, in the chassis' frame.
template <std::size_t kCount>
std::array<Eigen::Vector3d, kCount> BellyPoints(const VehicleModel& vehicle) {
  constexpr int kAcross = 3, kAlong = static_cast<int>(kCount) / kAcross;
  const Eigen::Vector3d p_RB = vehicle.bodies[0].p_RB;
  const double z = vehicle.outline.belly_height - vehicle.reference_height - p_RB.z();
  const double half_width = 0.35 * vehicle.mean_track();  // inside the tires
  double rear = std::numeric_limits<double>::infinity();
  for (const AxleModel& axle : vehicle.axles) rear = std::min(rear, axle.x - p_RB.x());
  const double spacing = vehicle.wheelbase() / (kAlong - 1);
  std::array<Eigen::Vector3d, kCount> points;
  for (std::size_t i = 0; i < kCount; ++i) {
    const double along = rear + spacing * static_cast<double>(i / kAcross);
    const double across = half_width * (static_cast<double>(i % kAcross) - 1);
    points[i] = {along, across, z};
  }
  return points;
}

/// All of its print, taken as a square as wide as the tire, along the vehicle's heading `ahead`.
bool StandsOnKnownGround(const Terrain& terrain, const WheelView& wheel, double width,
                         const Eigen::Vector2d& ahead) {
  const Eigen::Vector2d corner = 0.5 * width * ahead;
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

}  // namespace

Observer::Observer(const Terrain& terrain, const VehicleModel& vehicle,
                   const SinkageOptions& sinkage)
    : terrain_(terrain),
      vehicle_(vehicle),
      sinkage_(terrain, vehicle, sinkage),
      belly_B_(BellyPoints<kBellyPoints>(vehicle)),
      weight_(vehicle.total_mass() * kGravity),
      print_reach_(0) {
  const auto [rear, front] =
      std::minmax_element(vehicle.axles.begin(), vehicle.axles.end(),
                          [](const auto& a, const auto& b) { return a.x < b.x; });
  rear_ = &*rear;
  foremost_ = &*front;
  for (const WheelModel& wheel : vehicle.wheels) {
    print_reach_ = std::max(print_reach_, wheel.tire.width);
  }
}

/// Inclination of the plane through the ground under the outermost wheels, steepest direction.
double Observer::GroundSlope(const Wheels& wheels) const {
  const std::array corners = {foremost_->left, rear_->right, foremost_->right, rear_->left};
  std::array<double, 4> x, y, z;
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Vector3d& hub = wheels[static_cast<std::size_t>(corners[i])].p_WH;
    x[i] = hub.x(), y[i] = hub.y();
  }
  terrain_.Heights(4, x.data(), y.data(), z.data());
  const auto between = [&](std::size_t a, std::size_t b) {
    return Eigen::Vector3d(x[a] - x[b], y[a] - y[b], z[a] - z[b]);
  };
  const Eigen::Vector3d normal = between(2, 3).cross(between(0, 1));
  return std::atan2(normal.head<2>().norm(), std::abs(normal.z()));
}

/// Least distance between the belly and the ground.
double Observer::BellyClearance(const ChassisView& chassis) const {
  const Eigen::Matrix3d R_WB = chassis.q_WB.toRotationMatrix();
  std::array<double, kBellyPoints> xs, ys, zs, ground;
  for (std::size_t i = 0; i < xs.size(); ++i) {
    const Eigen::Vector3d p = chassis.p_WB + R_WB * belly_B_[i];
    xs[i] = p.x(), ys[i] = p.y(), zs[i] = p.z();
  }
  terrain_.Heights(static_cast<int>(xs.size()), xs.data(), ys.data(), ground.data());
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < xs.size(); ++i) least = std::min(least, zs[i] - ground[i]);
  return least;
}

/// |left load - right load| / all: 0 even, 1 a side lifts.
double Observer::LoadTransferRatio(const Wheels& wheels) const {
  double left = 0, right = 0;
  for (const AxleModel& axle : vehicle_.axles) {
    left += wheels[static_cast<std::size_t>(axle.left)].load;
    right += wheels[static_cast<std::size_t>(axle.right)].load;
  }
  return left + right > 0 ? std::abs(left - right) / (left + right) : 0;
}

void Observer::AddDrivenWheels(const Wheels& wheels, TraceSample& sample) const {
  double reserve = 0;
  for (std::size_t i = 0; i < wheels.size(); ++i) {
    if (!vehicle_.axles[static_cast<std::size_t>(vehicle_.wheels[i].axle)].driven) continue;
    reserve += wheels[i].traction_capacity - std::abs(wheels[i].net_traction);
    sample.power += wheels[i].drive_power;
    if (std::abs(wheels[i].slip) > std::abs(sample.slip)) sample.slip = wheels[i].slip;
  }
  sample.net_traction_reserve = reserve / weight_;
}

/// Whether a box round all prints is; if not, each may still be.
bool Observer::AllOnKnownGround(const Wheels& wheels) const {
  Eigen::Vector2d low = wheels.front().p_WH.head<2>(), high = low;
  for (const WheelView& wheel : wheels) {
    low = low.cwiseMin(wheel.p_WH.head<2>());
    high = high.cwiseMax(wheel.p_WH.head<2>());
  }
  const Eigen::Vector2d reach = Eigen::Vector2d::Constant(print_reach_);
  return terrain_.IsBoxKnown(low - reach, high + reach);
}

void Observer::LookAtGround(double yaw, const Wheels& wheels, Observation& observation) const {
  if (!AllOnKnownGround(wheels)) {
    const Eigen::Vector2d ahead(std::cos(yaw), std::sin(yaw));
    for (std::size_t i = 0; i < wheels.size(); ++i) {
      if (!StandsOnKnownGround(terrain_, wheels[i], vehicle_.wheels[i].tire.width, ahead)) {
        observation.on_known_ground = false;
      }
    }
  }
  for (const WheelView& wheel : wheels) {
    const Material* material = terrain_.materials().At(wheel.p_WH.x(), wheel.p_WH.y());
    if (material == nullptr) observation.on_known_ground = false;
    if (material != nullptr && !material->passable) observation.impassable = material;
  }
}

bool Observer::HitsObstacle(const ChassisView& chassis) const {
  if (terrain_.obstacles().empty()) return false;
  const VehicleOutline& box = vehicle_.outline;
  const Eigen::Vector2d ahead(std::cos(chassis.yaw), std::sin(chassis.yaw));
  const Eigen::Vector2d center = chassis.p_WB.head<2>() + 0.5 * (box.front - box.rear) * ahead;
  return terrain_.obstacles().BlocksBox(center, chassis.yaw,
                                        {0.5 * (box.front + box.rear), box.half_width},
                                        std::max(box.height, kLeastObstacleHeight));
}

Observation Observer::Observe(const VehicleSnapshot& snapshot) const {
  const ChassisView& chassis = snapshot.chassis;
  const Wheels& wheels = snapshot.wheels;
  Observation observation;
  TraceSample& sample = observation.sample;
  sample.t = snapshot.time;
  sample.x = chassis.p_WB.x();
  sample.y = chassis.p_WB.y();
  sample.z = chassis.p_WB.z();
  sample.ground_z = terrain_.Height(sample.x, sample.y);
  sample.yaw = chassis.yaw;
  sample.pitch = chassis.pitch;
  sample.roll = chassis.roll;
  sample.speed = chassis.forward_speed;
  sample.sinkage = sinkage_.Of(wheels);
  sample.clearance = BellyClearance(chassis);
  sample.load_transfer_ratio = LoadTransferRatio(wheels);
  sample.ground_slope = GroundSlope(wheels);
  AddDrivenWheels(wheels, sample);
  LookAtGround(chassis.yaw, wheels, observation);
  observation.hits_obstacle = HitsObstacle(chassis);
  observation.up = (chassis.q_WB * Eigen::Vector3d::UnitZ()).z();
  return observation;
}

}  // namespace dbd
