#include "lane_grid.h"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace dbd {
namespace {

/// 6 x 5 cells of 0.5 m x 0.25 m with heights that no two cells share.
class LaneGridOf : public ::testing::Test {
 protected:
  LaneGridOf() {
    grid.columns = 6;
    grid.rows = 5;
    grid.x0 = 100;
    grid.y0 = -20;
    grid.cell_x = 0.5;
    grid.cell_y = 0.25;
    grid.base_height = 50;
    for (int row = 0; row + 1 < grid.rows; ++row) {
      for (int column = 0; column < grid.columns; ++column) {
        pairs.push_back(Node(column, row));
        pairs.push_back(Node(column, row + 1));
      }
    }
    grid.row_pairs = pairs.data();
    grid.tile_cells = 2;
    grid.tile_columns = 3;
    grid.tile_width = 0.5;
    highest = {1, 2, 3, 4, 5, 6};
    grid.highest_nearby = highest.data();
  }

  static float Node(int column, int row) {
    return static_cast<float>(0.1 * column * column + 0.07 * row * column - 0.03 * row);
  }

  /// Bilinear, on paper: node below, share of the way to the next.
  double Expected(double x, double y) const {
    const double u = std::clamp((x - grid.x0) / grid.cell_x, 0.0, grid.columns - 1.0);
    const double v = std::clamp((y - grid.y0) / grid.cell_y, 0.0, grid.rows - 1.0);
    const int i = std::min(static_cast<int>(u), grid.columns - 2);
    const int j = std::min(static_cast<int>(v), grid.rows - 2);
    const double s = u - i, t = v - j;
    return grid.base_height + (1 - t) * ((1 - s) * Node(i, j) + s * Node(i + 1, j)) +
           t * ((1 - s) * Node(i, j + 1) + s * Node(i + 1, j + 1));
  }

