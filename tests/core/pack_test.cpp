#include "pack.h"

#include <gtest/gtest.h>

namespace dbd {
namespace {

template <class PackType>
class PackOf : public ::testing::Test {};
using PackTypes = ::testing::Types<Pack<float, 4>, Pack<float, 8>, Pack<float, 16>, Pack<double, 2>,
                                   Pack<double, 4>, Pack<double, 8>>;
TYPED_TEST_SUITE(PackOf, PackTypes);

/// Lanes first, first + step, ...
template <class P>
P Ramp(double first, double step) {
  ScalarOf<P> values[LaneTraits<P>::kLanes];
  for (int i = 0; i < LaneTraits<P>::kLanes; ++i) {
    values[i] = static_cast<ScalarOf<P>>(first + i * step);
  }
  return LaneTraits<P>::Load(values);
}

/// Expects f(lane) in every lane, to `tolerance` of its size.
template <class P, class Function>
void ExpectLanes(const P& pack, const P& argument, double tolerance, const Function& f) {
  for (int i = 0; i < LaneTraits<P>::kLanes; ++i) {
    const double want = f(static_cast<double>(argument.v[i]));
    EXPECT_NEAR(pack.v[i], want, tolerance * std::abs(want)) << "at " << argument.v[i];
  }
}

template <class P>
constexpr double kRoundOff = sizeof(ScalarOf<P>) == 4 ? 3e-7 : 1e-15;

TYPED_TEST(PackOf, ArithmeticAndChoicesGoLaneByLane) {
  using P = TypeParam;
  using S = ScalarOf<P>;
  const P a = Ramp<P>(-1, 0.75);
  const P b(S(0.5));
  ExpectLanes(a + b, a, 0, [](double x) { return x + 0.5; });
  ExpectLanes(a - b, a, 0, [](double x) { return x - 0.5; });
  ExpectLanes(a * b, a, 0, [](double x) { return x * 0.5; });
  ExpectLanes(a / b, a, 0, [](double x) { return x / 0.5; });
  ExpectLanes(Min(a, b), a, 0, [](double x) { return std::min(x, 0.5); });
  ExpectLanes(Max(a, b), a, 0, [](double x) { return std::max(x, 0.5); });
  ExpectLanes(Abs(a), a, 0, [](double x) { return std::abs(x); });
  ExpectLanes(Select(a < b, a, b + b), a, 0, [](double x) { return x < 0.5 ? x : 1.0; });
}

TYPED_TEST(PackOf, AnyOfSeesASingleLane) {
  using P = TypeParam;
  EXPECT_FALSE(AnyOf(P(1) > P(2)));
  for (int i = 0; i < LaneTraits<P>::kLanes; ++i) {
    P a(1);
    a.v[i] = 3;
    EXPECT_TRUE(AnyOf(a > P(2))) << "lane " << i;
  }
}

TYPED_TEST(PackOf, RootsAndExponentialsAreExactToRoundOff) {
  using P = TypeParam;
  for (double first = 1e-9; first < 1e4; first *= 3.7) {
    const P a = Ramp<P>(first, 0.13 * first);
    ExpectLanes(Sqrt(a), a, kRoundOff<P>, [](double x) { return std::sqrt(x); });
    ExpectLanes(Cbrt(a), a, kRoundOff<P>, [](double x) { return std::cbrt(x); });
  }
  for (double first = -40; first < 5; first += 0.37) {
    const P a = Ramp<P>(first, 0.021);
    ExpectLanes(Exp(a), a, kRoundOff<P>, [](double x) { return std::exp(x); });
  }
}

TYPED_TEST(PackOf, ExponentialOfZeroIsOneAndOfVeryLittleIsNothing) {
  using P = TypeParam;
  EXPECT_EQ(Exp(P(0)).v[0], 1);
  EXPECT_LT(Exp(P(-1000)).v[0], 1e-37);
  EXPECT_GE(Exp(P(-1000)).v[0], 0);
  EXPECT_EQ(Cbrt(P(0)).v[0], 0);
}

}  // namespace
}  // namespace dbd
