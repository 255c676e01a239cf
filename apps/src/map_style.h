#pragma once

#include <dbd/planner/plan_types.h>

namespace dbd {

/// A colour, parts in [0, 1].
struct Color {
  double red = 0;
  double green = 0;
  double blue = 0;
};

constexpr Color Mix(const Color& a, const Color& b, double share_of_b) {
  return {a.red + share_of_b * (b.red - a.red), a.green + share_of_b * (b.green - a.green),
          a.blue + share_of_b * (b.blue - a.blue)};
}

constexpr Color Hex(unsigned rgb) {
  return {(rgb >> 16 & 255) / 255.0, (rgb >> 8 & 255) / 255.0, (rgb & 255) / 255.0};
}

inline constexpr Color kRouteColor = Hex(0x12348c);
inline constexpr Color kStartColor = Hex(0x009e73);
inline constexpr Color kGoalColor = Hex(0xc8102e);
inline constexpr Color kBlockedColor = Hex(0xc8102e);
inline constexpr Color kObstacleColor = Hex(0x2f5233);
inline constexpr Color kUnknownColor = Hex(0xdcdcdc);
inline constexpr Color kHatchColor = Hex(0xb4b4b4);
inline constexpr Color kImpassableColor = Hex(0x6fa8d6);
inline constexpr Color kInkColor = Hex(0x222222);
inline constexpr Color kPaperColor = Hex(0xffffff);

/// Okabe and Ito's palette, which stays apart for colour-blind readers ("Color Universal Design",
/// 2008).
constexpr Color OutcomeColor(Outcome outcome) {
  switch (outcome) {
    case Outcome::kReached:
      return Hex(0x0072b2);
    case Outcome::kLimitExceeded:
      return Hex(0xe69f00);
    case Outcome::kImmobilized:
      return Hex(0xd55e00);
    case Outcome::kRolledOver:
      return Hex(0xcc79a7);
    case Outcome::kCollided:
      return Hex(0x000000);
    case Outcome::kLeftMap:
      return Hex(0x5f5f5f);
    case Outcome::kTimedOut:
      return Hex(0xf0e442);
    case Outcome::kDiverged:
      return Hex(0x7a4fb0);
    case Outcome::kCancelled:
      return Hex(0xb0b0b0);
  }
  return Hex(0xb0b0b0);
}

}  // namespace dbd