  GroundGrid grid;
  std::vector<float> pairs, highest;
};

/// Every lane with an origin of its own, over the grid and beyond each of its edges.
template <class P>
void ExpectHeights(const GroundGrid& grid, double tolerance,
                   const std::function<double(double, double)>& expected) {
  constexpr int kLanes = LaneTraits<P>::kLanes;
  using S = ScalarOf<P>;
  LaneGrid<P> lanes;
  for (int k = 0; k < 400; ++k) {
    P x, y;
    double wx[kLanes], wy[kLanes], oz[kLanes];
    for (int lane = 0; lane < kLanes; ++lane) {
      const int n = k * kLanes + lane;
      wx[lane] = 99 + 5.0 * ((n * 37) % 101) / 101;
      wy[lane] = -20.5 + 2.5 * ((n * 53) % 97) / 97;
      const Eigen::Vector3d origin(96 + 8 * (n % 2), -24 + 8 * (n % 3 == 0), 48);
      lanes.SetOrigin(grid, lane, origin);
      x.v[lane] = static_cast<S>(wx[lane] - origin.x());
      y.v[lane] = static_cast<S>(wy[lane] - origin.y());
      oz[lane] = origin.z();
    }
    const P z = lanes.Height(grid, x, y);
    for (int lane = 0; lane < kLanes; ++lane) {
      EXPECT_NEAR(z.v[lane] + oz[lane], expected(wx[lane], wy[lane]), tolerance)
          << wx[lane] << " " << wy[lane];
    }
  }
}

TEST_F(LaneGridOf, HeightsAreBilinearAndTheEdgeGoesOn) {
  const auto expected = [this](double x, double y) { return Expected(x, y); };
  ExpectHeights<Pack<float, 4>>(grid, 1e-5, expected);
  ExpectHeights<Pack<float, 8>>(grid, 1e-5, expected);
  ExpectHeights<Pack<float, 16>>(grid, 1e-5, expected);
  ExpectHeights<Pack<double, 8>>(grid, 1e-6, expected);  // nodes are floats
}

/// Lanes all over the grid and beyond its edges, points up to half a cell to each side of the
/// lanes' places.
template <class S>
constexpr double kRoundOff = sizeof(S) == 4 ? 2e-6 : 1e-12;

template <class P>
void ExpectPatches(const GroundGrid& grid) {
  constexpr int kLanes = LaneTraits<P>::kLanes;
  using S = ScalarOf<P>;
  LaneGrid<P> lanes;
  for (int lane = 0; lane < kLanes; ++lane) lanes.SetOrigin(grid, lane, {96, -24, 48});
  for (int k = 0; k < 200; ++k) {
    P x, y, px, py;
    for (int lane = 0; lane < kLanes; ++lane) {
      const int n = k * kLanes + lane;
      const double u = -2 + 9.0 * ((n * 37) % 101) / 101, v = -2 + 8.0 * ((n * 53) % 97) / 97;
      x.v[lane] = static_cast<S>(grid.x0 + u * grid.cell_x - 96);
      y.v[lane] = static_cast<S>(grid.y0 + v * grid.cell_y + 24);
      px.v[lane] =
          x.v[lane] + static_cast<S>(0.49 * grid.cell_x * (2.0 * ((n * 29) % 89) / 89 - 1));
      py.v[lane] =
          y.v[lane] + static_cast<S>(0.49 * grid.cell_y * (2.0 * ((n * 31) % 83) / 83 - 1));
    }
    const LanePatch<P> patch = lanes.Patch(grid, lanes.NearestColumn(x), lanes.NearestRow(y));
    P z;
    patch.Heights(1, &px, &py, &z);
    const P expected = lanes.Height(grid, px, py);
    const GroundPlane<P> plane = patch.Plane(x, y);
    for (int lane = 0; lane < kLanes; ++lane) {
      ASSERT_NEAR(z.v[lane], expected.v[lane], kRoundOff<S>) << k << " lane " << lane;
      const S bound = plane.height.v[lane] + (px.v[lane] - x.v[lane]) * plane.slope_x.v[lane] +
                      (py.v[lane] - y.v[lane]) * plane.slope_y.v[lane];
      EXPECT_GE(bound, z.v[lane] - S(1e-5));
    }
  }
}

TEST_F(LaneGridOf, PatchesGiveTheSameHeightsAlsoBeyondTheEdge) {
  ExpectPatches<Pack<float, 4>>(grid);
  ExpectPatches<Pack<float, 16>>(grid);
  ExpectPatches<Pack<double, 4>>(grid);
}

TEST_F(LaneGridOf, NoPatchWhereCellsAreSmall) {
  using P = Pack<float, 4>;
  EXPECT_TRUE(LaneGrid<P>::CellsHold(grid, 0.12));  // cells are 0.25 m wide in y
  EXPECT_FALSE(LaneGrid<P>::CellsHold(grid, 0.125));
}

TEST_F(LaneGridOf, HighestComesFromTheTileUnderThePlace) {
  using P = Pack<float, 4>;
  LaneGrid<P> lanes;
  const Eigen::Vector3d origin(96, -24, 0);
  for (int lane = 0; lane < 4; ++lane) lanes.SetOrigin(grid, lane, origin);
  // Tiles of two cells: 1 m x 0.5 m; columns 0..2, rows 0..1.
  P x, y;
  const double places[4][2] = {{100.2, -19.9}, {101.1, -19.6}, {102.3, -19.3}, {90, -30}};
  const float want[4] = {1, 2, 6, 1};
  for (int lane = 0; lane < 4; ++lane) {
    x.v[lane] = static_cast<float>(places[lane][0] - origin.x());
    y.v[lane] = static_cast<float>(places[lane][1] - origin.y());
  }
  const P z = lanes.HighestNearby(grid, x, y);
  for (int lane = 0; lane < 4; ++lane) EXPECT_EQ(z.v[lane], 50 + want[lane]);
}

}  // namespace
}  // namespace dbd
