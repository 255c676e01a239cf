#include "output_directory.h"

#include <dbd/core/error.h>
#include <gmock/gmock.h>

#include <fstream>

#include "apps/temporary_directory.h"
#include "text.h"

namespace dbd {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> NamesIn(const fs::path& directory) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(directory)) {
    names.push_back(entry.path().filename().string());
  }
  return names;
}

TEST(OutputDirectory, ProbingLeavesNothingBehind) {
  const TemporaryDirectory scratch;
  { const OutputDirectory output(scratch / "a/b/out"); }
  EXPECT_THAT(NamesIn(scratch.path()), testing::IsEmpty());
}

TEST(OutputDirectory, FilesAppearTogetherOnCommit) {
  const TemporaryDirectory scratch;
  OutputDirectory output(scratch / "a/out/");
  WriteTextFile(output.Stage("map.png"), "1");
  WriteTextFile(output.Stage("plan.json"), "2");
  EXPECT_FALSE(fs::exists(scratch / "a/out"));
  output.Commit();
  EXPECT_THAT(NamesIn(scratch / "a/out"), testing::UnorderedElementsAre("map.png", "plan.json"));
  EXPECT_THAT(NamesIn(scratch / "a"), testing::ElementsAre("out"));
}

TEST(OutputDirectory, WithoutCommitNothingIsLeft) {
  const TemporaryDirectory scratch;
  {
    OutputDirectory output(scratch / "a/out");
    WriteTextFile(output.Stage("map.png"), "1");
  }
  EXPECT_THAT(NamesIn(scratch.path()), testing::IsEmpty());
}

TEST(OutputDirectory, AnOldAnswerIsNotMixedWithTheNewOne) {
  const TemporaryDirectory scratch;
  fs::create_directory(scratch / "out");
  WriteTextFile(scratch / "out/route.gpx", "old route");
  WriteTextFile(scratch / "out/plan.json", "old plan");
  WriteTextFile(scratch / "out/notes.txt", "the user's own");
  OutputDirectory output(scratch / "out");
  WriteTextFile(output.Stage("plan.json"), "no route");
  output.Commit();
  EXPECT_THAT(NamesIn(scratch / "out"), testing::UnorderedElementsAre("plan.json", "notes.txt"));
  std::ifstream plan(scratch / "out/plan.json");
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(plan), {}), "no route");
}

TEST(OutputDirectory, RefusesAFileAndAPlaceBelowAFile) {
  const TemporaryDirectory scratch;
  WriteTextFile(scratch / "file", "");
  for (const char* name : {"file", "file/out", "file/deeper/out"}) {
    try {
      const OutputDirectory output(scratch / name);
      FAIL() << name;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::StartsWith("--out " + (scratch / name) + ": "));
    }
  }
  EXPECT_THAT(NamesIn(scratch.path()), testing::ElementsAre("file"));
}

}  // namespace
}  // namespace dbd
