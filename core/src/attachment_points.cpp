#include "attachment_points.h"

#include <algorithm>

namespace dbd {

AttachmentPoints::AttachmentPoints(const VehicleModel& model) {
  Collect(model);
  for (const LinkModel& link : model.links) {
    links_.push_back({IndexOf(link.body_a, link.p_A), IndexOf(link.body_b, link.p_B)});
  }
  for (const SpringModel& spring : model.springs) {
    springs_.push_back({IndexOf(spring.body_a, spring.p_A), IndexOf(spring.body_a, spring.p_Q),
                        IndexOf(spring.body_b, spring.p_B)});
  }
}

void AttachmentPoints::Collect(const VehicleModel& model) {
  const auto add = [this](int body, const Eigen::Vector3d& p_B) {
    if (IndexOf(body, p_B) < 0) points_.push_back({body, p_B});
  };
  for (const LinkModel& link : model.links) {
    add(link.body_a, link.p_A);
    add(link.body_b, link.p_B);
  }
  for (const SpringModel& spring : model.springs) {
    add(spring.body_a, spring.p_A);
    add(spring.body_a, spring.p_Q);
    add(spring.body_b, spring.p_B);
  }
  std::stable_sort(points_.begin(), points_.end(),
                   [](const Point& a, const Point& b) { return a.body < b.body; });
  for (int body = 0; body <= static_cast<int>(model.bodies.size()); ++body) {
    const auto begins = std::partition_point(points_.begin(), points_.end(),
                                             [&](const Point& p) { return p.body < body; });
    first_.push_back(static_cast<std::size_t>(begins - points_.begin()));
  }
}

int AttachmentPoints::IndexOf(int body, const Eigen::Vector3d& p_B) const {
  const auto same = [&](const Point& p) { return p.body == body && p.p_B == p_B; };
  const auto found = std::find_if(points_.begin(), points_.end(), same);
  return found == points_.end() ? -1 : static_cast<int>(found - points_.begin());
}

}  // namespace dbd
