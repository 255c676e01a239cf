#include <dbd/core/simulation.h>
#include <dbd/planner/drive.h>

#include "drive_session.h"

namespace dbd {
namespace {

constexpr double kPollInterval = 1.0;  // [s] between looks at the stop token

}  // namespace

Rollout DrivePath(const Terrain& terrain, const VehicleModel& vehicle, const Path& path,
                  const Eigen::Vector2d& start, double heading, const DriveOptions& options,
                  std::stop_token stop) {
  Simulation simulation(vehicle, terrain);
  simulation.Place(start, heading);
  DriveSession session(terrain, vehicle, path, start, heading, options, simulation.control_step());
  VehicleSnapshot snapshot;
  double next_poll = kPollInterval;
  for (;;) {
    simulation.Observe(snapshot);
    if (session.Look(snapshot, simulation.IsSane(), simulation.drive_energy())) break;
    if (simulation.time() >= next_poll) {
      next_poll += kPollInterval;
      if (stop.stop_requested()) {
        session.Cancel();
        break;
      }
    }
    const DriverCommand command = session.Decide(snapshot);
    for (int i = 0; i < session.steps_to_look(); ++i) {
      simulation.Advance(command);
      session.Feel(simulation.VerticalAcceleration());
    }
  }
  return session.TakeRollout();
}

}  // namespace dbd
