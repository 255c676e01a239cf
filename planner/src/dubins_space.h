#pragma once

#include <dbd/planner/dubins.h>
#include <ompl/base/spaces/DubinsStateSpace.h>

#include <array>
#include <vector>

namespace dbd {

/// OMPL's Dubins space with our curves: OMPL 1.5's own solver stops the program by an assertion
/// about once in three million distances. For one thread: it remembers distances.
class DubinsSpace final : public ompl::base::DubinsStateSpace {
 public:
  DubinsSpace(double turning_radius, const Eigen::Vector2d& min_corner,
              const Eigen::Vector2d& max_corner);

  DubinsCurve Curve(const ompl::base::State* from, const ompl::base::State* to) const;

  double distance(const ompl::base::State* from, const ompl::base::State* to) const override;
  void interpolate(const ompl::base::State* from, const ompl::base::State* to, double t,
                   ompl::base::State* state) const override;
  /// Does not use `first_time` and `path`, which belong to OMPL's solver.
  void interpolate(const ompl::base::State* from, const ompl::base::State* to, double t,
                   bool& first_time, DubinsPath& path, ompl::base::State* state) const override;

 private:
  struct KnownDistance {
    std::array<double, 6> ends{};  // from, to; all zero has length 0, too
    double length = 0;
  };

  // OMPL's search for neighbours sorts by distance and asks for each one about ten times.
  mutable std::vector<KnownDistance> known_;
  mutable DirectedPose last_from_, last_to_;
};

}  // namespace dbd
