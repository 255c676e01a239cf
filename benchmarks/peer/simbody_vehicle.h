#pragma once

#include <dbd/core/scenario.h>
#include <dbd/core/simulation.h>
#include <dbd/core/trajectory.h>
#include <dbd/core/vehicle_model.h>

#include <string>
#include <vector>

namespace dbd {

// The same vehicle in Simbody, a multibody program of the opposite kind: a tree of joints in
// generalised coordinates, loops closed by constraints, error-controlled integration. Links and
// joints are ideal and rigid, which is the limit that stiff springs approximate. Springs, the
// reference trajectories' tire and the test rig's forces are written here once more, so that a
// slip in the engine's own would show.

struct PeerOptions {
  std::string integrator = "merson";   ///< one of PeerIntegrators()
  double accuracy = 1e-3;              ///< relative, of the error control
  double constraint_tolerance = 1e-4;  ///< of joints and rods [m]
  bool link_forces = false;            ///< keep the front link's, which takes time
  double row_interval = 4e-3;          ///< [s] as the reference trajectories; steps may be longer
};

/// "merson" (Runge-Kutta, order 4), "runge-kutta-3", "cpodes" (implicit multistep).
std::vector<std::string> PeerIntegrators();

struct PeerDrive {
  std::vector<TrajectoryRow> rows;
  /// Tension of the front left wheel's first upper link, one per row [N]. (The force of a lower one
  /// depends on how tie rod and toe joint share their load, which ideal joints leave open.)
  std::vector<double> front_link_force;
  double cpu_seconds = 0;  ///< of the drive alone, without building the system
  int steps = 0;
  int attempts = 0;
};

/// Drives a scenario from rest in the design pose, pulled by the test rig. The vehicle needs
/// wishbones (four links, two to a ball, and a tie rod) or trailing arms at each wheel. Throws
/// InputError for others and for an unknown integrator.
PeerDrive DriveWithSimbody(const Scenario& scenario, const VehicleModel& vehicle,
                           const GuideForces& guide, const PeerOptions& options = {});

}  // namespace dbd
