#pragma once

#include <dbd/planner/dubins.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

namespace dbd {

/// Finds poses by place: square buckets as wide as the usual search radius.
class NeighbourGrid {
 public:
  /// `poses` must outlive the grid and not be empty.
  NeighbourGrid(const std::vector<Pose2>& poses, double bucket) : poses_(poses), bucket_(bucket) {
    Eigen::Vector2d max = poses.front().position();
    min_ = max;
    for (const Pose2& pose : poses) {
      min_ = min_.cwiseMin(pose.position());
      max = max.cwiseMax(pose.position());
    }
    columns_ = static_cast<int>((max.x() - min_.x()) / bucket) + 1;
    rows_ = static_cast<int>((max.y() - min_.y()) / bucket) + 1;
    buckets_.resize(static_cast<std::size_t>(columns_) * rows_);
    for (std::size_t i = 0; i < poses.size(); ++i) {
      const int column = Bucket(poses[i].x - min_.x(), columns_);
      const int row = Bucket(poses[i].y - min_.y(), rows_);
      buckets_[static_cast<std::size_t>(row) * columns_ + column].push_back(static_cast<int>(i));
    }
  }

  /// Indices of the poses within `radius` of a place, in ascending order.
  std::vector<int> Within(const Eigen::Vector2d& place, double radius) const {
    std::vector<int> found;
    const Eigen::Vector2d offset = place - min_;
    for (int row = Bucket(offset.y() - radius, rows_); row <= Bucket(offset.y() + radius, rows_);
         ++row) {
      for (int column = Bucket(offset.x() - radius, columns_);
           column <= Bucket(offset.x() + radius, columns_); ++column) {
        for (const int i : buckets_[static_cast<std::size_t>(row) * columns_ + column]) {
          if ((poses_[i].position() - place).norm() <= radius) found.push_back(i);
        }
      }
    }
    std::sort(found.begin(), found.end());
    return found;
  }

 private:
  int Bucket(double offset, int count) const {
    return std::clamp(static_cast<int>(std::floor(offset / bucket_)), 0, count - 1);
  }

  const std::vector<Pose2>& poses_;
  double bucket_;
  Eigen::Vector2d min_;
  int columns_ = 1;
  int rows_ = 1;
  std::vector<std::vector<int>> buckets_;
};

}  // namespace dbd
