#include "vibration.h"

#include <dbd/core/scenario.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <numbers>

#include "engine.h"
#include "initial_state.h"

namespace dbd {
namespace {

constexpr double kDisplacement = 1e-5;  // [m, rad]
constexpr double kVelocity = 1e-4;      // [m/s, rad/s]

/// Moves or turns one body a little: axes 0-2 translate along x, y, z, axes 3-5 turn about them.
void Displace(int axis, double amount, BodyState<double>& body) {
  Vec3<double> d{axis % 3 == 0 ? amount : 0, axis % 3 == 1 ? amount : 0,
                 axis % 3 == 2 ? amount : 0};
  if (axis < 3) {
    body.p_WB += d;
  } else {
    body.q_WB = Rotated(body.q_WB, d);
  }
}

void Push(int axis, double amount, BodyState<double>& body) {
  Vec3<double>& v = axis < 3 ? body.v_WB : body.w_WB;
  (axis % 3 == 0 ? v.x : axis % 3 == 1 ? v.y : v.z) += amount;
}

/// Generalised accelerations of all bodies in a given state, in the order of Displace.
class Accelerations {
 public:
  Accelerations(const VehicleModel& vehicle, const Ground& ground)
      : vehicle_(vehicle), ground_(ground), engine_(vehicle), work_(vehicle) {}

  Eigen::VectorXd operator()(EngineState<double> state) {
    state.step = 0;  // all groups are due
    EvaluateForces(engine_, ground_, controls_, state, work_);
    Eigen::VectorXd result(6 * static_cast<Eigen::Index>(vehicle_.bodies.size()));
    for (std::size_t i = 0; i < vehicle_.bodies.size(); ++i) {
      const BodyModel& body = vehicle_.bodies[i];
      const Wrench<double>& w = work_.wrench[i];
      const Eigen::Vector3d torque(w.t_W.x, w.t_W.y, w.t_W.z);
      result.segment<3>(6 * static_cast<Eigen::Index>(i)) =
          Eigen::Vector3d(w.f_W.x, w.f_W.y, w.f_W.z) / body.mass;
      result.segment<3>(6 * static_cast<Eigen::Index>(i) + 3) = torque.cwiseQuotient(body.inertia);
    }
    return result;
  }

 private:
  const VehicleModel& vehicle_;
  const Ground& ground_;
  EngineModel engine_;
  Workspace<double> work_;
  WheelControls<double> controls_;
};

/// d(x, v)/dt = [0 1; A_x A_v] (x, v) by central differences.
Eigen::MatrixXd SystemMatrix(const VehicleModel& vehicle, const Ground& ground) {
  const EngineState<double> rest =
      InitialState<double>(vehicle, ground, Eigen::Vector2d::Zero(), 0);
  Accelerations accelerations(vehicle, ground);
  const Eigen::Index n = 6 * static_cast<Eigen::Index>(vehicle.bodies.size());
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  system.topRightCorner(n, n).setIdentity();
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto body = static_cast<std::size_t>(i / 6);
    const int axis = static_cast<int>(i % 6);
    const auto difference = [&](auto change, double amount) {
      EngineState<double> plus = rest, minus = rest;
      change(axis, amount, plus.bodies[body]);
      change(axis, -amount, minus.bodies[body]);
      return Eigen::VectorXd((accelerations(plus) - accelerations(minus)) / (2 * amount));
    };
    system.col(i).tail(n) = difference(Displace, kDisplacement);
    system.col(n + i).tail(n) = difference(Push, kVelocity);
  }
  return system;
}

/// The degree of freedom with the largest kinetic energy names the mode.
std::string NameShape(const VehicleModel& vehicle, const Eigen::VectorXcd& vector) {
  static const char* const kAxes[] = {"x", "y", "z", "roll", "pitch", "yaw"};
  const Eigen::Index n = vector.size() / 2;
  double largest = -1;
  std::string name;
  for (Eigen::Index i = 0; i < n; ++i) {
    const BodyModel& body = vehicle.bodies[static_cast<std::size_t>(i / 6)];
    const int axis = static_cast<int>(i % 6);
    const double inertia = axis < 3 ? body.mass : body.inertia[axis - 3];
    const double energy = inertia * std::norm(vector(n + i));
    if (energy > largest * (1 + 1e-6)) {
      largest = energy;
      name = body.name + " " + kAxes[axis];
    }
  }
  return name;
}

}  // namespace

std::vector<VibrationMode> FindModes(const VehicleModel& vehicle, double* fastest) {
  const auto ground = MakePlaneGround(0, 0);
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(SystemMatrix(vehicle, *ground));
  const Eigen::VectorXcd values = solver.eigenvalues();
  std::vector<VibrationMode> modes;
  *fastest = 0;
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const std::complex<double> value = values(i);
    *fastest = std::max(*fastest, std::abs(value));
    constexpr double kSlowest = 2 * std::numbers::pi * 0.3;  // below: drifting, not vibrating
    if (value.imag() < kSlowest) continue;
    modes.push_back({NameShape(vehicle, solver.eigenvectors().col(i)),
                     value.imag() / (2 * std::numbers::pi), -value.real() / std::abs(value)});
  }
  std::sort(modes.begin(), modes.end(),
            [](const auto& a, const auto& b) { return a.frequency < b.frequency; });
  return modes;
}

}  // namespace dbd
