#define DBD_NO_FLATTEN
#include "count_stages.h"

#include <gtest/gtest.h>

#include "counted_surface.h"
#include "initial_state.h"
#include "scenario_drives.h"
#include "step_stages.h"
#include "support/core_vehicle.h"

namespace dbd {
namespace {

using enum Operation;

const Terrain& Ground() { return ScenarioTerrain("C", 100); }

EngineState<double> Start() {
  return InitialState<double>(Tm27(), Ground(), Eigen::Vector2d::Zero(), 0);
}

struct NoMark {
  void Begin() {}
  void operator()(Stage) {}
};

void ExpectEqual(const EngineState<double>& a, const EngineState<double>& b, double tolerance) {
  for (std::size_t i = 0; i < a.bodies.size(); ++i) {
    EXPECT_NEAR(a.bodies[i].p_WB.x, b.bodies[i].p_WB.x, tolerance);
    EXPECT_NEAR(a.bodies[i].p_WB.z, b.bodies[i].p_WB.z, tolerance);
    EXPECT_NEAR(a.bodies[i].w_WB.y, b.bodies[i].w_WB.y, 1e3 * tolerance);
  }
}

// What is timed and counted is the engine's own step.
TEST(StepStages, TogetherAreTheEnginesStep) {
  StageDrive<double> stages(Tm27(), Start()), whole(Tm27(), Start());
  NoMark mark;
  Drive<double, dbd::Ground>(stages, Ground(), 2000, mark);
  for (int i = 0; i < 2000; ++i) {
    if (whole.state.step % whole.engine.control_every == 0) whole.HoldSpeed();
    StepEngine(whole.engine, static_cast<const dbd::Ground&>(Ground()), whole.controls, whole.state,
               whole.work);
  }
  EXPECT_GT(stages.state.bodies[0].p_WB.x, 3);
  ExpectEqual(stages.state, whole.state, 0);
}

// The counting number calculates as the others do, on a surface that reads the same grid.
TEST(StepStages, CountingDoesNotChangeTheDrive) {
  StageDrive<double> numbers(Tm27(), Start());
  StageDrive<Counted<1>> counted(Tm27(), Start());
  NoMark mark;
  Drive<double, dbd::Ground>(numbers, Ground(), 1500, mark);
  Drive(counted, CountedSurface<1>(Ground()), 1500, mark);
  EXPECT_GT(numbers.state.bodies[0].p_WB.x, 3);
  EXPECT_NEAR(counted.state.bodies[0].p_WB.x.v[0], numbers.state.bodies[0].p_WB.x, 1e-6);
  EXPECT_NEAR(counted.state.bodies[0].p_WB.z.v[0], numbers.state.bodies[0].p_WB.z, 1e-6);
}

// Five bodies' rotation matrices: 9 products of quaternion elements, 15 sums and differences and 6
// doublings each.
TEST(CountStages, FramesAreThirtyFlopsPerBody) {
  const StageCounts counts = CountStages(Tm27(), Ground(), 1);
  const OperationCounts& frames = counts[static_cast<std::size_t>(Stage::kFrames)];
  EXPECT_EQ(Flops(frames), 5 * 30);
  EXPECT_EQ(SimpleOperations(frames), Flops(frames));
  EXPECT_EQ(frames[kStore], 5 * 9);
}

// 15 links and 4 springs: a root and a quotient each.
TEST(CountStages, LinksAndSpringsTakeARootEach) {
  const StageCounts counts = CountStages(Tm27(), Ground(), 1);
  const OperationCounts& links = counts[static_cast<std::size_t>(Stage::kLinksAndSprings)];
  const double elements = static_cast<double>(Tm27().links.size() + Tm27().springs.size());
  EXPECT_EQ(links[kSquareRoot], elements);
  EXPECT_EQ(links[kDivide], elements);
  EXPECT_EQ(links[kHeightRead], 0);
}

// A pack does what any of its lanes needs.
TEST(CountStages, APackReadsAtLeastAsManyHeightsAsALoneVehicle) {
  const auto contact = static_cast<std::size_t>(Stage::kTireContact);
  const OperationCounts alone = CountStages(Tm27(), Ground(), 1)[contact];
  const OperationCounts pack = CountStages(Tm27(), Ground(), 4)[contact];
  EXPECT_GT(alone[kHeightRead], 10);  // every second step, three planes of some rows at four wheels
  EXPECT_GE(pack[kHeightRead], alone[kHeightRead]);
  EXPECT_EQ(pack[kBoundRead], alone[kBoundRead]);
}

}  // namespace
}  // namespace dbd
