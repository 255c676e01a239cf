#include "counted.h"

#include <gtest/gtest.h>

namespace dbd {
namespace {

using enum Operation;

class CountedTest : public testing::Test {
 protected:
  CountedTest() {
    OperationTally::memory.clear();
    OperationTally::counts = &counts_;
  }
  ~CountedTest() override { OperationTally::counts = nullptr; }

  OperationCounts counts_;
};

// (a b + c) / sqrt(a): each once, the sum takes the product along.
TEST_F(CountedTest, CountsEachOperationOnceForAllLanes) {
  const Counted<4> a({1, 4, 9, 16}), b({2, 2, 2, 2}), c({1, 0, -1, 3});
  const Counted<4> result = (a * b + c) / Sqrt(a);
  EXPECT_EQ(result.v, (std::array<double, 4>{3, 4, 17.0 / 3, 8.75}));
  EXPECT_EQ(counts_[kMultiply], 1);
  EXPECT_EQ(counts_[kAdd], 1);
  EXPECT_EQ(counts_[kFused], 1);
  EXPECT_EQ(counts_[kDivide], 1);
  EXPECT_EQ(counts_[kSquareRoot], 1);
  EXPECT_EQ(Flops(counts_), 4);
  EXPECT_EQ(SimpleOperations(counts_), 2);
}

TEST_F(CountedTest, CountsWhatChoosesApartFromFlops) {
  const Counted<2> a({1, -2}), b({0, 3});
  const Counted<2> chosen = Select(a < b, Abs(a), Max(a, b));
  EXPECT_EQ(chosen.v, (std::array<double, 2>{1, 2}));
  EXPECT_EQ(counts_[kCompare], 1);
  EXPECT_EQ(counts_[kSelect], 1);
  EXPECT_EQ(counts_[kAbsolute], 1);
  EXPECT_EQ(counts_[kExtreme], 1);
  EXPECT_EQ(Flops(counts_), 0);
  EXPECT_EQ(SimpleOperations(counts_), 4);
  EXPECT_TRUE(AnyOf(a < b));
  EXPECT_FALSE(AnyOf(a > Counted<2>(5)));
}

// a b + c d are two products and one sum, which takes one of them along, not two.
TEST_F(CountedTest, OneProductIsFusedIntoOneSum) {
  const Counted<1> a(2), b(3), sum = a * b + b * a;
  EXPECT_EQ(sum.v[0], 12);
  EXPECT_EQ(counts_[kFused], 1);
  EXPECT_EQ(counts_[kConstant], 2);
}

TEST_F(CountedTest, LoadsAndStoresAreThoseOfRegisteredArrays) {
  std::vector<Counted<1>> state(3, Counted<1>(1));
  OperationTally::memory.emplace_back(state.data(), state.data() + state.size());
  counts_ = {};
  const Counted<1> sum = state[0] + state[1];
  EXPECT_EQ(counts_[kLoad], 2);
  const Counted<1> twice = sum + sum;
  EXPECT_EQ(counts_[kLoad], 2);
  state[2] = twice;
  EXPECT_EQ(counts_[kLoad], 2);
  EXPECT_EQ(counts_[kStore], 1);
  EXPECT_EQ(state[2].v[0], 4);
}

TEST_F(CountedTest, ExponentialsAndCubeRootsStandForTheirSeries) {
  const Counted<1> x = Exp(Counted<1>(1)) + Cbrt(Counted<1>(8));
  EXPECT_NEAR(x.v[0], std::exp(1.0) + 2, 1e-12);
  const OperationCounts expanded = Expanded(counts_);
  EXPECT_EQ(expanded[kExponential], 0);
  EXPECT_EQ(expanded[kDivide], 2);
  EXPECT_GT(Flops(expanded), 30);
}

}  // namespace
}  // namespace dbd
