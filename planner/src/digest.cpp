#include "digest.h"

#include <bit>

namespace dbd {
namespace {

class Hash {
 public:
  void Add(std::uint64_t value) {
    for (int i = 0; i < 8; ++i) {
      hash_ = (hash_ ^ ((value >> (8 * i)) & 0xff)) * 1099511628211ull;
    }
  }
  void Add(double value) { Add(std::bit_cast<std::uint64_t>(value)); }
  void Add(const std::string& text) {
    for (const char c : text) Add(static_cast<std::uint64_t>(static_cast<unsigned char>(c)));
    Add(static_cast<std::uint64_t>(text.size()));
  }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 1469598103934665603ull;
};

void AddRollout(const Rollout& rollout, Hash& hash) {
  hash.Add(static_cast<std::uint64_t>(rollout.outcome));
  hash.Add(rollout.reason);
  for (const double value : {rollout.place.x(), rollout.place.y(), rollout.place.z(), rollout.time,
                             rollout.distance, rollout.energy, rollout.progress}) {
    hash.Add(value);
  }
  for (const LimitMargin& margin : rollout.margins) hash.Add(margin.margin);
  for (const TraceSample& s : rollout.trace) {
    for (const double value : {s.t, s.s, s.x, s.y, s.z, s.yaw, s.pitch, s.roll, s.speed, s.slip}) {
      hash.Add(value);
    }
  }
}

}  // namespace

std::uint64_t DigestOf(const Plan& plan) {
  Hash hash;
  hash.Add(static_cast<std::uint64_t>(plan.status));
  hash.Add(plan.reason);
  hash.Add(static_cast<std::uint64_t>(plan.chosen.value_or(-1)));
  for (const Candidate& candidate : plan.candidates) {
    hash.Add(candidate.origin);
    hash.Add(candidate.layer_cost);
    for (const SpeedCap& cap : candidate.speed_caps) {
      for (const double value : {cap.from, cap.to, cap.speed}) hash.Add(value);
    }
    for (const Eigen::Vector2d& p : candidate.path.points()) hash.Add(p.x()), hash.Add(p.y());
    for (const PathStretch& stretch : candidate.path.stretches()) {
      if (stretch.reverse) hash.Add(stretch.begin), hash.Add(stretch.end);
    }
  }
  for (const Rollout& rollout : plan.rollouts) AddRollout(rollout, hash);
  for (const Score& score : plan.scores) hash.Add(score.total);
  for (const std::optional<SuccessEstimate>& estimate : plan.success) {
    if (!estimate) continue;
    hash.Add(static_cast<std::uint64_t>(estimate->draws));
    hash.Add(static_cast<std::uint64_t>(estimate->reached));
    hash.Add(estimate->mean_score);
  }
  return hash.value();
}

}  // namespace dbd
