#pragma once

#include <dbd/core/vehicle_model.h>

#include <vector>

namespace dbd {

/// The points of bodies at which links and springs pull, each once: two links that meet in a ball
/// joint share its place, its velocity and the moment of their forces.
class AttachmentPoints {
 public:
  struct Point {
    int body = 0;
    Eigen::Vector3d p_B = Eigen::Vector3d::Zero();
  };
  struct LinkEnds {
    int a = 0;
    int b = 0;
  };
  struct SpringEnds {
    int top = 0;
    int pivot = 0;
    int ball = 0;
  };

  explicit AttachmentPoints(const VehicleModel& model);

  /// Most points that the links and springs of a vehicle can have.
  template <class Model>
  static std::size_t Most(const Model& model) {
    return 2 * model.links.size() + 3 * model.springs.size();
  }

  const std::vector<Point>& points() const { return points_; }  ///< sorted by body
  /// Points of body i: first()[i] up to first()[i + 1].
  const std::vector<std::size_t>& first() const { return first_; }
  const std::vector<LinkEnds>& links() const { return links_; }        ///< like model.links
  const std::vector<SpringEnds>& springs() const { return springs_; }  ///< like model.springs

 private:
  void Collect(const VehicleModel& model);
  int IndexOf(int body, const Eigen::Vector3d& p_B) const;

  std::vector<Point> points_;
  std::vector<std::size_t> first_;
  std::vector<LinkEnds> links_;
  std::vector<SpringEnds> springs_;
};

}  // namespace dbd
