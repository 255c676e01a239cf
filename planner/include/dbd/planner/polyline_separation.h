#pragma once

#include <Eigen/Core>
#include <vector>

namespace dbd {

/// Points of a polyline about every `spacing` [m], its ends included.
std::vector<Eigen::Vector2d> Thin(const std::vector<Eigen::Vector2d>& points, double spacing);

/// How different two routes are [m]: the larger of the two means, over the points of the one, of
/// the distance to the nearest point of the other's polyline. Zero only for the same trace;
/// symmetric. Cost is the product of the numbers of points.
double Separation(const std::vector<Eigen::Vector2d>& a, const std::vector<Eigen::Vector2d>& b);

/// The smaller of both numbers: `bound` and the separation, which is not worked out any further
/// once it is seen to be `bound` or more.
double SeparationUpTo(double bound, const std::vector<Eigen::Vector2d>& a,
                      const std::vector<Eigen::Vector2d>& b);

/// Of each polyline from the nearest other [m]; infinite for one that is alone.
std::vector<double> NearestSeparations(const std::vector<std::vector<Eigen::Vector2d>>& lines);

/// Distance from a point to the nearest point of a polyline [m].
double DistanceToPolyline(const Eigen::Vector2d& point,
                          const std::vector<Eigen::Vector2d>& polyline);

}  // namespace dbd
