#pragma once

#include <vector>

#include "candidate_variants.h"

namespace dbd {

/// Drivers cut corners and drift down slopes by some tenths of a metre, which among trees decides.
/// Of the candidates whose drive touched an obstacle, the cheapest `most` by the layer with their
/// paths moved to the other side by as much as the drive was off: the next one then goes about
/// where the first should have gone (one step of iterative learning control). Corrected candidates
/// are corrected again. Routes in reverse are left alone.
std::vector<Candidate> CorrectCollided(const VehicleModel& vehicle, const DrivenCandidates& driven,
                                       int most);

}  // namespace dbd
