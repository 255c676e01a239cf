#include "axle_swing.h"

#include <Eigen/Dense>

namespace dbd {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// Adds k w w^T with the wrench w = (force, moment about Bo) that a unit of the element's force
/// puts on the body.
void AddElement(double stiffness, const Eigen::Vector3d& force, const Eigen::Vector3d& moment,
                Matrix6& sum) {
  Vector6 wrench;
  wrench << force, moment;
  sum += stiffness * wrench * wrench.transpose();
}

/// Stiffness of all that joins `body` to other bodies against its motion (displacement of Bo,
/// rotation), others held.
Matrix6 StiffnessAt(const VehicleModel& vehicle, int body) {
  const auto place = [&](int of, const Eigen::Vector3d& p) -> Eigen::Vector3d {
    return vehicle.bodies[static_cast<std::size_t>(of)].p_RB + p;
  };
  Matrix6 sum = Matrix6::Zero();
  for (const LinkModel& link : vehicle.links) {
    if (link.body_a != body && link.body_b != body) continue;
    const Eigen::Vector3d along =
        (place(link.body_b, link.p_B) - place(link.body_a, link.p_A)).normalized();
    AddElement(link.stiffness, along, (link.body_b == body ? link.p_B : link.p_A).cross(along),
               sum);
  }
  for (const SpringModel& spring : vehicle.springs) {
    if (spring.body_b != body) continue;
    const Eigen::Vector3d mount = (1 - spring.lever) * place(spring.body_a, spring.p_Q) +
                                  spring.lever * place(body, spring.p_B);
    const Eigen::Vector3d along =
        spring.lever * (mount - place(spring.body_a, spring.p_A)).normalized();
    const double stiffness =
        spring.force_curve.given() ? spring.force_curve.slope : spring.stiffness;
    AddElement(stiffness, along, spring.p_B.cross(along), sum);
  }
  for (const AxisJointModel& joint : vehicle.joints) {
    if (joint.body_a != body && joint.body_b != body) continue;
    AddElement(joint.stiffness, Eigen::Vector3d::Zero(), joint.axis_a.cross(joint.axis_b), sum);
  }
  return sum;
}

}  // namespace

std::optional<AxleSwing> SwingOf(const VehicleModel& vehicle, const AxleModel& axle) {
  const int body = vehicle.wheels[static_cast<std::size_t>(axle.left)].body;
  if (body == 0 || body != vehicle.wheels[static_cast<std::size_t>(axle.right)].body) return {};
  const Matrix6 stiffness = StiffnessAt(vehicle, body);
  constexpr int kRoll = 3;
  Eigen::Matrix<double, 5, 5> others;
  Eigen::Matrix<double, 5, 1> coupling;
  for (int i = 0, row = 0; i < 6; ++i) {
    if (i == kRoll) continue;
    for (int j = 0, column = 0; j < 6; ++j) {
      if (j != kRoll) others(row, column++) = stiffness(i, j);
    }
    coupling(row++) = stiffness(i, kRoll);
  }
  // How the body moves when it is rolled by 1 rad: displacement d of Bo, so that the point p_z
  // above Bo moves sideways by d_y - p_z and the one p_y to the left moves up by d_z + p_y.
  const Eigen::Matrix<double, 5, 1> moved =
      -others.completeOrthogonalDecomposition().solve(coupling);
  const Eigen::Vector3d& p_RB = vehicle.bodies[static_cast<std::size_t>(body)].p_RB;
  return AxleSwing{stiffness(kRoll, kRoll) + coupling.dot(moved),
                   p_RB + Eigen::Vector3d(0, -moved(2), moved(1))};
}

bool SwingsFreely(const VehicleModel& vehicle, const AxleModel& axle) {
  const std::optional<AxleSwing> swing = SwingOf(vehicle, axle);
  if (!swing) return false;
  constexpr double kShare = 0.02;  // of the moment that lifts a wheel, at a roll of 0.1 rad
  const double load = vehicle.wheels[static_cast<std::size_t>(axle.left)].static_load +
                      vehicle.wheels[static_cast<std::size_t>(axle.right)].static_load;
  return swing->stiffness * 0.1 < kShare * 0.5 * load * axle.track;
}

}  // namespace dbd
