#include <dbd/terrain/material_map.h>
#include <gtest/gtest.h>

namespace dbd {
namespace {

MaterialTable MakeTable() {
  Material firm;
  firm.code = 1;
  firm.name = "firm";
  firm.soil.cone_index = 1.8e6;
  Material soft = firm;
  soft.code = 2;
  soft.name = "soft";
  soft.soil.cone_index = 0.4e6;
  Material water = firm;
  water.code = 3;
  water.name = "water";
  water.soil.cone_index = 0.05e6;
  water.passable = false;
  return MaterialTable("test", {firm, soft, water});
}

// Cells of 2 m with centres at 0, 2, 4 in x and 0, 2 in y.
MaterialMap MakeMap() {
  return MaterialMap(MakeTable(), {3, 2, {0, 0}, {2, 2}}, {0, 1, 2, MaterialMap::kNone, 1, 0});
}

TEST(MaterialMap, TakesTheNearestCell) {
  const MaterialMap map = MakeMap();
  EXPECT_EQ(map.At(0.9, 0.9)->name, "firm");
  EXPECT_EQ(map.At(1.1, 0.9)->name, "soft");
  EXPECT_EQ(map.At(4.9, -0.9)->name, "water");
  EXPECT_EQ(map.At(4.0, 1.1)->name, "firm");
}

TEST(MaterialMap, KnowsNothingOutsideOrWithoutClass) {
  const MaterialMap map = MakeMap();
  EXPECT_EQ(map.At(0, 2), nullptr);
  EXPECT_EQ(map.At(-1.1, 0), nullptr);
  EXPECT_EQ(map.At(5.1, 0), nullptr);
  EXPECT_EQ(map.At(1e300, 0), nullptr);
}

TEST(MaterialMap, GivesTheSoftestPassableSoilWhereItIsUnknown) {
  const MaterialMap map = MakeMap();
  const double x[] = {0, 0, 100, 4};
  const double y[] = {0, 2, 0, 0};
  SoilSample soil[4];
  map.Soils(4, x, y, soil);
  EXPECT_DOUBLE_EQ(soil[0].cone_index, 1.8e6);
  EXPECT_DOUBLE_EQ(soil[1].cone_index, 0.4e6);
  EXPECT_DOUBLE_EQ(soil[2].cone_index, 0.4e6);
  EXPECT_DOUBLE_EQ(soil[3].cone_index, 0.05e6);
}

TEST(MaterialMap, CountsShares) {
  const MaterialMap map = MakeMap();
  EXPECT_DOUBLE_EQ(map.Share(0), 2.0 / 6);
  EXPECT_DOUBLE_EQ(map.Share(MaterialMap::kNone), 1.0 / 6);
}

TEST(MaterialMap, MayBeTheSameEverywhere) {
  const MaterialMap map(*MakeTable().FindName("soft"));
  EXPECT_TRUE(map.is_uniform());
  EXPECT_EQ(map.At(1e6, -1e6)->name, "soft");
  const double place = 5;
  SoilSample soil;
  map.Soils(1, &place, &place, &soil);
  EXPECT_DOUBLE_EQ(soil.cone_index, 0.4e6);
}

TEST(MaterialMap, ItsViewSaysTheSame) {
  const MaterialMap map = MakeMap();
  const GroundSoils view = map.View();
  for (double x = -5; x < 12; x += 0.37) {
    for (double y = -5; y < 9; y += 0.41) {
      SoilSample soil;
      map.Soils(1, &x, &y, &soil);
      const std::ptrdiff_t cell = view.grid.CellAt(x, y);
      const std::uint8_t index = cell < 0 ? view.outside : view.classes[cell];
      ASSERT_EQ(view.soils[index].cone_index, soil.cone_index) << x << " " << y;
    }
  }
}

}  // namespace
}  // namespace dbd
