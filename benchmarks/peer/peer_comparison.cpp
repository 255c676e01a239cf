// Drives scenarios A, B, C in dbd and in Simbody, with the same vehicle, tire, ground and rig, and
// prints as Markdown how well they agree and how fast each of them is.

#include <dbd/core/error.h>
#include <dbd/core/scenario_record.h>
#include <dbd/core/vehicle_database.h>
#include <dbd/core/vehicle_variant.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <ctime>

#include "simbody_vehicle.h"

namespace dbd {
namespace {

// Tires of the reference trajectories [N/m].
constexpr double kFrontTire = 207e3;
constexpr double kRearTire = 235e3;

struct Arguments {
  std::vector<std::string> scenarios{"A", "B", "C"};
  std::string terrain;  // of C
  int repeats = 3;
  PeerOptions peer;
};

/// A choice of links and steps.
struct Variant {
  const char* name;
  double link_stiffness;
  double step_factor;
};

constexpr Variant kVariants[] = {{"paper's", 1, 1}, {"ten times stiffer", 10, 0.5}};

constexpr const char* kSignals[] = {"z_cg", "pitch", "roll", "Fs_fl", "Fs_fr", "Fs_rl", "Fs_rr"};

struct Drive {
  std::vector<TrajectoryRow> rows;
  double cpu_seconds = 0;
};

VehicleModel ReferenceVehicle() {
  const VehicleModel vehicle = *LoadVehicle("tomcar-tm27");
  std::vector<double> stiffness;
  for (const AxleModel& axle : vehicle.axles) {
    stiffness.push_back(axle.x > vehicle.middle_x() ? kFrontTire : kRearTire);
  }
  return WithTireStiffness(vehicle, stiffness);
}

/// The fastest of several drives; they are all the same.
template <class DriveOnce>
Drive Fastest(int repeats, DriveOnce drive_once) {
  Drive fastest = drive_once();
  for (int i = 1; i < repeats; ++i) {
    const Drive drive = drive_once();
    fastest.cpu_seconds = std::min(fastest.cpu_seconds, drive.cpu_seconds);
  }
  return fastest;
}

Drive DriveWithDbd(const Scenario& scenario, const VehicleModel& vehicle,
                   const GuideForces& guide) {
  const SimulationOptions options{.tire = TireKind::kVerticalDisc, .guide = guide};
  const std::clock_t begin = std::clock();
  Drive drive{RecordScenario(scenario, vehicle, options), 0};
  drive.cpu_seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  return drive;
}

void PrintCell(const std::vector<SignalAgreement>& agreement, const std::string& name) {
  const auto signal = std::find_if(agreement.begin(), agreement.end(),
                                   [&name](const auto& s) { return s.name == name; });
  if (signal == agreement.end()) {
    std::printf(" - |");
  } else {
    std::printf(" %.4f / %.2f / %.2f |", signal->r_squared, 100 * signal->rms,
                100 * signal->peak_error);
  }
}

/// One scenario in both engines: rows of the agreement, and the row of the other table.
std::string Compare(const std::string& name, const Arguments& arguments) {
  Scenario scenario = MakeScenario(name);
  if (name == "C" && !arguments.terrain.empty()) {
    scenario.ground = ReadGridGround(arguments.terrain);
  }
  const VehicleModel vehicle = ReferenceVehicle();
  const GuideForces guide{.target_speed = scenario.target_speed,
                          .standing_time = scenario.standing_time};
  const Drive peer = Fastest(arguments.repeats, [&] {
    const PeerDrive drive = DriveWithSimbody(scenario, vehicle, guide, arguments.peer);
    return Drive{drive.rows, drive.cpu_seconds};
  });
  std::string speeds = "| " + name + " |";
  for (const Variant& variant : kVariants) {
    const VehicleModel ours =
        WithSteps(WithLinkStiffness(vehicle, variant.link_stiffness), variant.step_factor);
    const Drive drive =
        Fastest(arguments.repeats, [&] { return DriveWithDbd(scenario, ours, guide); });
    std::printf("| %s | %s |", name.c_str(), variant.name);
    const auto agreement = CompareTrajectories(drive.rows, peer.rows);
    for (const char* signal : kSignals) PrintCell(agreement, signal);
    std::printf("\n");
    speeds += " " + std::to_string(std::lround(scenario.duration / drive.cpu_seconds)) + " |";
  }
  char peer_speed[32];
  std::snprintf(peer_speed, sizeof(peer_speed), " %.1f |\n", scenario.duration / peer.cpu_seconds);
  return speeds + peer_speed;
}

void Run(const Arguments& arguments) {
  std::printf(
      "Agreement of dbd with Simbody (%s, accuracy %g): R2 / rms %% of range / peak error %%,"
      " from t = 2 s\n\n",
      arguments.peer.integrator.c_str(), arguments.peer.accuracy);
  std::printf(
      "| drive | links | height | pitch | roll | spring FL | spring FR | spring RL |"
      " spring RR |\n|---|---|---|---|---|---|---|---|---|\n");
  std::string speeds;
  for (const std::string& name : arguments.scenarios) speeds += Compare(name, arguments);
  std::printf("\nReal-time factors on one core, process time, best of %d\n\n", arguments.repeats);
  std::printf("| drive | dbd, %s links | dbd, %s, half steps | Simbody |\n|---|---|---|---|\n%s",
              kVariants[0].name, kVariants[1].name, speeds.c_str());
}

}  // namespace
}  // namespace dbd

int main(int argc, char** argv) {
  CLI::App app("Compares dbd with Simbody on the scenarios of the method's paper.");
  dbd::Arguments arguments;
  app.add_option("scenarios", arguments.scenarios, "Default A B C")
      ->check(CLI::IsMember({"A", "B", "C"}));
  app.add_option("--terrain", arguments.terrain, "Height grid for C, default: drawn here")
      ->option_text("FILE.csv");
  app.add_option("--repeats", arguments.repeats, "Of each drive, for the time; default 3")
      ->check(CLI::Range(1, 1000));
  app.add_option("--integrator", arguments.peer.integrator, "Of Simbody, default merson")
      ->check(CLI::IsMember(dbd::PeerIntegrators()));
  app.add_option("--accuracy", arguments.peer.accuracy, "Of Simbody, default 1e-3")
      ->check(CLI::Range(1e-9, 0.1));
  CLI11_PARSE(app, argc, argv);
  try {
    dbd::Run(arguments);
  } catch (const dbd::InputError& error) {
    std::fprintf(stderr, "peer_comparison: %s\n", error.what());
    return 2;
  }
  return 0;
}
