#pragma once

#include <algorithm>
#include <cstdint>

namespace dbd {

/// Decides, from measured times, whether the next rounds of a lock-step run are shared among
/// threads or done by one: whichever was faster per round when last tried. The loser is tried again
/// for a share of the time that shrinks as it keeps losing, so that a wrong choice costs little and
/// a change of the machine's load is noticed.
///
/// A pure function of what it is told; both ways give the same bits, so that it changes no result.
class CutOver {
 public:
  struct Plan {
    bool parallel = false;
    std::int64_t rounds = 0;
  };

  /// What to do next, of at most `left` rounds.
  Plan Next(std::int64_t left) const {
    const bool trial = rounds_to_trial_ <= 0;
    const bool parallel = trial ? !prefers_parallel_ : prefers_parallel_;
    const std::int64_t wanted = trial ? TrialRounds() : rounds_to_trial_;
    return {parallel, std::clamp<std::int64_t>(wanted, 1, left)};
  }

  /// How long a plan's rounds took [s].
  void Report(const Plan& plan, double seconds) {
    double& per_round = plan.parallel ? parallel_ : serial_;
    const double now = seconds / static_cast<double>(plan.rounds);
    const bool trial = plan.parallel != prefers_parallel_;
    per_round = trial || per_round == 0 ? now : 0.5 * (per_round + now);
    if (!trial) {
      rounds_to_trial_ -= plan.rounds;
      return;
    }
    const bool better_parallel = parallel_ < kMustGain * serial_;
    const bool changes = serial_ > 0 && better_parallel != prefers_parallel_;
    prefers_parallel_ = serial_ > 0 ? better_parallel : false;
    patience_ = changes ? kLeastPatience : std::min(2 * patience_, kMostPatience);
    rounds_to_trial_ = patience_ * TrialRounds();
  }

 private:
  static constexpr double kTrial = 1e-3;              // [s] long against the start of the threads
  static constexpr double kMustGain = 0.97;           // sharing has to be worth it
  static constexpr std::int64_t kLeastPatience = 16;  // trials' lengths between two trials
  static constexpr std::int64_t kMostPatience = 512;

  std::int64_t TrialRounds() const {
    const double known = prefers_parallel_ ? parallel_ : serial_;
    return known > 0 ? std::max<std::int64_t>(1, static_cast<std::int64_t>(kTrial / known)) : 8;
  }

  bool prefers_parallel_ = false;
  double serial_ = 0;  // [s] per round; 0: not measured
  double parallel_ = 0;
  std::int64_t patience_ = kLeastPatience;
  std::int64_t rounds_to_trial_ = 8;  // serial rounds, to know how long they are
};

}  // namespace dbd
