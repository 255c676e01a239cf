#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace dbd {

/// A regular grid of ground heights in the local frame W; bilinear between cell centres.
///
/// Row 0 is the south edge and rows grow to the north, so that index and coordinate grow together.
/// Heights are stored as float relative to `base_height`; nodata cells hold a continued height and
/// are marked unknown.
class HeightMap {
 public:
  struct Grid {
    int columns = 0;
    int rows = 0;
    Eigen::Vector2d first_center;  ///< W coordinates of the centre of cell (0, 0) [m]
    Eigen::Vector2d cell_size;     ///< [m], both positive
  };

  /// `heights`: rows x columns, row 0 first, NaN = unknown. Throws InputError when the grid is
  /// smaller than 2 x 2 or no cell is known.
  HeightMap(const Grid& grid, const std::vector<float>& heights, double base_height = 0.0);

  double Height(double x, double y) const;
  void Heights(int count, const double* x, const double* y, double* z) const;

  /// Upper bound of the height within `radius` of a place.
  double HighestWithin(double radius, double x, double y) const;

  /// All cells that the bilinear height at this place depends on are known.
  bool IsKnown(double x, double y) const;

  const Grid& grid() const { return grid_; }
  Eigen::Vector2d min_corner() const { return grid_.first_center; }
  Eigen::Vector2d max_corner() const;
  double unknown_share() const { return unknown_share_; }
  double lowest() const { return lowest_; }
  double highest() const { return highest_; }
  std::size_t memory_bytes() const;

 private:
  void ContinueHeightsIntoUnknown();
  void BuildMaximumTiles();

  Grid grid_;
  double base_height_ = 0;
  double unknown_share_ = 0;
  double lowest_ = 0;
  double highest_ = 0;
  Eigen::Vector2d inverse_cell_size_;
  std::vector<float> heights_;
  std::vector<std::uint8_t> known_;
  // Tiles of kTileCells x kTileCells cells with the highest height in the tile.
  int tile_columns_ = 0;
  int tile_rows_ = 0;
  std::vector<float> tile_highest_;
};

}  // namespace dbd
