#include <dbd/core/vehicle_database.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "support/core_vehicle.h"

namespace dbd {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

std::filesystem::path FreshDirectory(const std::string& name) {
  const auto directory = std::filesystem::path(::testing::TempDir()) / ("dbd_core_" + name);
  std::filesystem::remove_all(directory);
  std::filesystem::create_directories(directory);
  return directory;
}

TEST(VehicleDatabase, EveryBuiltInVehicleLoadsUnderItsFileName) {
  EXPECT_THAT(BuiltInVehicleNames(), Contains("tomcar-tm27"));
  for (const std::string& name : BuiltInVehicleNames()) {
    EXPECT_EQ(LoadVehicle(name)->name, name);
  }
}

TEST(VehicleDatabase, AVehicleFileEqualsTheBuiltInText) {
  const auto file = FreshDirectory("database") / "copy.json";
  std::ofstream(file) << BuiltInVehicleText("tomcar-tm27");
  const auto vehicle = LoadVehicle(file.string());
  EXPECT_EQ(vehicle->total_mass(), Tm27().total_mass());
  EXPECT_EQ(vehicle->links.size(), Tm27().links.size());
  std::filesystem::remove_all(file.parent_path());
}

TEST(VehicleDatabase, UnknownNameListsTheKnownOnes) {
  const std::string message = InputErrorOf([] { LoadVehicle("tm99"); });
  EXPECT_THAT(message, HasSubstr("vehicle \"tm99\" is not known"));
  EXPECT_THAT(message, HasSubstr("tomcar-tm27"));
  EXPECT_EQ(message.find('\n'), std::string::npos);
}

TEST(VehicleDatabase, MissingFileAndDirectoryAreNamed) {
  EXPECT_EQ(InputErrorOf([] { LoadVehicle("/nonexistent/v.json"); }),
            "/nonexistent/v.json: vehicle file cannot be opened");
  const auto directory = FreshDirectory("directory");
  EXPECT_EQ(InputErrorOf([&] { LoadVehicle(directory.string()); }),
            directory.string() + ": is a directory, must be a vehicle file");
  std::filesystem::remove_all(directory);
}

}  // namespace
}  // namespace dbd
