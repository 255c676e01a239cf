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
DirectedPose Advance(const DirectedPose& from, Turn turn, double length) {
  if (turn == Turn::kStraight) {
    DirectedPose to = from;
    to.x += length * from.cos_h;
    to.y += length * from.sin_h;
    return to;
  }
  const double sign = static_cast<double>(turn);
  DirectedPose to({from.x, from.y, from.heading + sign * length});
  to.x += sign * (to.sin_h - from.sin_h);
  to.y -= sign * (to.cos_h - from.cos_h);
  return to;
}

using Word = std::array<Turn, 3>;
using Lengths = std::array<double, 3>;

// From (0, 0, a) to (x, y, b) with unit radius.
struct Problem {
  Problem(const DirectedPose& from, const DirectedPose& to, double radius)
      : a(from.heading),
        b(to.heading),
        x((to.x - from.x) / radius),
        y((to.y - from.y) / radius),
        sa(from.sin_h),
        ca(from.cos_h),
        sb(to.sin_h),
        cb(to.cos_h),
        left_turn(PositiveAngle(b - a)) {}

  // The shortest word is in `word` and `best` afterwards. Words go by what they take at least: the
  // line, and turns that make up for the change of heading. That needs no angle, and most words
  // are longer than the first.
  void Solve() {
    std::array<Line, 4> lines{SameTurns(Turn::kLeft), SameTurns(Turn::kRight),
                              OppositeTurns(Turn::kLeft), OppositeTurns(Turn::kRight)};
    std::sort(lines.begin(), lines.end(),
              [](const Line& p, const Line& q) { return p.at_least < q.at_least; });
    for (const Line& line : lines) {
      if (line.at_least < shortest) Try(line);
    }
    if (shortest <= std::numbers::pi) return;  // what the middle one of three turns takes at least
    TryThreeTurns(Turn::kLeft);
    TryThreeTurns(Turn::kRight);
  }

  double a, b, x, y, sa, ca, sb, cb;
  double left_turn;  // to the left, from heading to heading
  Word word{Turn::kLeft, Turn::kStraight, Turn::kLeft};
  Lengths best{};
  double shortest = std::numeric_limits<double>::infinity();

 private:
  // A line between two circles.
  struct Line {
    Turn first, last;
    double dx, dy;  // of the circles' centres
    double length;
    double at_least;  // of the whole curve
  };

  Line SameTurns(Turn turn) const {
    const double sign = static_cast<double>(turn);
    const double dx = x + sign * (sa - sb);
    const double dy = y + sign * (cb - ca);
    const double length = std::sqrt(dx * dx + dy * dy);
    const double turned = turn == Turn::kLeft ? left_turn : kFullTurn - left_turn;
    const bool may_be_none = turned > kFullTurn - 3 * kNearlyFull;
    return {turn, turn, dx, dy, length, may_be_none ? length : length + turned};
  }

  Line OppositeTurns(Turn first) const {
    const double sign = static_cast<double>(first);
    const double dx = x + sign * (sa + sb);
    const double dy = y - sign * (ca + cb);
    const double squared = dx * dx + dy * dy - 4.0;
    const Turn last = Mirror(first);
    constexpr double kNone = std::numeric_limits<double>::infinity();
    if (squared < -1e-12) return {first, last, dx, dy, 0, kNone};
    const double length = std::sqrt(std::max(squared, 0.0));
    const double turned = std::min(left_turn, kFullTurn - left_turn);
    return {first, last, dx, dy, length, length + std::max(0.0, turned - 3 * kNearlyFull)};
  }

  void Try(const Line& line) {
    const double sign = static_cast<double>(line.first);
    if (line.first != line.last) {
      const double tilt = 2 * sign;
      const double theta = std::atan2(line.dy * line.length + line.dx * tilt,
                                      line.dx * line.length - line.dy * tilt);
      Offer({line.first, Turn::kStraight, line.last},
            {PositiveAngle(sign * (theta - a)), line.length, PositiveAngle(sign * (theta - b))});
      return;
    }
    const double theta = std::atan2(line.dy, line.dx);
    const Word same{line.first, Turn::kStraight, line.first};
    Offer(same,
          {PositiveAngle(sign * (theta - a)), line.length, PositiveAngle(sign * (b - theta))});
    // The direction of a line of no length is noise, and so is the split between the turns.
    if (line.length < kEndTolerance) OfferIfMet(same, {PositiveAngle(sign * (b - a)), 0, 0});
  }

  void TryThreeTurns(Turn first) {
    const Line line = SameTurns(first);
    const double sign = static_cast<double>(first);
    const double cosine = 1.0 - (line.dx * line.dx + line.dy * line.dy) / 8.0;
    if (cosine < -1.0) return;
    const double middle = kFullTurn - std::acos(std::min(cosine, 1.0));
    if (middle >= shortest) return;
    const double theta = std::atan2(line.dy, line.dx);
    const double t = PositiveAngle(sign * (theta - a) + 0.5 * middle);
    Offer({first, Mirror(first), first}, {t, middle, PositiveAngle(sign * (b - a) - t + middle)});
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
    return PositiveAngle(static_cast<double>(candidate[piece]) * (b - a - turned));
  }

  void OfferIfMet(const Word& candidate, const Lengths& lengths) {
    if (lengths[0] + lengths[1] + lengths[2] >= shortest) return;
    DirectedPose end({0.0, 0.0, a});
    for (int i = 0; i < 3; ++i) end = Advance(end, candidate[i], lengths[i]);
    const double miss = std::hypot(end.x - x, end.y - y) + std::abs(WrapAngle(end.heading - b));
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

DubinsCurve ShortestForwardCurve(const DirectedPose& from, const DirectedPose& to, double radius) {
  Problem problem(from, to, radius);
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
  return ShortestDubinsCurve(DirectedPose(from), DirectedPose(to), radius);
}

DubinsCurve ShortestDubinsCurve(const DirectedPose& from, const DirectedPose& to, double radius) {
  if (!to.reverse) return ShortestForwardCurve(from, to, radius);
  DubinsCurve curve =
      ShortestForwardCurve(DirectedPose(TurnedRound(from)), DirectedPose(TurnedRound(to)), radius);
  curve.reverse = true;
  return curve;
}

DubinsSampler::DubinsSampler(const Pose2& from, const DubinsCurve& curve)
    : curve_(curve), length_(curve.length()) {
  const double heading = curve.reverse ? TurnedRound(from).heading : from.heading;
  starts_[0] = DirectedPose({from.x / curve.radius, from.y / curve.radius, heading});
  for (std::size_t i = 1; i < starts_.size(); ++i) {
    starts_[i] = Advance(starts_[i - 1], curve.turns[i - 1], curve.lengths[i - 1] / curve.radius);
  }
}

DirectedPose DubinsSampler::At(double s) const {
  double left = std::clamp(s, 0.0, length_);
  int piece = 0;
  while (piece < 2 && left > curve_.lengths[piece]) left -= curve_.lengths[piece++];
  DirectedPose pose = Advance(starts_[piece], curve_.turns[piece], left / curve_.radius);
  pose.x *= curve_.radius;
  pose.y *= curve_.radius;
  if (curve_.reverse) pose = DirectedPose(TurnedRound(pose));
  pose.reverse = curve_.reverse;
  return pose;
}

}  // namespace dbd
