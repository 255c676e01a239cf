#include <dbd/planner/ompl_random.h>

#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/util/RandomNumbers.h>

#include <atomic>

#include "candidate_random.h"

namespace dbd {
namespace {

thread_local OmplSeedScope* current_scope = nullptr;

// Generators that somebody makes outside any scope: different seeds, in order of construction.
std::atomic<std::uint64_t> unscoped_count{0};

}  // namespace

class OmplSeedSource {
 public:
  static std::uint_fast32_t Next() {
    const std::uint64_t value = current_scope != nullptr ? NextInScope() : ++unscoped_count;
    // The upper half mixes best; zero is not a seed.
    return static_cast<std::uint_fast32_t>((DeriveSeed(value, 0) >> 32) | 1u);
  }

 private:
  static std::uint64_t NextInScope() {
    SplitMix64 random(current_scope->state_);
    current_scope->state_ = random.Next();
    return current_scope->state_;
  }
};

OmplSeedScope::OmplSeedScope(std::uint64_t seed) : state_(seed), outer_(current_scope) {
  current_scope = this;
}

OmplSeedScope::~OmplSeedScope() { current_scope = outer_; }

bool OmplSeedsAreOurs() {
  // A sampler that OMPL's own library constructs, generator included, gives equal samples in
  // scopes of equal seed if and only if our constructor is the one called.
  const auto sample = [] {
    const OmplSeedScope scope(42);
    ompl::base::RealVectorStateSpace space(1);
    space.setBounds(0.0, 1.0);
    space.setup();
    const ompl::base::StateSamplerPtr sampler = space.allocDefaultStateSampler();
    auto* state = space.allocState()->as<ompl::base::RealVectorStateSpace::StateType>();
    sampler->sampleUniform(state);
    const double value = state->values[0];
    space.freeState(state);
    return value;
  };
  return sample() == sample();
}

}  // namespace dbd

ompl::RNG::RNG() : RNG(dbd::OmplSeedSource::Next()) {}
