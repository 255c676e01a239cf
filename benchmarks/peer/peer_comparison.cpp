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
#include "suspension_corner.h"

namespace dbd {
namespace {

struct Arguments {
  std::vector<std::string> scenarios{"A", "B", "C"};
  std::string reference;  // directory of another program's trajectories, may be empty
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

constexpr const char* kSignals[] = {"z_cg",  "pitch", "roll",  "Fs_fl",
                                    "Fs_fr", "Fs_rl", "Fs_rr", "link"};

struct Drive {
  std::vector<TrajectoryRow> rows;
  std::vector<double> link_force;  // of the front link, one per row
  double cpu_seconds = 0;
};

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

/// Rows of nothing but a force, in the place of the height.
std::vector<TrajectoryRow> ForceRows(const Drive& drive) {
  std::vector<TrajectoryRow> rows(drive.rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].t = drive.rows[i].t;
    rows[i].z_cg = drive.link_force[i];
  }
  return rows;
}

std::vector<SignalAgreement> AgreementOf(const Drive& drive, const Drive& peer) {
  std::vector<SignalAgreement> agreement = CompareTrajectories(drive.rows, peer.rows);
  agreement.push_back(CompareTrajectories(ForceRows(drive), ForceRows(peer)).front());
  agreement.back().name = "link";
  return agreement;
}

void PrintRow(const std::string& scenario, const char* who,
              const std::vector<SignalAgreement>& agreement) {
  std::printf("| %s | %s |", scenario.c_str(), who);
  for (const char* signal : kSignals) PrintCell(agreement, signal);
  std::printf("\n");
}

/// Whole drives of one scenario, and the row of real-time factors.
class Comparison {
 public:
  Comparison(const std::string& name, const Arguments& arguments)
      : arguments_(arguments), scenario_(MakeScenario(name)), vehicle_(LoadVehicle("tomcar-tm27")) {
    guide_ = {.target_speed = scenario_.target_speed, .standing_time = scenario_.standing_time};
    if (name == "C" && !arguments.reference.empty()) {
      scenario_.ground = ReadGridGround(arguments.reference + "/terrain_C.csv");
    }
    speeds_ = "| " + name + " |";
  }

  /// Prints rows of agreement and returns the row of speeds.
  std::string Run() {
    const VehicleModel vehicle = WithReferenceTires(*vehicle_);
    const Drive peer = DrivePeer(vehicle);
    if (!arguments_.reference.empty()) {
      const std::string file = arguments_.reference + "/" + scenario_.name + ".csv";
      PrintRow(scenario_.name, "Simbody - reference",
               CompareTrajectories(peer.rows, ReadTrajectory(file)));
    }
    const SimulationOptions rig{.tire = TireKind::kVerticalDisc, .guide = guide_};
    for (const Variant& variant : kVariants) {
      const Drive drive = DriveDbd(
          WithSteps(WithLinkStiffness(vehicle, variant.link_stiffness), variant.step_factor), rig);
      PrintRow(scenario_.name, variant.name, AgreementOf(drive, peer));
    }
    DriveDbd(*vehicle_, {});
    AddSpeed(peer, 1);
    return speeds_ + "\n";
  }

 private:
  /// The link's force takes time to find: in a drive of its own.
  Drive DrivePeer(const VehicleModel& vehicle) {
    PeerOptions options = arguments_.peer;
    Drive fastest = Fastest(arguments_.repeats, [&] {
      const PeerDrive drive = DriveWithSimbody(scenario_, vehicle, guide_, options);
      return Drive{drive.rows, {}, drive.cpu_seconds};
    });
    options.link_forces = true;
    fastest.link_force = DriveWithSimbody(scenario_, vehicle, guide_, options).front_link_force;
    return fastest;
  }

  Drive DriveDbd(const VehicleModel& vehicle, const SimulationOptions& options) {
    const int front_left = WheelOrder(vehicle)[0];
    const int link = FindCorner(vehicle, front_left).upper_links.front();
    const Drive drive = Fastest(arguments_.repeats, [&] {
      Drive once;
      const std::clock_t begin = std::clock();
      once.rows = RecordScenario(scenario_, vehicle, options, [&](const Simulation& simulation) {
        once.link_force.push_back(simulation.LinkForce(link));
      });
      once.cpu_seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
      return once;
    });
    AddSpeed(drive, 0);
    return drive;
  }

  void AddSpeed(const Drive& drive, int digits) {
    char text[32];
    std::snprintf(text, sizeof(text), " %.*f |", digits, scenario_.duration / drive.cpu_seconds);
    speeds_ += text;
  }

  const Arguments& arguments_;
  Scenario scenario_;
  std::shared_ptr<const VehicleModel> vehicle_;
  GuideForces guide_;
  std::string speeds_;
};

void Run(const Arguments& arguments) {
  std::printf(
      "Agreement of dbd with Simbody (%s, accuracy %g), from t = 2 s:\n"
      "R2 / rms %% of range / peak error %%\n\n",
      arguments.peer.integrator.c_str(), arguments.peer.accuracy);
  std::printf(
      "| drive | links | height | pitch | roll | spring FL | spring FR | spring RL |"
      " spring RR | front link |\n|---|---|---|---|---|---|---|---|---|---|\n");
  std::string speeds;
  for (const std::string& name : arguments.scenarios) speeds += Comparison(name, arguments).Run();
  std::printf("\nReal-time factors on one core, process time, best of %d\n\n", arguments.repeats);
  std::printf(
      "| drive | dbd, %s links | dbd, %s, half steps | dbd, own tire and driver | Simbody |"
      "\n|---|---|---|---|---|\n%s",
      kVariants[0].name, kVariants[1].name, speeds.c_str());
}

}  // namespace
}  // namespace dbd

int main(int argc, char** argv) {
  CLI::App app("Compares dbd with Simbody on the scenarios of the method's paper.");
  dbd::Arguments arguments;
  app.add_option("scenarios", arguments.scenarios, "Default A B C")
      ->check(CLI::IsMember({"A", "B", "C"}));
  app.add_option("--reference", arguments.reference,
                 "Directory with another program's A.csv, B.csv, C.csv and the ground of C, "
                 "terrain_C.csv; without it C's ground is drawn here")
      ->option_text("DIR");
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
