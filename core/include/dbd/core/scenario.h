#pragma once

#include <dbd/core/driver.h>
#include <dbd/core/ground.h>
#include <dbd/core/simulation.h>
#include <dbd/core/vehicle_model.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace dbd {

// The paper's four drives (Table 7), as data. All run straight along x on hard soil: 2 s of
// standing, then acceleration to the target speed within the powertrain's limits.

struct Scenario {
  std::string name;
  std::string description;
  double target_speed = 0;   ///< [m/s]
  double standing_time = 2;  ///< [s]
  double duration = 0;       ///< including the standing time [s]
  double paper_time = 0;     ///< the paper's own calculation time [s]
  std::shared_ptr<const Ground> ground;
};

/// Names of all scenarios: "A", "B", "C", "D".
std::vector<std::string> ScenarioNames();

/// Throws InputError that lists the names. `seed` draws the random ground of C and D.
Scenario MakeScenario(const std::string& name, std::uint64_t seed = 1);

/// The vehicle at the scenario's beginning, settled, heading east at the origin.
Simulation StartScenario(const Scenario& scenario, const VehicleModel& vehicle,
                         const SimulationOptions& options = {});

/// Drives a scenario as the paper does: standing, then straight ahead at the target speed.
class ScenarioDriver {
 public:
  /// Decides every `decision_interval` [s], as whole control intervals; every one of them at 0.
  ScenarioDriver(const Scenario& scenario, const VehicleModel& vehicle,
                 double decision_interval = 0);

  /// One control interval.
  void Advance(Simulation& simulation);

 private:
  DriverCommand Decide(const Simulation& simulation, double dt);

  double standing_time_;
  double decision_interval_;
  Driver driver_;
  DriverState state_;
  DriverCommand command_;
  int steps_to_decision_ = 0;
};

/// Which wheels an obstacle lies before.
enum class TrackSide { kBoth, kLeft, kRight };

/// A half cylinder across the way on level ground, under one track or both.
std::shared_ptr<const Ground> MakeBumpGround(double x, double radius,
                                             TrackSide side = TrackSide::kBoth);

/// amplitude * sin(2 pi (x - x_begin) / wavelength) between x_begin and x_end, level elsewhere.
std::shared_ptr<const Ground> MakeSineGround(double x_begin, double x_end, double amplitude,
                                             double wavelength);

/// Independent uniform heights in [0, amplitude] at nodes `spacing` apart, bilinear in between;
/// level for x < x_begin.
std::shared_ptr<const Ground> MakeRandomGround(double x_begin, double amplitude, double spacing,
                                               std::uint64_t seed);

/// Heights from a text file, bilinear, the edge continued: a first line
/// "# x0=... y0=... d=... nx=... ny=..." (nodes d apart from x0, y0 on), then one line per x with
/// ny heights separated by commas, y ascending. Throws InputError that names file and line.
std::shared_ptr<const Ground> ReadGridGround(const std::string& file);

/// A plane through the origin with these grades dz/dx, dz/dy [-], of one soil.
std::shared_ptr<const Ground> MakePlaneGround(double grade_x, double grade_y,
                                              const SoilSample& soil = {});

}  // namespace dbd
