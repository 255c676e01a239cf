#include <dbd/terrain/material_map.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/terrain_files.h"

namespace dbd {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(MaterialTable, HasTheAsaeClasses) {
  const MaterialTable table = MaterialTable::Load("basic");
  EXPECT_DOUBLE_EQ(table.GetName("firm-soil").soil.cone_index, 1800e3);
  EXPECT_DOUBLE_EQ(table.GetName("medium-soil").soil.cone_index, 1200e3);
  EXPECT_DOUBLE_EQ(table.GetName("tilled-soil").soil.cone_index, 900e3);
  EXPECT_DOUBLE_EQ(table.GetName("soft-soil").soil.cone_index, 450e3);
  EXPECT_FALSE(table.GetName("water").passable);
  EXPECT_EQ(table.FindCode(table.GetName("paved").code)->name, "paved");
  EXPECT_EQ(table.FindCode(12345), nullptr);
}

TEST(MaterialTable, HasUscsSoilsByMoisture) {
  const MaterialTable table = MaterialTable::Load("uscs");
  // SM, w = 22 %: exp(8.749 - 1.1949 ln 22) = exp(8.749 - 3.6935) = 156.9 psi = 1081.7 kPa.
  EXPECT_NEAR(table.GetName("SM-moist").soil.cone_index, 1081.7e3, 200);
  // ML, w = 35 %: exp(10.225 - 1.565 * 3.55535) = exp(4.66088) = 105.73 psi = 729.0 kPa.
  EXPECT_NEAR(table.GetName("ML-wet").soil.cone_index, 729.0e3, 200);
  for (const Material& material : table.materials()) {
    EXPECT_LE(material.soil.cone_index, 300 * 6894.8) << material.name;
  }
  for (const char* soil : {"SM", "CL", "CH", "MH", "OL"}) {
    const std::string name = soil;
    EXPECT_LE(table.GetName(name + "-wet").soil.cone_index,
              table.GetName(name + "-moist").soil.cone_index);
  }
}

TEST(MaterialTable, NamesItsBuiltInTables) {
  EXPECT_THAT(MaterialTable::BuiltInNames(),
              ElementsAre("basic", "fbfm40", "forest-ponds", "nlcd", "nlcd-8", "plate-sinkage",
                          "uscs", "worldcover"));
  EXPECT_FALSE(MaterialTable::Load("forest-ponds").FindCode(3)->passable);
}

// Class codes of the products' legends; every row states where its numbers come from.
TEST(MaterialTable, HasTheCommonLandCoverSchemes) {
  EXPECT_EQ(MaterialTable::Load("worldcover").materials().size(), 11U);
  EXPECT_EQ(MaterialTable::Load("worldcover").FindCode(95)->name, "mangroves");
  EXPECT_EQ(MaterialTable::Load("nlcd").materials().size(), 20U);
  EXPECT_FALSE(MaterialTable::Load("nlcd").FindCode(11)->passable);
  // 5 non-burnable, 9 grass, 4 grass-shrub, 9 shrub, 5 understory, 9 litter, 4 slash.
  EXPECT_EQ(MaterialTable::Load("fbfm40").materials().size(), 45U);
  EXPECT_FALSE(MaterialTable::Load("fbfm40").FindCode(98)->passable);
  for (const std::string& name : MaterialTable::BuiltInNames()) {
    const MaterialTable table = MaterialTable::Load(name);
    for (const Material& material : table.materials()) {
      EXPECT_FALSE(material.source.empty()) << name << " " << material.name;
      EXPECT_GT(material.cone_index_spread, 0) << name << " " << material.name;
    }
  }
}

class MaterialTableFile : public testing::Test {
 protected:
  std::string Message(const std::string& materials) {
    const std::string file = directory_.Write(
        "m.json", R"({"schema": "dbd.materials/1", "materials": [)" + materials + "]}");
    return ErrorOf([&] { MaterialTable::Load(file); });
  }
  TemporaryDirectory directory_;
};

TEST_F(MaterialTableFile, FillsInDefaults) {
  const MaterialTable table = MaterialTable::Load(
      directory_.Write("mine.json", R"({"schema": "dbd.materials/1", "materials": [
        {"code": 7, "name": "loam", "cone_index_kpa": 700}]})"));
  EXPECT_EQ(table.name(), "mine");
  const Material& loam = table.GetName("loam");
  EXPECT_EQ(loam.code, 7);
  EXPECT_DOUBLE_EQ(loam.soil.cone_index, 700e3);
  EXPECT_DOUBLE_EQ(loam.soil.friction_limit, 0.88);
  EXPECT_DOUBLE_EQ(loam.cone_index_spread, 0.2);
  EXPECT_TRUE(loam.passable);
  EXPECT_EQ(loam.source, "assumed");
}

