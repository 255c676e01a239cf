// Driving allocates no memory: this file counts every allocation of the test program's threads.
#include <dbd/core/scenario.h>
#include <dbd/core/scene.h>
#include <dbd/core/simulation.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "support/core_vehicle.h"

namespace {
thread_local long allocations = 0;

void* Counted(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
}  // namespace

void* operator new(std::size_t size) { return Counted(size); }
void* operator new[](std::size_t size) { return Counted(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

namespace dbd {
namespace {

TEST(SimulationAllocation, AdvanceAllocatesNothing) {
  const auto ground = MakeRandomGround(0, 0.1, 0.5, 2);
  Simulation simulation(Tm27(), *ground);
  simulation.Place(Eigen::Vector2d::Zero(), 0);
  const long before = allocations;
  for (int i = 0; i < 250; ++i) simulation.Advance({.steer = 0.1, .engine_torque = 60});
  EXPECT_EQ(allocations, before);
}

TEST(SimulationAllocation, DriverAndViewsAllocateNothing) {
  const auto ground = MakePlaneGround(0, 0);
  Simulation simulation(Tm27(), *ground);
  simulation.Place(Eigen::Vector2d::Zero(), 0);
  const Driver driver(Tm27(), Path({{0, 0}, {10, 1}, {20, 0}}), {});
  DriverState state;
  double load = 0;
  const long before = allocations;
  for (int i = 0; i < 250; ++i) {
    const DriverView view = simulation.ViewForDriver();
    simulation.Advance(driver.Update(view, simulation.control_step(), state));
    load += simulation.Wheel(0).load + simulation.Chassis().pitch;
  }
  EXPECT_EQ(allocations, before);
  EXPECT_GT(load, 0);
}

TEST(SimulationAllocation, SceneAllocatesNothing) {
  const auto ground = MakePlaneGround(0, 0);
  const auto car = std::make_shared<const VehicleModel>(Tm27());
  const auto driver = std::make_shared<const Driver>(*car, Path({{-20, 0}, {50, 0}}),
                                                     DriverOptions{.target_speed = 3});
  std::vector<SceneVehicle> vehicles(3, {.model = car, .driver = driver});
  for (int i = 0; i < 3; ++i) {
    vehicles[static_cast<std::size_t>(i)].position.x() = -3.2 * i;
    vehicles[static_cast<std::size_t>(i)].ahead = i - 1;
  }
  Scene scene(vehicles, *ground);
  SerialExecutor serial;
  const long before = allocations;
  for (int i = 0; i < 5; ++i) scene.Advance(0.1, serial);
  EXPECT_EQ(allocations, before);
}

}  // namespace
}  // namespace dbd
