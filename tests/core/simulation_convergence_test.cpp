// How the error of a drive shrinks with the steps.
//
// Leapfrog is of second order where forces depend on places alone: the undamped vehicle in
// engine_test.cpp shows it. A drive is of first order, and no better is expected: dampers read
// velocities that are half a step old, spin and slip advance by implicit Euler steps. Where a tire
// hits an edge, in A, the moment of contact is found to one step only, and the single halving is
// irregular.
#include <gtest/gtest.h>

#include "support/core_trace.h"
#include "support/core_vehicle.h"

namespace dbd {
namespace {

/// Errors of the chassis height with steps of 2, 1 and 0.5 ms against 0.125 ms, the ground sampled
/// at every second step.
std::array<double, 3> ErrorsIn(const Scenario& scenario) {
  const auto drive = [&](double step) {
    return DriveScenario(scenario, WithStepSizes(Tm27(), step, 2 * step));
  };
  const auto fine = drive(0.125e-3);
  const double end = fine.back().p_WB.x() - 0.3;
  const auto reference = HeightsAlong(fine, end);
  std::array<double, 3> errors{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double step = 2e-3 / static_cast<double>(1 << i);
    errors[i] = RmsDifference(HeightsAlong(drive(step), end), reference);
    ::testing::Test::RecordProperty(scenario.name + std::to_string(i) + "_nm",
                                    static_cast<int>(1e9 * errors[i]));
  }
  return errors;
}

// The first-order error is proportional to h - 0.125 ms: factors of 1.875/0.875 = 2.14 and
// 0.875/0.375 = 2.33.
void ExpectFirstOrder(const std::string& name) {
  const auto [coarse, middle, fine] = ErrorsIn(MakeScenario(name));
  EXPECT_LT(coarse, 0.1e-3);  // of a range of 122 mm in B, 62 mm in C
  EXPECT_NEAR(coarse / middle, 2.14, 0.25);
  EXPECT_NEAR(middle / fine, 2.33, 0.25);
}

TEST(Convergence, HalvingTheStepsHalvesTheErrorOnWaves) { ExpectFirstOrder("B"); }
TEST(Convergence, HalvingTheStepsHalvesTheErrorOnARoughRoad) { ExpectFirstOrder("C"); }

TEST(Convergence, QuarteringTheStepsQuartersTheErrorOverAnObstacle) {
  const auto [coarse, middle, fine] = ErrorsIn(MakeScenario("A"));
  EXPECT_LT(coarse, 0.5e-3);  // of a range of 116 mm
  EXPECT_LT(middle, coarse);
  EXPECT_GT(coarse / fine, 3);
}

}  // namespace
}  // namespace dbd
