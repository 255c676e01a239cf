#pragma once

#include <dbd/core/ground_grid.h>

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace dbd {

/// A regular grid of ground heights in the local frame W; bilinear between cell centres.
///
/// Row 0 is the south edge and rows grow to the north, so that index and coordinate grow together.
/// Heights are stored as float relative to `base_height`, so that a summit is as exact as a beach;
/// what comes out is the height in W. Unknown cells hold the height of a near known cell and stay
/// marked as unknown. Outside the grid the height of its edge continues. All functions are const,
/// allocate nothing and are safe to call from many threads.
class HeightMap {
 public:
  struct Grid {
    int columns = 0;
    int rows = 0;
    Eigen::Vector2d first_center =
        Eigen::Vector2d::Zero();  ///< W coordinates of the centre of cell (0, 0) [m]
    Eigen::Vector2d cell_size = Eigen::Vector2d::Ones();  ///< [m], both positive

    Eigen::Vector2d Center(int column, int row) const {
      return first_center + cell_size.cwiseProduct(Eigen::Vector2d(column, row));
    }
    std::size_t CellCount() const {
      return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    }
  };

  /// `heights`: rows x columns, row 0 first, relative to `base_height`, not finite = unknown.
  /// Throws InputError when the grid is smaller than 2 x 2 or no cell is known.
  HeightMap(const Grid& grid, std::vector<float> heights, double base_height = 0.0);

  double Height(double x, double y) const;
  void Heights(int count, const double* x, const double* y, double* z) const;

  /// Upper bound of the height within `radius` of a place. One read for radii up to about a cell
  /// or a metre, whichever is more.
  double HighestWithin(double radius, double x, double y) const;

  /// The place is inside and all four cells round it are known.
  bool IsKnown(double x, double y) const;

  /// True where `IsKnown` holds throughout a box, unless it spans too many cells to look at.
  bool IsBoxKnown(const Eigen::Vector2d& low, const Eigen::Vector2d& high) const;

  /// Whether the height of this cell was given.
  bool IsCellKnown(int column, int row) const;
  double CellHeight(int column, int row) const;

  /// The same heights as plain data, valid as long as this map stays where it is.
  GroundGrid View() const;

  const Grid& grid() const { return grid_; }
  Eigen::Vector2d min_corner() const { return grid_.first_center; }
  Eigen::Vector2d max_corner() const { return grid_.Center(grid_.columns - 1, grid_.rows - 1); }
  double unknown_share() const { return unknown_share_; }
  double lowest() const { return lowest_; }    ///< of the known cells [m]
  double highest() const { return highest_; }  ///< of the known cells [m]
  std::size_t memory_bytes() const;

  /// Bytes that a map of this many cells keeps.
  static std::size_t MemoryNeed(std::size_t cells);

 private:
  /// The two neighbours of one row pair, so that the four corners of a place are one read.
  struct RowPair {
    float south;
    float north;
  };

  void MarkKnown(const std::vector<float>& heights);
  void ContinueHeightsIntoUnknown(std::vector<float>* heights) const;
  void StoreRowPairs(const std::vector<float>& heights);
  void BuildHighestTiles(const std::vector<float>& heights);

  Grid grid_;
  double base_height_ = 0;
  double unknown_share_ = 0;
  double lowest_ = 0;
  double highest_ = 0;
  Eigen::Vector2d inverse_cell_size_;
  Eigen::Vector2d last_index_;       // highest index coordinate, columns - 1 and rows - 1
  std::vector<RowPair> row_pairs_;   // (rows - 1) x columns
  std::vector<std::uint8_t> known_;  // rows x columns
  // Highest height in each tile of tile_cells_ x tile_cells_ squares and in its eight neighbours.
  int tile_cells_ = 1;
  int tile_columns_ = 0;
  int tile_rows_ = 0;
  double tile_width_ = 0;  // the smaller side [m]
  std::vector<float> highest_nearby_;
};

}  // namespace dbd
