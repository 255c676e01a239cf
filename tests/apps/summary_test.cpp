#include "summary.h"

#include <gmock/gmock.h>

#include "apps/synthetic_plan.h"
#include "support/temporary_directory.h"

namespace dbd {
namespace {

using testing::HasSubstr;

TEST(Summary, SaysWhatWasFoundAndHowTightItIs) {
  const TemporaryDirectory scratch;
  const SyntheticPlan made = MakePlan(kUtm33);
  const std::string text = PlanSummary(made.record(), OutputDirectory(scratch.File("out")));
  EXPECT_THAT(text, HasSubstr("Route found: candidate 0 (roadmap)"));
  // 160 m in 32 s is 5 m/s = 18 km/h; 36 kJ / 3.6 MJ = 0.01 kWh.
  EXPECT_THAT(text, HasSubstr("160 m in 32.0 s, mean 18.0 km/h, 0.01 kWh"));
  EXPECT_THAT(text, HasSubstr("clearance 0.025 m, limit 0.020 m (25 % left), after 10 m"));
  EXPECT_THAT(text, HasSubstr("2 candidates: 1 reached, 1 immobilized"));
  EXPECT_THAT(text, HasSubstr("48 s of driving in 0.25 s (192 x real time), all in 0.75 s"));
}

TEST(Summary, SaysWhyAndWhereThereIsNoRoute) {
  const TemporaryDirectory scratch;
  const SyntheticPlan made = MakeNoGoPlan(kUtm33);
  const std::string text = PlanSummary(made.record(), OutputDirectory(scratch.File("out")));
  EXPECT_THAT(text, HasSubstr("No safe route: every candidate stops at the bank"));
  EXPECT_THAT(text, HasSubstr("at 500100.0, 5000060.0"));
}

TEST(Summary, HeadlineFitsAMap) {
  EXPECT_EQ(PlanHeadline(MakePlan("").record()), "160 m route for test-car: 32.0 s");
  EXPECT_EQ(PlanHeadline(MakeNoGoPlan("").record()), "No safe route for test-car");
}

}  // namespace
}  // namespace dbd
