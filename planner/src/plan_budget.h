#pragma once

#include <dbd/planner/plan_types.h>

#include <algorithm>
#include <cmath>

namespace dbd {

/// How many candidates each part of a plan may drive.
struct Budget {
  explicit Budget(const PlanOptions& options) : all(options.sampling.candidates) {
    const LearningOptions& learning = options.learning;
    polish = static_cast<int>(learning.polish_share * all);
    first = learning.rounds == 1 ? all - polish
                                 : static_cast<int>(std::ceil(learning.first_share * all));
    first = std::clamp(first, std::min(all, kFewestToLearnFrom), all);
    polish = std::min(polish, all - first);
    const int learning_rounds = std::max(1, learning.rounds - 1);
    per_round = (all - first - polish + learning_rounds - 1) / learning_rounds;
  }

  static constexpr int kFewestToLearnFrom = 8;
  int all;
  int first = 0;
  int per_round = 0;
  int polish = 0;
};

}  // namespace dbd
