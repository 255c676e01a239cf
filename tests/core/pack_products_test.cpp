// Products that go into sums, where the instruction set has fused multiply-adds.

#include "pack_products.h"

#include <dbd/core/simulation_lanes.h>
#include <gtest/gtest.h>

#include <cmath>

namespace dbd {
namespace {

template <class S>
void ExpectRoundedOnce(ProductLanes lanes) {
  // c nearly cancels a b, so that what rounding takes from the product shows.
  const S a = S(1) + S(3) / 7, b = S(-5) / 3, c = S(29) / 12, d = S(2) / 9;
  PackProducts products{};
  if (!MultiplyInPacks(lanes, a, b, c, d, products)) GTEST_SKIP() << "no wide lanes in this build";
  const S sum = std::fma(a, b, c), reverse = std::fma(-a, b, c);
  const S wanted[PackProducts::kCount] = {a * b,
                                          sum,
                                          sum,
                                          std::fma(a, b, -c),
                                          reverse,
                                          std::fma(a, b, c * d),
                                          std::fma(a, b, -(c * d)),
                                          a * b * c,
                                          sum,
                                          reverse,
                                          sum};
  for (int i = 0; i < PackProducts::kCount; ++i) {
    EXPECT_EQ(static_cast<S>(products.number[i]), wanted[i]) << i;
  }
  EXPECT_NE(sum, a * b + c);
}

TEST(PackProducts, AreRoundedTogetherWithTheSumThatTheyGoInto) {
  if (!LaneKindAvailable(LaneKind::kFloat8)) GTEST_SKIP() << "no AVX2";
  ExpectRoundedOnce<float>(ProductLanes::kFloat4);
  ExpectRoundedOnce<float>(ProductLanes::kFloat8);
  ExpectRoundedOnce<double>(ProductLanes::kDouble4);
}

}  // namespace
}  // namespace dbd
