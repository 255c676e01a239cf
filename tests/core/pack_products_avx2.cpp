// Without the test framework: the linker may keep what is compiled here for the whole program.

#include "pack_products.h"

#include "lane_engine_includes.h"

#ifdef DBD_WIDE_LANES
#define DBD_PACK_TARGET 2
#pragma GCC target("avx2,fma")
#include "pack.h"

namespace dbd {
namespace {

template <class P>
void Multiply(double number_a, double number_b, double number_c, double number_d,
              PackProducts& products) {
  using S = ScalarOf<P>;
  const auto pack = [](double x) { return P(static_cast<S>(x)); };
  const P a = pack(number_a), b = pack(number_b), c = pack(number_c), d = pack(number_d);
  P sum = c, difference = c;
  sum += a * b;
  difference -= a * b;
  const P all[PackProducts::kCount] = {a * b,
                                       a * b + c,
                                       c + a * b,
                                       a * b - c,
                                       c - a * b,
                                       a * b + c * d,
                                       a * b - c * d,
                                       a * b * c,
                                       sum,
                                       difference,
                                       static_cast<S>(number_a) * b + c};
  for (int i = 0; i < PackProducts::kCount; ++i) products.number[i] = NumberOf(all[i], 1);
}

}  // namespace

bool MultiplyInPacks(ProductLanes lanes, double a, double b, double c, double d,
                     PackProducts& products) {
  if (lanes == ProductLanes::kFloat4) Multiply<Pack<float, 4>>(a, b, c, d, products);
  if (lanes == ProductLanes::kFloat8) Multiply<Pack<float, 8>>(a, b, c, d, products);
  if (lanes == ProductLanes::kDouble4) Multiply<Pack<double, 4>>(a, b, c, d, products);
  return true;
}

}  // namespace dbd
#else
namespace dbd {

bool MultiplyInPacks(ProductLanes, double, double, double, double, PackProducts&) { return false; }

}  // namespace dbd
#endif
