#include <dbd/planner/dubins.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace dbd {
namespace {

constexpr double kFullTurn = 2.0 * std::numbers::pi;
// In a frame scaled by the radius. Nearly full turns are looked at for being rounded from zero;
// whether they are is decided by the distance between the end met and the end asked for.
constexpr double kNearlyFull = 1e-2;
constexpr double kEndTolerance = 1e-7;

double PositiveAngle(double angle) { return angle - kFullTurn * std::floor(angle / kFullTurn); }

// A unit-radius pose advanced by a piece of the given length.
Pose2 Advance(const Pose2& from, Turn turn, double length) {
  const double sign = static_cast<double>(turn);
  if (turn == Turn::kStraight) {
    return {from.x + length * std::cos(from.heading), from.y + length * std::sin(from.heading),
            from.heading};
  }
  const double heading = from.heading + sign * length;
  return {from.x + sign * (std::sin(heading) - std::sin(from.heading)),
          from.y - sign * (std::cos(heading) - std::cos(from.heading)), heading};
}

using Word = std::array<Turn, 3>;
using Lengths = std::array<double, 3>;

// From (0, 0, alpha) to (d, 0, beta) with unit radius: the frame of Shkel and Lumelsky.
struct Problem {
  Problem(double d_in, double alpha_in, double beta_in)
      : d(d_in),
        alpha(alpha_in),
        beta(beta_in),
        sa(std::sin(alpha)),
        ca(std::cos(alpha)),
        sb(std::sin(beta)),
        cb(std::cos(beta)) {}

  // Tries every word; the shortest is in `word` and `best` afterwards.
  void Solve() {
    TrySameTurns(Turn::kLeft);
    TrySameTurns(Turn::kRight);
    TryOppositeTurns(Turn::kLeft);
    TryOppositeTurns(Turn::kRight);
    TryThreeTurns(Turn::kLeft);
    TryThreeTurns(Turn::kRight);
  }

  double d, alpha, beta, sa, ca, sb, cb;
  Word word{Turn::kLeft, Turn::kStraight, Turn::kLeft};
  Lengths best{};
  double shortest = std::numeric_limits<double>::infinity();

 private:
  // A right-handed word is the left-handed one of the mirrored problem: angles change sign.
  void TrySameTurns(Turn turn) {
    const double sign = static_cast<double>(turn);
    const double x = d + sign * (sa - sb);
    const double y = cb - ca;
    const double theta = std::atan2(y, x);
    const Lengths lengths{PositiveAngle(theta - sign * alpha), std::hypot(x, y),
                          PositiveAngle(sign * beta - theta)};
    Offer({turn, Turn::kStraight, turn}, lengths);
    // The direction of a line of no length is noise, and so is the split between the turns.
    if (lengths[1] < kEndTolerance) {
      OfferIfMet({turn, Turn::kStraight, turn}, {PositiveAngle(sign * (beta - alpha)), 0, 0});
    }
  }

  void TryOppositeTurns(Turn first) {
    const double sign = static_cast<double>(first);
    const double x = d + sign * (sa + sb);
    const double y = -(ca + cb);
    const double straight_squared = x * x + y * y - 4.0;
    if (straight_squared < -1e-12) return;
    const double straight = std::sqrt(std::max(straight_squared, 0.0));
    const double theta = std::atan2(y, x) - std::atan2(-2.0, straight);
    Offer({first, Turn::kStraight, Mirror(first)},
          {PositiveAngle(theta - sign * alpha), straight, PositiveAngle(theta - sign * beta)});
  }

  void TryThreeTurns(Turn first) {
    const double sign = static_cast<double>(first);
    const double x = d + sign * (sa - sb);
    const double y = cb - ca;
    const double cosine = 1.0 - (x * x + y * y) / 8.0;
    if (cosine < -1.0) return;
    const double middle = kFullTurn - std::acos(std::min(cosine, 1.0));
    const double t = PositiveAngle(std::atan2(y, x) - sign * alpha + 0.5 * middle);
    Offer({first, Mirror(first), first},
          {t, middle, PositiveAngle(sign * (beta - alpha) - t + middle)});
  }

