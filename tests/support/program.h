#pragma once

#include <gmock/gmock.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

#include "support/temporary_directory.h"

namespace dbd {

inline std::string ReadWhole(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// How a process ended.
struct Ending {
  int exit_code = -1;
  std::string output;
  std::string errors;
};

/// The built program as a process, with one small landscape that it generates itself for all tests.
class Program : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    scratch_ = new TemporaryDirectory;
    const Ending run =
        RunDbd("terrain generate --seed 3 --size 160 --relief-m 6 --out " + Land(""));
    ASSERT_EQ(run.exit_code, 0) << run.errors;
  }
  static void TearDownTestSuite() {
    delete scratch_;
    scratch_ = nullptr;
  }

  static std::string Land(const std::string& file) { return scratch_->File("land/" + file); }
  static std::string Scratch(const std::string& file) { return scratch_->File(file); }

  static Ending RunDbd(const std::string& arguments) {
    const std::string out = Scratch("stdout");
    const std::string err = Scratch("stderr");
    const std::string command =
        std::string(DBD_PROGRAM) + " " + arguments + " >" + out + " 2>" + err;
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, ReadWhole(out), ReadWhole(err)};
  }

  static std::string PlanCommand(const std::string& dem, const std::string& rest) {
    return "plan --dem " + dem + " --candidates 4 --out " + Scratch("out") + " " + rest;
  }

  static constexpr char kVehicle[] = "--vehicle tomcar-tm27 ";
  static constexpr char kEnds[] = "--start 500030,5200030 --goal 500060,5200030 ";

  /// Exit code 2, one line on standard error that holds `message`, nothing left behind.
  static void ExpectRefusal(const std::string& arguments, const std::string& message) {
    const Ending run = RunDbd(arguments);
    EXPECT_EQ(run.exit_code, 2) << arguments << "\n" << run.errors;
    EXPECT_THAT(run.errors, testing::StartsWith("dbd: "));
    EXPECT_THAT(run.errors, testing::HasSubstr(message));
    EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << run.errors;
    EXPECT_EQ(run.output, "");
    for (const auto& entry : std::filesystem::directory_iterator(scratch_->path())) {
      const std::string name = entry.path().filename().string();
      EXPECT_TRUE(name == "land" || name == "stdout" || name == "stderr" ||
                  name.starts_with("given"))
          << name;
    }
  }

  /// The built-in vehicle's file with one key changed.
  template <typename Change>
  static std::string ChangedVehicle(Change change) {
    nlohmann::json vehicle = nlohmann::json::parse(RunDbd("vehicle show tomcar-tm27").output);
    change(vehicle);
    const std::string file = Scratch("given.json");
    std::ofstream(file) << vehicle;
    return file;
  }

 private:
  static inline TemporaryDirectory* scratch_ = nullptr;
};

}  // namespace dbd
