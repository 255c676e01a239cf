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
      negligible_sinkage_(CareOptions().sinkage.begin * vehicle.limits.max_sinkage),
      sinkage_(terrain, vehicle, sinkage, negligible_sinkage_),
      belly_B_(BellyPoints<kBellyPoints>(vehicle)),
      weight_(vehicle.total_mass() * kGravity),
      print_reach_(0),
      negligible_slope_(CareOptions().slope.begin * vehicle.limits.max_slope) {
  const auto [rear, front] =
      std::minmax_element(vehicle.axles.begin(), vehicle.axles.end(),
                          [](const auto& a, const auto& b) { return a.x < b.x; });
  rear_ = &*rear;
  foremost_ = &*front;
  for (const WheelModel& wheel : vehicle.wheels) {
    print_reach_ = std::max(print_reach_, wheel.tire.width);
  }
}

/// All heights of a look at once: below the centre of mass, under the outermost wheels for the
/// plane through the ground there, and under the belly for the least distance from it.
void Observer::LookAtHeights(const VehicleSnapshot& snapshot, TraceSample& sample) {
  constexpr std::size_t kBelly = 1 + kCorners, kCount = kBelly + kBellyPoints;
  const ChassisView& chassis = snapshot.chassis;
  const std::array corners = {foremost_->left, rear_->right, foremost_->right, rear_->left};
  const Eigen::Matrix3d R_WB = chassis.q_WB.toRotationMatrix();
  std::array<double, kCount> x, y, z;
  std::array<double, kBellyPoints> belly;
  x[0] = chassis.p_WB.x(), y[0] = chassis.p_WB.y();
  for (std::size_t i = 0; i < kCorners; ++i) {
    const Eigen::Vector3d& hub = snapshot.wheels[static_cast<std::size_t>(corners[i])].p_WH;
    x[1 + i] = hub.x(), y[1 + i] = hub.y();
  }
  for (std::size_t i = 0; i < kBellyPoints; ++i) {
    const Eigen::Vector3d p = chassis.p_WB + R_WB * belly_B_[i];
    x[kBelly + i] = p.x(), y[kBelly + i] = p.y(), belly[i] = p.z();
  }
  terrain_.Heights(static_cast<int>(kCount), x.data(), y.data(), z.data());
  sample.ground_z = z[0];
  const auto between = [&](std::size_t a, std::size_t b) {
    return Eigen::Vector3d(x[a] - x[b], y[a] - y[b], z[a] - z[b]);
  };
  const Eigen::Vector3d normal = between(3, 4).cross(between(1, 2));
  grade_ = {normal.head<2>().squaredNorm(), normal.z() * normal.z()};
  sample.clearance = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < kBellyPoints; ++i) {
    sample.clearance = std::min(sample.clearance, belly[i] - z[kBelly + i]);
  }
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

Observation Observer::Observe(const VehicleSnapshot& snapshot) {
  const ChassisView& chassis = snapshot.chassis;
  const Wheels& wheels = snapshot.wheels;
  Observation observation;
  TraceSample& sample = observation.sample;
  sample.t = snapshot.time;
  sample.x = chassis.p_WB.x();
  sample.y = chassis.p_WB.y();
  sample.z = chassis.p_WB.z();
  sample.yaw = chassis.yaw;
  sample.pitch = chassis.pitch;
  sample.roll = chassis.roll;
  sample.speed = chassis.forward_speed;
  LookAtHeights(snapshot, sample);
  sample.load_transfer_ratio = LoadTransferRatio(wheels);
  AddDrivenWheels(wheels, sample);
  LookAtGround(chassis.yaw, wheels, observation);
  observation.hits_obstacle = HitsObstacle(chassis);
  observation.up = (chassis.q_WB * Eigen::Vector3d::UnitZ()).z();
  return observation;
}

void Observer::AddSinkage(const Wheels& wheels, TraceSample& sample) {
  sample.sinkage = sinkage_.Of(wheels);
  if (sample.sinkage <= negligible_sinkage_) last_sinkage_ = sample.sinkage;
}

void Observer::AddSlope(TraceSample& sample) {
  sample.ground_slope = std::atan2(std::sqrt(grade_.rise), std::sqrt(grade_.run));
  if (sample.ground_slope > negligible_slope_) return;
  last_slope_ = sample.ground_slope;
  if (!grade_.IsWithin(steepest_)) steepest_ = grade_;
}

void Observer::AddSinkageAndSlope(const Wheels& wheels, TraceSample& sample) {
  AddSinkage(wheels, sample);
  AddSlope(sample);
}

void Observer::AddSinkageAndSlopeIfWorse(const Wheels& wheels, TraceSample& sample) {
  sample.sinkage = last_sinkage_;
  sample.ground_slope = last_slope_;
  if (!sinkage_.IsNegligible(wheels)) AddSinkage(wheels, sample);
  if (!grade_.IsWithin(steepest_)) AddSlope(sample);
}

}  // namespace dbd