  static Turn Mirror(Turn turn) { return turn == Turn::kLeft ? Turn::kRight : Turn::kLeft; }

  void Offer(const Word& candidate, const Lengths& lengths) {
    Keep(candidate, lengths);
    if (lengths[0] > kFullTurn - kNearlyFull) {
      Lengths shorter{0.0, lengths[1], TurnLeft(candidate, 2, lengths[1])};
      OfferIfMet(candidate, shorter);
      shorter[2] = 0.0;
      OfferIfMet(candidate, shorter);
    }
    if (lengths[2] > kFullTurn - kNearlyFull) {
      OfferIfMet(candidate, {TurnLeft(candidate, 0, lengths[1]), lengths[1], 0.0});
    }
  }

  // What piece `piece` must turn when the other outer piece is left out.
  double TurnLeft(const Word& candidate, int piece, double middle) const {
    const double turned = static_cast<double>(candidate[1]) * middle;
    return PositiveAngle(static_cast<double>(candidate[piece]) * (beta - alpha - turned));
  }

  void OfferIfMet(const Word& candidate, const Lengths& lengths) {
    if (lengths[0] + lengths[1] + lengths[2] >= shortest) return;
    Pose2 end{0.0, 0.0, alpha};
    for (int i = 0; i < 3; ++i) end = Advance(end, candidate[i], lengths[i]);
    const double miss = std::hypot(end.x - d, end.y) + std::abs(WrapAngle(end.heading - beta));
    if (miss < kEndTolerance) Keep(candidate, lengths);
  }

  void Keep(const Word& candidate, const Lengths& lengths) {
    const double length = lengths[0] + lengths[1] + lengths[2];
    if (length >= shortest) return;
    shortest = length;
    word = candidate;
    best = lengths;
  }
};

Pose2 TurnedRound(Pose2 pose) {
  pose.heading = WrapAngle(pose.heading + std::numbers::pi);
  return pose;
}

DubinsCurve ShortestForwardCurve(const Pose2& from, const Pose2& to, double radius) {
  const double dx = to.x - from.x;
  const double dy = to.y - from.y;
  const double direction = std::atan2(dy, dx);
  Problem problem(std::hypot(dx, dy) / radius, from.heading - direction, to.heading - direction);
  problem.Solve();
  DubinsCurve curve;
  curve.turns = problem.word;
  curve.radius = radius;
  for (int i = 0; i < 3; ++i) curve.lengths[i] = problem.best[i] * radius;
  return curve;
}

}  // namespace

double WrapAngle(double angle) {
  const double wrapped = std::remainder(angle, kFullTurn);
  return wrapped <= -std::numbers::pi ? std::numbers::pi : wrapped;
}

DubinsCurve ShortestDubinsCurve(const Pose2& from, const Pose2& to, double radius) {
  if (!to.reverse) return ShortestForwardCurve(from, to, radius);
  DubinsCurve curve = ShortestForwardCurve(TurnedRound(from), TurnedRound(to), radius);
  curve.reverse = true;
  return curve;
}

DubinsSampler::DubinsSampler(const Pose2& from, const DubinsCurve& curve)
    : curve_(curve), length_(curve.length()) {
  const double heading = curve.reverse ? TurnedRound(from).heading : from.heading;
  Pose2 scaled{from.x / curve.radius, from.y / curve.radius, heading};
  for (int i = 0; i < 3; ++i) {
    starts_[i] = scaled;
    scaled = Advance(scaled, curve.turns[i], curve.lengths[i] / curve.radius);
  }
}

Pose2 DubinsSampler::At(double s) const {
  double left = std::clamp(s, 0.0, length_);
  int piece = 0;
  while (piece < 2 && left > curve_.lengths[piece]) left -= curve_.lengths[piece++];
  Pose2 pose = Advance(starts_[piece], curve_.turns[piece], left / curve_.radius);
  pose.x *= curve_.radius;
  pose.y *= curve_.radius;
  if (curve_.reverse) pose = TurnedRound(pose);
  pose.reverse = curve_.reverse;
  return pose;
}

}  // namespace dbd
