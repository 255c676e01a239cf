#pragma once

#include <array>
#include <cstddef>

namespace dbd {

/// Parts of a step of the engine.
enum class Stage { kFrames, kTireContact, kLinksAndSprings, kPointContacts, kTireForce, kMotion };
inline constexpr std::size_t kStages = 6;
inline constexpr std::array<const char*, kStages> kStageNames = {
    "body_frames",    "tire_contact",   "links_and_springs",
    "point_contacts", "tire_force_law", "integration"};

}  // namespace dbd
