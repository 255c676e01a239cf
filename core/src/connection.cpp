#include <dbd/core/connection.h>
#include <dbd/core/error.h>

#include <Eigen/Geometry>

namespace dbd {
namespace {

void Require(bool good, const Connection& connection, const char* message) {
  if (!good) throw InputError("connection \"" + connection.name + "\": " + message);
}

void Check(const Connection& connection, const VehicleModel& vehicle) {
  const int bodies = static_cast<int>(vehicle.bodies.size());
  const auto exists = [&](int body) { return body >= 0 && body < bodies; };
  Require(exists(connection.body_a) && exists(connection.body_b), connection,
          "its bodies must exist");
  Require(connection.body_a != connection.body_b, connection, "needs two different bodies");
  Require(connection.axis.norm() > 1e-9, connection, "its axis must not be zero");
  Require(connection.base > 0, connection, "base must be greater than 0");
  Require(connection.stiffness > 0, connection, "stiffness must be greater than 0");
  Require(connection.damping >= 0, connection, "damping must not be negative");
}

/// A link into point `end` of body b, coming along `direction` from body a.
void AddLink(const Connection& connection, const Eigen::Vector3d& end,
             const Eigen::Vector3d& direction, VehicleModel& vehicle) {
  LinkModel link;
  link.name = connection.name + " " + std::to_string(vehicle.links.size());
  link.body_a = connection.body_a;
  link.body_b = connection.body_b;
  link.p_A = end + connection.base * direction - vehicle.bodies[connection.body_a].p_RB;
  link.p_B = end - vehicle.bodies[connection.body_b].p_RB;
  link.stiffness = connection.stiffness;
  link.damping = connection.damping;
  link.free_length = connection.base;
  vehicle.links.push_back(link);
}

}  // namespace

void AddConnection(const Connection& connection, VehicleModel& vehicle) {
  Check(connection, vehicle);
  if (connection.kind == ConnectionKind::kFree) return;
  const Eigen::Vector3d u = connection.axis.normalized();
  const Eigen::Vector3d v = u.unitOrthogonal();
  const Eigen::Vector3d w = u.cross(v);
  const Eigen::Vector3d& p = connection.p_R;
  if (connection.kind == ConnectionKind::kSpherical) {
    for (const Eigen::Vector3d& direction : {u, v, w}) AddLink(connection, p, direction, vehicle);
    return;
  }
  const Eigen::Vector3d half = 0.5 * connection.base * u;
  AddLink(connection, p, u, vehicle);  // along the axis, on which p stays
  for (const Eigen::Vector3d& point : {Eigen::Vector3d(p + half), Eigen::Vector3d(p - half)}) {
    AddLink(connection, point, v, vehicle);
    AddLink(connection, point, w, vehicle);
  }
  if (connection.kind != ConnectionKind::kFixed) return;
  AddLink(connection, p + connection.base * v, w, vehicle);
}

}  // namespace dbd
