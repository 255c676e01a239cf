#include "trim.h"

#include <dbd/core/error.h>
#include <dbd/core/units.h>

#include <Eigen/Dense>

#include "curve.h"

namespace dbd {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;

/// Force and moment about the body's centre of mass (= axes parallel to R in the design pose).
Vector6 WrenchOf(const Eigen::Vector3d& force, const Eigen::Vector3d& lever) {
  Vector6 wrench;
  wrench << force, lever.cross(force);
  return wrench;
}

Eigen::Vector3d PointInR(const VehicleModel& vehicle, int body, const Eigen::Vector3d& p) {
  return vehicle.bodies[body].p_RB + p;
}

Eigen::Vector3d LinkVector(const VehicleModel& vehicle, const LinkModel& link) {
  return PointInR(vehicle, link.body_b, link.p_B) - PointInR(vehicle, link.body_a, link.p_A);
}

Eigen::Vector3d SpringVector(const VehicleModel& vehicle, const SpringModel& spring) {
  const Eigen::Vector3d lower = (1 - spring.lever) * PointInR(vehicle, spring.body_a, spring.p_Q) +
                                spring.lever * PointInR(vehicle, spring.body_b, spring.p_B);
  return lower - PointInR(vehicle, spring.body_a, spring.p_A);
}

/// One element seen from the body it holds: the wrench of a unit force, and where the force goes.
struct Unknown {
  Vector6 unit_wrench;
  double stiffness;
  double* force;
};

/// Everything that acts on `body`; forces are written through the pointers.
std::vector<Unknown> ElementsOn(const VehicleModel& vehicle, int body, std::vector<double>& links,
                                std::vector<double>& springs, std::vector<double>& joints) {
  std::vector<Unknown> unknowns;
  for (std::size_t i = 0; i < vehicle.links.size(); ++i) {
    const LinkModel& link = vehicle.links[i];
    if (link.body_b != body) continue;
    const Eigen::Vector3d pull = -LinkVector(vehicle, link).normalized();
    unknowns.push_back({WrenchOf(pull, link.p_B), link.stiffness, &links[i]});
  }
  for (std::size_t i = 0; i < vehicle.springs.size(); ++i) {
    const SpringModel& spring = vehicle.springs[i];
    if (spring.body_b != body) continue;
    const Eigen::Vector3d push = spring.lever * SpringVector(vehicle, spring).normalized();
    unknowns.push_back({WrenchOf(push, spring.p_B), spring.stiffness, &springs[i]});
  }
  for (std::size_t i = 0; i < vehicle.joints.size(); ++i) {
    const AxisJointModel& joint = vehicle.joints[i];
    if (joint.body_b != body) continue;
    Vector6 wrench = Vector6::Zero();
    wrench.tail<3>() = joint.axis_a.cross(joint.axis_b);
    unknowns.push_back({wrench, joint.stiffness, &joints[i]});
  }
  return unknowns;
}

/// Gravity and wheel loads on a body other than the chassis.
Vector6 LoadOn(const VehicleModel& vehicle, int body) {
  Vector6 load = Vector6::Zero();
  load(2) = -vehicle.bodies[body].mass * kGravity;
  for (const WheelModel& wheel : vehicle.wheels) {
    if (wheel.body != body) continue;
    load += WrenchOf({0, 0, wheel.static_load}, wheel.p_BH);
  }
  return load;
}

/// Least strain energy sum F^2/k with A F = -load: F = sqrt(K) (A sqrt(K))^+ (-load).
void SolveForces(const std::vector<Unknown>& unknowns, const Vector6& load) {
  Eigen::MatrixXd scaled(6, static_cast<Eigen::Index>(unknowns.size()));
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    scaled.col(static_cast<Eigen::Index>(i)) =
        std::sqrt(unknowns[i].stiffness) * unknowns[i].unit_wrench;
  }
  const Eigen::VectorXd forces = scaled.completeOrthogonalDecomposition().solve(-load);
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    *unknowns[i].force = std::sqrt(unknowns[i].stiffness) * forces(static_cast<Eigen::Index>(i));
  }
}

