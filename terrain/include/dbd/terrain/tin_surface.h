#pragma once

#include <dbd/core/ground_facets.h>

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <vector>

namespace dbd {

/// A triangulated surface in W that wheels drive on. Where sheets lie over each other (bridges,
/// tree crowns in a scan) the lowest counts. Triangles are found through a grid of bins about as
/// large as the triangles, so that a query's cost does not depend on their number. All functions
/// are const, allocate nothing and are safe to call from many threads.
class TinSurface {
 public:
  /// What is odd about the triangles.
  struct Report {
    std::size_t triangles = 0;       ///< that are driven on
    std::size_t vertical = 0;        ///< left out: without an area seen from above
    std::size_t boundary_edges = 0;  ///< edges of one triangle only: the outline and holes' rims
    std::size_t holes = 0;           ///< closed rims besides the longest
    double overlap_share = 0;        ///< of sampled places on it, with more than one sheet [-]
  };

  using Triangle = std::array<std::uint32_t, 3>;

  /// `vertices` in W [m]; `triangles`: indices into it. Throws InputError when no triangle has an
  /// area seen from above.
  TinSurface(std::vector<Eigen::Vector3d> vertices, std::vector<Triangle> triangles);

  /// Height of the lowest sheet [m]; false when the place lies on no triangle.
  bool FindHeight(double x, double y, double* z) const;

  /// Upper bound of the surface's height within `radius` of a place [m]; minus infinity where no
  /// triangle is near. One read for radii up to about the spacing of the vertices.
  double HighestWithin(double radius, double x, double y) const;

  /// Valid as long as the surface.
  GroundFacets View() const;

  Eigen::Vector2d min_corner() const { return low_; }
  Eigen::Vector2d max_corner() const { return high_; }
  /// Typical distance of neighbouring vertices [m].
  double spacing() const { return spacing_; }
  const Report& report() const { return report_; }
  std::size_t memory_bytes() const;

 private:
  void Measure(const std::vector<Eigen::Vector3d>& vertices,
               const std::vector<Triangle>& triangles);
  /// The triangles of each bin, one bin after the other; `bin_begin_` says where each begins.
  std::vector<std::uint32_t> MakeBins(const std::vector<Eigen::Vector3d>& vertices,
                                      const std::vector<Triangle>& triangles);
  void FindHighest(const std::vector<Eigen::Vector3d>& vertices,
                   const std::vector<Triangle>& triangles,
                   const std::vector<std::uint32_t>& in_bins);
  void FillBins(const std::vector<Eigen::Vector3d>& vertices,
                const std::vector<Triangle>& triangles, const std::vector<std::uint32_t>& in_bins);
  void FindRims(const std::vector<Eigen::Vector3d>& vertices,
                const std::vector<Triangle>& triangles);
  /// Calls visit(index) for every bin that the rectangle around these places touches.
  template <class Visit>
  void VisitBins(std::initializer_list<Eigen::Vector3d> places, const Visit& visit) const;
  void SampleOverlaps();
  /// Calls visit(height above the base) for every facet within `seam` of a place on the extent.
  template <class Visit>
  void VisitHeights(double x, double y, float seam, const Visit& visit) const;
  int CountSheets(double x, double y) const;

  Eigen::Vector2d low_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d high_ = Eigen::Vector2d::Zero();
  double base_height_ = 0;
  double spacing_ = 1;
  double bin_size_ = 1;
  int bin_columns_ = 0;
  int bin_rows_ = 0;
  std::vector<std::uint32_t> bin_begin_;  // bins + 1, into bin_facets_
  std::vector<GroundFacet> bin_facets_;   // copies, so that a bin is read as one piece
  std::vector<std::uint8_t> bin_has_rim_;
  std::vector<float> highest_nearby_;  // of a bin and its eight neighbours, above base_height_
  Report report_;
};

}  // namespace dbd
