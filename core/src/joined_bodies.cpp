#include "joined_bodies.h"

#include <set>
#include <tuple>
#include <utility>

namespace dbd {
namespace {

/// Appends the indices of the elements that `belongs` takes; returns where they stand.
template <class Elements, class Belongs>
JoinedBodies::Range Append(const Elements& elements, const Belongs& belongs,
                           std::vector<int>& indices) {
  JoinedBodies::Range range{static_cast<int>(indices.size()), 0};
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (belongs(elements[i])) indices.push_back(static_cast<int>(i));
  }
  range.end = static_cast<int>(indices.size());
  return range;
}

}  // namespace

JoinedBodies::JoinedBodies() = default;
JoinedBodies::~JoinedBodies() = default;
JoinedBodies::JoinedBodies(const JoinedBodies& other) = default;
JoinedBodies::JoinedBodies(JoinedBodies&& other) noexcept = default;

JoinedBodiesMaker::JoinedBodiesMaker() = default;
JoinedBodiesMaker::~JoinedBodiesMaker() = default;

void JoinedBodiesMaker::AddLink(int body_a, int body_b, int point) {
  links_.push_back({body_a, body_b, point});
}
void JoinedBodiesMaker::AddSpring(int body_a, int body_b, int point) {
  springs_.push_back({body_a, body_b, point});
}
void JoinedBodiesMaker::AddJoint(int body_a, int body_b) {
  joints_.push_back({body_a, body_b, -1});
}

JoinedBodies JoinedBodiesMaker::Make() const {
  std::set<std::pair<int, int>> joined;
  std::set<std::tuple<int, int, int>> points;
  for (const auto* elements : {&links_, &springs_, &joints_}) {
    for (const Element& e : *elements) joined.insert({e.body_a, e.body_b});
  }
  for (const auto* elements : {&links_, &springs_}) {
    for (const Element& e : *elements) points.insert({e.body_a, e.body_b, e.point});
  }
  JoinedBodies made;
  for (const auto& [a, b] : joined) {
    const auto joins = [&](const Element& e) { return e.body_a == a && e.body_b == b; };
    JoinedBodies::Pair pair{a, b, {static_cast<int>(made.balls.size()), 0}, {}};
    for (auto it = points.lower_bound({a, b, -1});
         it != points.end() && std::get<0>(*it) == a && std::get<1>(*it) == b; ++it) {
      const auto pulls = [&](const Element& e) { return joins(e) && e.point == std::get<2>(*it); };
      JoinedBodies::Ball ball;
      ball.links = Append(links_, pulls, made.links);
      ball.springs = Append(springs_, pulls, made.springs);
      if (ball.links.begin < ball.links.end) ball.of_link = made.links.back();
      if (ball.of_link < 0) ball.of_spring = made.springs.back();
      made.balls.push_back(ball);
    }
    pair.balls.end = static_cast<int>(made.balls.size());
    pair.joints = Append(joints_, joins, made.joints);
    made.pairs.push_back(pair);
  }
  return made;
}

}  // namespace dbd
