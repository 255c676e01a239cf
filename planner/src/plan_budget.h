#pragma once

#include <dbd/planner/plan_types.h>

#include <algorithm>
#include <cmath>

namespace dbd {

/// How many candidates each part of a plan may drive.
struct Budget {
  explicit Budget(const PlanOptions& options) : all(options.sampling.candidates), first(all) {
    const LearningOptions& learning = options.learning;
    if (learning.rounds == 1) return;
    first = static_cast<int>(std::ceil(learning.first_share * all));
    first = std::clamp(first, std::min(all, kFewestToLearnFrom), all);
    if (first < all) variant_share = std::min(1.0, learning.polish_share * all / (all - first));
  }

  /// Of `count` candidates of a later round.
  int Variants(int count) const { return static_cast<int>(variant_share * count); }

  static constexpr int kFewestToLearnFrom = 8;
  int all;
  int first;
  double variant_share = 0;  ///< of every later round
};

}  // namespace dbd
