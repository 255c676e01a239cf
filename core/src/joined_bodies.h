#pragma once

#include <cstddef>
#include <vector>

namespace dbd {

/// Which bodies are joined by links, springs and joints, and by which: the order in which forces
/// between bodies are evaluated. Elements that join the same two bodies lie together, so that the
/// motion of one as the other sees it is computed once, and those that pull at the same point of
/// body b as well.
struct JoinedBodies {
  /// Half-open.
  struct Range {
    int begin = 0;
    int end = 0;
  };
  /// A point of body b at which links and springs pull, given by the first of them.
  struct Ball {
    int of_link = -1;
    int of_spring = -1;  ///< where no link pulls
    Range links, springs;
  };
  struct Pair {
    int body_a = 0;
    int body_b = 0;
    Range balls, joints;
  };

  // In a translation unit for any processor, as those for wide instructions use them.
  JoinedBodies();
  ~JoinedBodies();
  JoinedBodies(const JoinedBodies& other);
  JoinedBodies(JoinedBodies&& other) noexcept;

  std::vector<Pair> pairs;
  std::vector<Ball> balls;
  std::vector<int> links, springs, joints;  ///< indices into the model's lists
};

/// Takes a model's elements in any order.
class JoinedBodiesMaker {
 public:
  JoinedBodiesMaker();
  ~JoinedBodiesMaker();

  /// `point`: a number that those at the same point of body b share.
  void AddLink(int body_a, int body_b, int point);
  void AddSpring(int body_a, int body_b, int point);
  void AddJoint(int body_a, int body_b);
  JoinedBodies Make() const;

 private:
  struct Element {
    int body_a, body_b, point;
  };

  std::vector<Element> links_, springs_, joints_;
};

/// `same(p, q)` compares points of bodies.
template <class Model, class Same>
JoinedBodies FindJoinedBodies(const Model& model, const Same& same) {
  JoinedBodiesMaker maker;
  const int link_count = static_cast<int>(model.links.size());
  const auto point_of = [&](const auto& element, int otherwise) {
    for (int i = 0; i < link_count; ++i) {
      const auto& link = model.links[static_cast<std::size_t>(i)];
      if (link.body_b == element.body_b && same(link.p_B, element.p_B)) return i;
    }
    return otherwise;
  };
  for (const auto& link : model.links) maker.AddLink(link.body_a, link.body_b, point_of(link, -1));
  for (std::size_t i = 0; i < model.springs.size(); ++i) {
    const auto& spring = model.springs[i];
    maker.AddSpring(spring.body_a, spring.body_b,
                    point_of(spring, link_count + static_cast<int>(i)));
  }
  for (const auto& joint : model.joints) maker.AddJoint(joint.body_a, joint.body_b);
  return maker.Make();
}

}  // namespace dbd
