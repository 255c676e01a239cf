#include <dbd/core/error.h>
#include <dbd/core/vehicle_cache.h>
#include <dbd/core/vehicle_database.h>
#include <gtest/gtest.h>

#include "support/temporary_directory.h"

namespace dbd {
namespace {

TEST(VehicleCache, EqualContentIsOneObject) {
  const TemporaryDirectory directory;
  const std::string text = BuiltInVehicleText("utility-4x4");
  VehicleCache cache;
  const auto vehicle = cache.Get("utility-4x4");
  EXPECT_EQ(cache.Get("utility-4x4"), vehicle);
  EXPECT_EQ(cache.Get(directory.Write("copy.json", text)), vehicle);
  EXPECT_NE(cache.Get("tomcar-tm27"), vehicle);
}

TEST(VehicleCache, AFileThatHasChangedIsReadAnew) {
  const TemporaryDirectory directory;
  VehicleCache cache;
  const std::string file = directory.Write("mine.json", BuiltInVehicleText("utility-4x4"));
  const auto before = cache.Get(file);
  directory.Write("mine.json", BuiltInVehicleText("tomcar-tm27"));
  EXPECT_NE(cache.Get(file)->name, before->name);
}

TEST(VehicleCache, RefusesWhatIsNoVehicle) {
  VehicleCache cache;
  EXPECT_THROW(cache.Get("moped"), InputError);
  EXPECT_THROW(cache.Get("/nonexistent.json"), InputError);
}

}  // namespace
}  // namespace dbd