/// Free length and contact lengths of the stops, for a length and a push in the design pose.
void TrimSpring(double length, double push, SpringModel& spring) {
  spring.bump_stop.shortest_length = length - spring.bump_stop.travel_compression;
  spring.bump_stop.longest_length = length + spring.bump_stop.travel_extension;
  if (spring.free_length > 0) return;
  const double deflection =
      spring.force_curve.given() ? InvertCurve(spring.force_curve, push) : push / spring.stiffness;
  spring.free_length = length + deflection;
}

/// Lets a tie rod's length follow the steering: exact at straight ahead and at full lock.
void SetSteering(const VehicleModel& vehicle, LinkModel& link) {
  const WheelModel& wheel = vehicle.wheels[static_cast<std::size_t>(link.steered_wheel)];
  const double lock = vehicle.axles[static_cast<std::size_t>(wheel.axle)].max_steer;
  const auto length_at = [&](double angle) {
    const Eigen::Vector3d arm = link.p_B - link.p_BK;
    const Eigen::Vector3d turned =
        link.p_BK + Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()) * arm;
    return (PointInR(vehicle, link.body_b, turned) - PointInR(vehicle, link.body_a, link.p_A))
        .norm();
  };
  const double sine = std::sin(lock);
  const double left = length_at(lock), right = length_at(-lock), straight = length_at(0);
  link.steer_linear = (left - right) / (2 * sine);
  link.steer_quadratic = (left + right - 2 * straight) / (2 * sine * sine);
}

}  // namespace

void TrimWheelLoads(const std::string& origin, VehicleModel& vehicle) {
  Eigen::Vector3d mass_moment = Eigen::Vector3d::Zero();
  for (const BodyModel& body : vehicle.bodies) mass_moment += body.mass * body.p_RB;
  const auto n = static_cast<Eigen::Index>(vehicle.wheels.size());
  Eigen::MatrixXd balance(3, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const WheelModel& wheel = vehicle.wheels[static_cast<std::size_t>(i)];
    const Eigen::Vector3d hub = PointInR(vehicle, wheel.body, wheel.p_BH);
    balance.col(i) << 1, hub.x(), hub.y();
  }
  const Eigen::Vector3d weight =
      kGravity * Eigen::Vector3d(vehicle.total_mass(), mass_moment.x(), mass_moment.y());
  const Eigen::VectorXd loads = balance.completeOrthogonalDecomposition().solve(weight);
  for (std::size_t i = 0; i < vehicle.wheels.size(); ++i) {
    WheelModel& wheel = vehicle.wheels[i];
    wheel.static_load = loads(static_cast<Eigen::Index>(i));
    if (wheel.static_load <= 0) {
      throw InputError(origin + ": axles: wheel \"" + wheel.name + "\" carries " +
                       std::to_string(wheel.static_load) +
                       " N at rest: the centre of mass must lie between the axles");
    }
    BodyModel& body = vehicle.bodies[wheel.body];
    body.p_RB.z() = wheel.tire.radius - wheel.static_load / wheel.tire.stiffness -
                    vehicle.reference_height - wheel.p_BH.z();
  }
}

void TrimFreeLengths(VehicleModel& vehicle) {
  std::vector<double> tension(vehicle.links.size()), push(vehicle.springs.size()),
      torque(vehicle.joints.size());
  for (int body = 1; body < static_cast<int>(vehicle.bodies.size()); ++body) {
    const auto unknowns = ElementsOn(vehicle, body, tension, push, torque);
    if (!unknowns.empty()) SolveForces(unknowns, LoadOn(vehicle, body));
  }
  for (std::size_t i = 0; i < vehicle.links.size(); ++i) {
    LinkModel& link = vehicle.links[i];
    link.free_length = LinkVector(vehicle, link).norm() - tension[i] / link.stiffness;
    if (link.steered_wheel >= 0) SetSteering(vehicle, link);
  }
  for (std::size_t i = 0; i < vehicle.springs.size(); ++i) {
    TrimSpring(SpringVector(vehicle, vehicle.springs[i]).norm(), push[i], vehicle.springs[i]);
  }
  for (std::size_t i = 0; i < vehicle.joints.size(); ++i) {
    AxisJointModel& joint = vehicle.joints[i];
    joint.rest = joint.axis_a.dot(joint.axis_b) - torque[i] / joint.stiffness;
  }
}

}  // namespace dbd
