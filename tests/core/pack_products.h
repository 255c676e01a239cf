#pragma once

namespace dbd {

/// What packs make of sums and differences of products, in a translation unit with fused
/// multiply-adds: `number` of their second lane.
struct PackProducts {
  static constexpr int kCount = 11;
  double number[kCount];
};

enum class ProductLanes { kFloat4, kFloat8, kDouble4 };

/// False where this build has no such instructions.
bool MultiplyInPacks(ProductLanes lanes, double a, double b, double c, double d,
                     PackProducts& products);

}  // namespace dbd
