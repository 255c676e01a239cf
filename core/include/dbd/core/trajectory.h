#pragma once

#include <dbd/core/simulation.h>

#include <array>
#include <string>
#include <vector>

namespace dbd {

/// One row of a drive in the layout of the reference trajectories. SI, rad; wheels in the order
/// front left, front right, rear left, rear right.
struct TrajectoryRow {
  double t = 0;
  double x_cg = 0;  ///< chassis centre of mass
  double z_cg = 0;
  double z_ref = 0;  ///< origin of the reference frame
  double pitch = 0;  ///< nose down
  double roll = 0;   ///< left side up
  double vx = 0;
  std::array<double, 4> spring_force{};
  std::array<double, 4> wheel_height{};
  std::array<double, 4> tire_force{};
};

/// The columns' names, in the order of the file.
std::vector<std::string> TrajectoryColumns();

/// Time and chassis of a row, in the columns t to vx; the rest 0.
TrajectoryRow ChassisRow(double time, const ChassisView& chassis, const VehicleModel& vehicle);

/// The row of a vehicle as it is now: wheels of its foremost and of its rearmost axle; a wheel that
/// has no spring shows a spring force of 0.
TrajectoryRow ObserveRow(const Simulation& simulation, const VehicleModel& vehicle);

/// Throws InputError that names the file and line.
std::vector<TrajectoryRow> ReadTrajectory(const std::string& file);
void WriteTrajectory(const std::string& file, const std::vector<TrajectoryRow>& rows);

/// Agreement of one signal with a reference, from t = 2 s on, with both values at t = 2 s taken
/// off except for `peak_value_error`.
struct SignalAgreement {
  std::string name;
  double r_squared = 0;
  double rms = 0;               ///< share of the reference's range
  double peak_error = 0;        ///< difference of the largest magnitudes, share of the reference's
  double peak_value_error = 0;  ///< the same of the values themselves, nothing taken off
};

/// Compares row by row by time (linear interpolation of `rows` at the reference's times). Throws
/// InputError when the two have less than a second in common.
std::vector<SignalAgreement> CompareTrajectories(const std::vector<TrajectoryRow>& rows,
                                                 const std::vector<TrajectoryRow>& reference);

}  // namespace dbd
