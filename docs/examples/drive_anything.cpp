// Drives a vehicle, from the database or from a file of one's own, over a ground that is a
// function: drive_anything [VEHICLE]

#include <dbd/core/error.h>
#include <dbd/core/simulation.h>
#include <dbd/core/vehicle_database.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace {

/// Waves of 0.2 m height and 8 m length, on firm soil.
class Waves final : public dbd::Ground {
 public:
  void Heights(int count, const double* x, const double*, double* z) const override {
    for (int i = 0; i < count; ++i) z[i] = 0.1 * std::sin(2 * M_PI / 8 * x[i]);
  }
  void Soils(int count, const double*, const double*, dbd::SoilSample* soil) const override {
    std::fill_n(soil, count, dbd::SoilSample{});
  }
};

}  // namespace

int main(int argc, char** argv) {
  try {
    const auto vehicle = dbd::LoadVehicle(argc > 1 ? argv[1] : "tomcar-tm27");
    const Waves ground;
    dbd::Simulation simulation(*vehicle, ground);
    simulation.Place({0, 0}, 0);
    dbd::Driver driver(*vehicle, dbd::Path(), {.target_speed = 5});
    driver.SetStart({0, 0}, 0);
    dbd::DriverState state;
    std::printf("  t [s]   x [m]   z [m]  speed [m/s]  pitch [deg]\n");
    for (double next = 0; simulation.time() < 6;) {
      if (simulation.time() >= next) {
        const dbd::ChassisView chassis = simulation.Chassis();
        std::printf("%7.2f %7.2f %7.3f %12.2f %12.2f\n", simulation.time(), chassis.p_WB.x(),
                    chassis.p_WB.z(), chassis.forward_speed, chassis.pitch * 180 / M_PI);
        next += 0.5;
      }
      simulation.Advance(
          driver.Update(simulation.ViewForDriver(), simulation.control_step(), state));
    }
    return 0;
  } catch (const dbd::InputError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
