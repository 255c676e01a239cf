#pragma once

#include <cstdint>

namespace dbd {

// OMPL 1.5 draws the seed of every random number generator from one process-wide generator, in
// the order in which they are made: with several threads the order, and so every result, is
// chance. This module defines OMPL's default constructor of its generator, which takes precedence
// over the one in the shared library, and gives each thread the seeds of its own scope.

/// While one of these lives, every OMPL generator made by this thread is seeded from `seed`: the
/// first, second, third ... always get the same seeds. Scopes nest; the outer one goes on where it
/// was. Make and run a planner within one scope, on one thread.
class OmplSeedScope {
 public:
  explicit OmplSeedScope(std::uint64_t seed);
  ~OmplSeedScope();
  OmplSeedScope(const OmplSeedScope&) = delete;
  OmplSeedScope& operator=(const OmplSeedScope&) = delete;

 private:
  std::uint64_t state_;
  OmplSeedScope* outer_;

  friend class OmplSeedSource;
};

/// Whether OMPL's own code makes its generators by our constructor. False in a program whose
/// linker bound OMPL's calls to OMPL itself (static or -Bsymbolic builds): its routes would then
/// not be reproducible.
bool OmplSeedsAreOurs();

}  // namespace dbd
