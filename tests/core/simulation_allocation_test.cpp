// Driving allocates no memory: this file counts every allocation of the test program's threads.
#include <dbd/core/scenario.h>
#include <dbd/core/scene.h>
#include <dbd/core/simulation.h>
#include <dbd/core/simulation_lanes.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "support/core_vehicle.h"

namespace {
thread_local long allocations = 0;

void* Allocate(std::size_t size) {
  ++allocations;
  return std::malloc(size == 0 ? 1 : size);
}

void* OrThrow(void* memory) {
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
}  // namespace

// All forms that are in use here, so that each delete meets the new that belongs to it.
void* operator new(std::size_t size) { return OrThrow(Allocate(size)); }
void* operator new[](std::size_t size) { return OrThrow(Allocate(size)); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return Allocate(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return Allocate(size); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  ++allocations;
  const auto unit = static_cast<std::size_t>(alignment);
  return OrThrow(std::aligned_alloc(unit, (size + unit - 1) / unit * unit));
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace dbd {
namespace {

TEST(SimulationAllocation, AdvanceAllocatesNothing) {
  const auto ground = MakeRandomGround(0, 0.1, 0.5, 2);
  for (const bool wheel_lanes : {false, true}) {
    Simulation simulation(Tm27(), *ground, {.wheel_lanes = wheel_lanes});
    simulation.Place(Eigen::Vector2d::Zero(), 0);
    const long before = allocations;
    for (int i = 0; i < 250; ++i) simulation.Advance({.steer = 0.1, .engine_torque = 60});
    EXPECT_EQ(allocations, before);
  }
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

TEST(SimulationAllocation, LanesAllocateNothing) {
  const auto ground = MakeRandomGround(0, 0.1, 0.5, 2);
  SimulationLanes lanes(Tm27(), *ground);
  for (int lane = 0; lane < lanes.lanes(); ++lane) lanes.Place(lane, {0.5 * lane, 0}, 0, 0.1);
  const std::vector<DriverCommand> commands(static_cast<std::size_t>(lanes.lanes()),
                                            {.steer = 0.1, .engine_torque = 60});
  const long before = allocations;
  for (int i = 0; i < 250; ++i) lanes.Advance(commands);
  EXPECT_EQ(allocations, before);
  EXPECT_TRUE(lanes.driving(0));
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
