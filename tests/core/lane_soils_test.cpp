#include "lane_soils.h"

#include <gtest/gtest.h>

#include <vector>

namespace dbd {
namespace {

using Lanes = Pack<float, 4>;

SoilSample Soil(double cone_index, TractionModel model = TractionModel::kBrixius) {
  SoilSample soil;
  soil.cone_index = cone_index;
  soil.friction_limit = 1e-6 * cone_index;
  soil.traction_model = model;
  return soil;
}

TEST(LaneSoils, OneSoilIsEverywhere) {
  const SoilSample soil = Soil(400e3, TractionModel::kWismerLuth);
  GroundSoils ground;
  ground.soils = &soil;
  ground.count = 1;
  const LaneSoils<Lanes> lanes(ground);
  ASSERT_TRUE(lanes.plain());
  const double x[4] = {-1e6, 0, 1, 1e6}, y[4] = {0, 5, -3, 1e6};
  const PlainSoils<Lanes> here = lanes.At(x, y);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(here.cone_index.v[i], 400e3F);
    EXPECT_EQ(here.friction_limit.v[i], 0.4F);
    EXPECT_EQ(here.traction_model.v[i], 1);
  }
}

TEST(LaneSoils, EachLaneReadsTheClassUnderIt) {
  const std::vector<SoilSample> soils = {Soil(100e3), Soil(200e3), Soil(300e3), Soil(50e3)};
  const std::vector<std::uint8_t> classes = {0, 1, 2,   // south
                                             2, 0, 1};  // north
  GroundSoils ground;
  ground.soils = soils.data();
  ground.count = 4;
  ground.classes = classes.data();
  ground.grid = {3, 2, 11, -3.5, 0.5, 1};  // from (10, -4), cells of 2 m x 1 m
  ground.outside = 3;
  const LaneSoils<Lanes> lanes(ground);
  const double x[4] = {10.1, 15.9, 12.5, 16.1}, y[4] = {-3.9, -3.5, -2.1, -3.5};
  const PlainSoils<Lanes> here = lanes.At(x, y);
  const float want[4] = {100e3F, 300e3F, 100e3F, 50e3F};
  for (int i = 0; i < 4; ++i) EXPECT_EQ(here.cone_index.v[i], want[i]) << i;
}

TEST(LaneSoils, PlateConstantsAreNotForLanes) {
  const SoilSample soil = Soil(400e3, TractionModel::kBekker);
  GroundSoils ground;
  ground.soils = &soil;
  ground.count = 1;
  EXPECT_FALSE(LaneSoils<Lanes>(ground).plain());
}

}  // namespace
}  // namespace dbd
