#include "vehicle_command.h"

#include <dbd/core/mobility.h>
#include <dbd/core/simulation.h>
#include <dbd/core/units.h>
#include <dbd/core/vehicle_database.h>

#include <algorithm>
#include <cstdio>

#include "cli.h"

namespace dbd {
namespace {

constexpr double kSettleTime = 5;  // [s], until the springs are at rest

class LevelGround final : public Ground {
 public:
  void Heights(int count, const double*, const double*, double* z) const override {
    std::fill_n(z, count, 0.0);
  }
  void Soils(int count, const double*, const double*, SoilSample* soil) const override {
    std::fill_n(soil, count, SoilSample());
  }
};

void PrintDescription(const VehicleModel& vehicle) {
  std::printf("%s: %s\n", vehicle.name.c_str(), vehicle.description.c_str());
  std::printf("  mass                  %9.1f kg\n", vehicle.total_mass());
  std::printf("  wheelbase, mean track %9.3f m, %.3f m\n", vehicle.wheelbase(),
              vehicle.mean_track());
  std::printf("  turning radius        %9.2f m\n", vehicle.min_turning_radius());
  std::printf("  tips over at          %9.1f deg side slope\n",
              ToDegrees(StaticStabilityAngle(vehicle)));
  std::printf("  net traction          %9.3f of the weight on firm soil\n",
              MaxNetTractionRatio(vehicle, SoilSample()));
}

void PrintStatics(const VehicleModel& vehicle) {
  const LevelGround ground;
  Simulation simulation(vehicle, ground);
  simulation.Place({0, 0}, 0, kSettleTime);
  const ChassisView chassis = simulation.Chassis();
  std::printf("at rest on level ground\n");
  std::printf("  chassis centre height %9.4f m\n", chassis.p_WB.z());
  std::printf("  pitch, roll           %9.3f deg, %.3f deg\n", ToDegrees(chassis.pitch),
              ToDegrees(chassis.roll));
  for (std::size_t i = 0; i < vehicle.wheels.size(); ++i) {
    std::printf("  wheel load            %9.1f N  %s\n", simulation.Wheel(static_cast<int>(i)).load,
                vehicle.wheels[i].name.c_str());
  }
  for (std::size_t i = 0; i < vehicle.springs.size(); ++i) {
    std::printf("  spring force          %9.1f N  %s\n",
                simulation.SpringForce(static_cast<int>(i)), vehicle.springs[i].name.c_str());
  }
}

}  // namespace

int RunVehicleList() {
  for (const std::string& name : BuiltInVehicleNames()) {
    std::printf("%-20s %s\n", name.c_str(), LoadVehicle(name)->description.c_str());
  }
  return kExitOk;
}

int RunVehicleShow(const std::string& name) {
  std::fputs(BuiltInVehicleText(name).c_str(), stdout);
  return kExitOk;
}

int RunVehicleCheck(const std::string& name_or_file) {
  const auto vehicle = LoadVehicle(name_or_file);
  PrintDescription(*vehicle);
  PrintStatics(*vehicle);
  return kExitOk;
}

}  // namespace dbd