TEST_F(MaterialTableFile, RefusesWhatIsWrong) {
  EXPECT_THAT(Message(R"({"code": 1, "name": "a", "cone_index_kpa": 1, "frictionlimit": 1})"),
              HasSubstr("friction_limit"));
  EXPECT_THAT(Message(R"({"code": 1, "name": "a"})"),
              HasSubstr("materials[0].cone_index_kpa: is missing"));
  EXPECT_THAT(Message(R"({"code": 1, "name": "a", "cone_index_kpa": -5})"),
              HasSubstr("materials[0].cone_index_kpa: is -5"));
  EXPECT_THAT(Message(R"({"code": 1, "name": "a", "cone_index_kpa": 0})"), HasSubstr("above 0"));
  EXPECT_THAT(Message(R"({"code": 1.5, "name": "a", "cone_index_kpa": 5})"), HasSubstr("code"));
  EXPECT_THAT(Message(R"({"code": 1, "name": "a", "cone_index_kpa": 5},
                         {"code": 1, "name": "b", "cone_index_kpa": 5})"),
              HasSubstr("materials[1].code 1 is there twice"));
  EXPECT_THAT(Message(R"({"code": 1, "name": "a", "cone_index_kpa": 5},
                         {"code": 2, "name": "a", "cone_index_kpa": 5})"),
              HasSubstr("'a' is there twice"));
  EXPECT_THAT(Message(R"({"code": 1, "name": "a", "cone_index_kpa": 5, "passable": "no"})"),
              HasSubstr("true or false"));
  EXPECT_THAT(Message("{"), HasSubstr("not valid JSON"));
}

TEST(MaterialTable, IsWeakerWhenWetAndStrongerWhenDry) {
  const MaterialTable table = MaterialTable::Load("basic");
  const auto kilopascals = [&](MoistureState state, const char* name) {
    return table.InState(state).GetName(name).soil.cone_index / 1e3;
  };
  EXPECT_NEAR(kilopascals(MoistureState::kWet, "soft-soil"), 450 * 0.42403, 0.1);
  EXPECT_NEAR(kilopascals(MoistureState::kDry, "very-soft-soil"), 250 * 1.5190, 0.1);
  EXPECT_DOUBLE_EQ(kilopascals(MoistureState::kMoist, "soft-soil"), 450);
  EXPECT_NEAR(kilopascals(MoistureState::kDry, "firm-soil"), 2068.4, 0.1);  // 300 psi
  EXPECT_DOUBLE_EQ(kilopascals(MoistureState::kWet, "paved"), 10000);
}

TEST(MaterialTable, SaysWhenMoistureChangesNothing) {
  const MaterialTable table = MaterialTable::Load("nlcd");
  EXPECT_THAT(ErrorOf([&] { table.InState(MoistureState::kWet); }),
              HasSubstr("no material of the table 'nlcd' has a soil class"));
}

TEST_F(MaterialTableFile, ReadsTheSoilClass) {
  const MaterialTable table = MaterialTable::Load(
      directory_.Write("mine.json", R"({"schema": "dbd.materials/1", "materials": [
        {"code": 7, "name": "loam", "cone_index_kpa": 700, "uscs": "CL-ML"}]})"));
  EXPECT_EQ(table.GetName("loam").uscs, UscsClass::kCLML);
  EXPECT_THAT(Message(R"({"code": 1, "name": "a", "cone_index_kpa": 5, "uscs": "XY"})"),
              HasSubstr("materials[0].uscs: is \"XY\", must be SW,"));
  EXPECT_THAT(Message(R"({"code": 1, "name": "a", "cone_index_kpa": 5, "uscs": "CL", "plate": {
        "n": 1.1, "kc_kn": 1, "kphi_kn": 1500, "cohesion_kpa": 1, "friction_angle_deg": 28}})"),
              HasSubstr("materials[0].uscs: cannot be with \"plate\""));
}

TEST(MaterialTable, PlateConstantsGiveTheConeIndex) {
  const MaterialTable table = MaterialTable::Load("plate-sinkage");
  const Material& sand = table.GetName("lete-sand");
  EXPECT_EQ(sand.soil.traction_model, TractionModel::kBekker);
  EXPECT_DOUBLE_EQ(sand.soil.plate.kphi, 5301e3);
  EXPECT_NEAR(sand.soil.plate.friction_angle, 0.542797, 1e-6);  // 31.1 deg
  EXPECT_NEAR(sand.soil.cone_index, 2182.12e3, 10);
}

TEST_F(MaterialTableFile, ChoosesTheTractionModel) {
  const MaterialTable table = MaterialTable::Load(
      directory_.Write("mine.json", R"({"schema": "dbd.materials/1", "materials": [
        {"code": 1, "name": "a", "cone_index_kpa": 700},
        {"code": 2, "name": "b", "cone_index_kpa": 700, "traction_model": "wismer_luth"}]})"));
  EXPECT_EQ(table.GetName("a").soil.traction_model, TractionModel::kBrixius);
  EXPECT_EQ(table.GetName("b").soil.traction_model, TractionModel::kWismerLuth);
  EXPECT_THAT(Message(R"({"code": 1, "name": "a", "cone_index_kpa": 5, "traction_model": "x"})"),
              HasSubstr("must be brixius, wismer_luth or bekker"));
  EXPECT_THAT(Message(R"({"code": 1, "name": "a", "cone_index_kpa": 5,
                          "traction_model": "bekker"})"),
              HasSubstr("materials[0].plate: is missing"));
  EXPECT_THAT(Message(R"({"code": 1, "name": "a", "plate": {"n": 1, "kc_kn": -1}})"),
              HasSubstr("materials[0].plate.kc_kn: is -1"));
}

TEST_F(MaterialTableFile, RefusesOtherSchemasAndMissingFiles) {
  const std::string file = directory_.Write("m.json", R"({"schema": "other/1", "materials": []})");
  EXPECT_THAT(ErrorOf([&] { MaterialTable::Load(file); }), HasSubstr("dbd.materials/1"));
  EXPECT_THAT(ErrorOf([] { MaterialTable::Load("basik"); }), HasSubstr("built in are basic"));
}

}  // namespace
}  // namespace dbd
